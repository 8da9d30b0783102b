// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticViewLink.h"

#include "vtkHapticDevice.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticRepresentation.h"
#include "vtkHapticViewStyle.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkProcessModule.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkWeakPointer.h"

#include <cmath>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * The props of a touch in a view: the hand with its forces, and the head-up display.
 *
 * The constructor adds the props to a renderer, and the destructor removes them.
 */
class HapticViewProps
{
public:
  /** If the filter has an image, the size of the hand is adapted to it. */
  HapticViewProps(vtkRenderer* renderer, vtkHapticDevice* device, vtkVolumeHapticsFilter* filter);
  ~HapticViewProps();
  HapticViewProps(const HapticViewProps&) = delete;
  HapticViewProps& operator=(const HapticViewProps&) = delete;

  vtkHapticHeadUpDisplay* GetDisplay() { return this->Display; }
  /** Shows a device of the other hand; null for none. */
  void SetSecondDevice(vtkHapticDevice* device);

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkHapticRepresentation> Representation;
  vtkNew<vtkHapticRepresentation> SecondHand;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};

/// The proxy's radius, and the length of the arrow for 1 N, as fractions of the volume's diagonal.
constexpr double RadiusPart = 0.006;
constexpr double NewtonPart = 0.05;

/// Returns the notes of the reader of the touched volume's file; empty if the volume has another
/// source.
std::string FindNotes(vtkSMProxy* device)
{
  vtkSMProxy* const filter = vtkSMPropertyHelper(device, "Touch", true).GetAsProxy();
  vtkSMProxy* const source =
    filter ? vtkSMPropertyHelper(filter, "Input", true).GetAsProxy() : nullptr;
  vtkSMProperty* const notes = source ? source->GetProperty("Notes") : nullptr;
  if (!notes)
  {
    return {};
  }
  source->UpdatePropertyInformation(notes);
  const char* const text = vtkSMPropertyHelper(notes, true).GetAsString();
  return text ? text : "";
}

/// Returns the largest of 1, 2 or 5 times a power of ten that does not exceed a length.
double RoundLength(double length)
{
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double part = length / power;
  return power * (part < 2.0 ? 1.0 : part < 5.0 ? 2.0 : 5.0);
}

HapticViewProps::HapticViewProps(
  vtkRenderer* renderer, vtkHapticDevice* device, vtkVolumeHapticsFilter* filter)
  : Renderer(renderer)
{
  this->Representation->SetDevice(device);
  this->Display->SetDevice(device);
  renderer->AddViewProp(this->Representation);
  renderer->AddViewProp(this->Display);
  auto* const image = filter && filter->GetNumberOfInputConnections(0) > 0
    ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0))
    : nullptr;
  if (image && image->GetLength() > 0.0)
  {
    this->Representation->SetRadius(RadiusPart * image->GetLength());
    this->Representation->SetForceScale(1.0 / RoundLength(NewtonPart * image->GetLength()));
    const double unit = filter->GetMetersPerWorldUnit();
    this->Representation->SetWorldUnitName(unit == 0.001 ? "mm" : unit == 1.0 ? "m" : "units");
  }
}

void HapticViewProps::SetSecondDevice(vtkHapticDevice* device)
{
  this->SecondHand->SetDevice(device);
  this->SecondHand->SecondHandOn();
  this->SecondHand->SetRadius(this->Representation->GetRadius());
  this->SecondHand->SetForceScale(this->Representation->GetForceScale());
  this->SecondHand->SetWorldUnitName(this->Representation->GetWorldUnitName());
  this->Display->SetSecondDevice(device);
  this->Renderer->RemoveViewProp(this->SecondHand);
  if (device)
  {
    this->Renderer->AddViewProp(this->SecondHand);
  }
}

HapticViewProps::~HapticViewProps()
{
  this->Renderer->RemoveViewProp(this->SecondHand);
  this->Renderer->RemoveViewProp(this->Representation);
  this->Renderer->RemoveViewProp(this->Display);
}

} // namespace
} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticViewLink);

namespace
{
constexpr const char* ViewClosed = "The view was closed. Attach the device to another one.";
constexpr const char* DeviceDeleted =
  "The haptic device was deleted. Attach again with another one.";
} // namespace

struct vtkHapticViewLink::vtkInternals
{
  // Weak pointers, because ParaView or the user may delete these objects. Only the objects that
  // restore the view are kept alive.
  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkSMHapticDeviceProxy> DeviceProxy;
  vtkWeakPointer<vtkSMHapticDeviceProxy> SecondProxy;
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkHapticDevice> SecondDevice;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkSmartPointer<vtkInteractorObserver> StyleBefore;
  vtkSmartPointer<vtkHapticViewStyle> Style;
  // keeps the style alive while it ends the link
  vtkSmartPointer<vtkHapticViewStyle> LastStyle;
  std::unique_ptr<VolumeHaptics::HapticViewProps> Props;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> Observers;
  std::string Reason;
  std::string Notes; // last shown notes of the reader
};

//------------------------------------------------------------------------------
vtkHapticViewLink::vtkHapticViewLink()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkHapticViewLink::~vtkHapticViewLink()
{
  this->Detach();
}

//------------------------------------------------------------------------------
bool vtkHapticViewLink::Attach(vtkSMRenderViewProxy* view, vtkSMHapticDeviceProxy* device)
{
  auto& d = *this->Internals;
  if (!view || !device)
  {
    vtkErrorMacro(
      "Attaching takes a render view and a haptic device, and one of them is missing. Set View to "
      "a render view, such as GetActiveView(), and Device to a Haptic Device.");
    return false;
  }
  if (this->IsAttached() && d.View == view && d.DeviceProxy == device)
  {
    return true;
  }
  this->Detach();
  auto* const pvview = vtkPVRenderView::SafeDownCast(view->GetClientSideView());
  view->MakeRenderWindowInteractor(true);
  vtkRenderWindowInteractor* const interactor = view->GetInteractor();
  if (!pvview || !interactor)
  {
    vtkErrorMacro("This view has no interactor, as in pvbatch. Attach the device to a render "
                  "view of paraview or pvpython; a path can be felt anywhere.");
    return false;
  }
  if (vtkHapticViewStyle::SafeDownCast(interactor->GetInteractorStyle()))
  {
    vtkErrorMacro(
      "Another device is attached to this view. Detach that one first, or make this one "
      "its SecondDevice.");
    return false;
  }
  d.View = view;
  d.DeviceProxy = device;
  d.Device = device->GetDevice();
  d.Interactor = interactor;
  d.StyleBefore = interactor->GetInteractorStyle();
  d.Reason.clear();

  // The client alone draws this renderer, with both local and remote rendering.
  d.Props = std::make_unique<VolumeHaptics::HapticViewProps>(
    pvview->GetNonCompositedRenderer(), d.Device, device->GetFilter());
  d.Style = vtkSmartPointer<vtkHapticViewStyle>::New();
  d.Style->SetDevice(d.Device);
  d.Style->SetHeadUpDisplay(d.Props->GetDisplay());
  d.Style->SetDeviceProxy(device);
  this->ShowNotes();
  interactor->SetInteractorStyle(d.Style);
  d.Style->SetView(view);
  d.Style->SetSlicesFollowTip(this->SlicesFollowTip);
  this->Watch();
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::ShowNotes()
{
  auto& d = *this->Internals;
  const std::string notes = VolumeHaptics::FindNotes(d.DeviceProxy);
  if (notes != d.Notes)
  {
    d.Notes = notes;
    d.Props->GetDisplay()->SetNotice(notes.c_str());
  }
}

//------------------------------------------------------------------------------
bool vtkHapticViewLink::SetSecondDevice(vtkSMHapticDeviceProxy* device)
{
  auto& d = *this->Internals;
  if (device == d.SecondProxy && (device || !d.SecondDevice))
  {
    return true;
  }
  if (device && (!d.Style || device == d.DeviceProxy))
  {
    vtkErrorMacro(
      << (d.Style
             ? "The second device is the first one, which has one tip. Make another Haptic Device."
             : "There is no first hand in this view. Set Device and Attached before "
               "SecondDevice."));
    return false;
  }
  const vtkSmartPointer<vtkSMHapticDeviceProxy> before = d.SecondProxy.GetPointer();
  if (d.SecondDevice)
  {
    d.SecondDevice->Disarm(); // first, because the hand is no longer shown afterwards
  }
  d.SecondProxy = device;
  d.SecondDevice = device ? device->GetDevice() : nullptr;
  d.Style->SetSecondDevice(d.SecondDevice);
  d.Style->SetSecondDeviceProxy(device);
  d.Props->SetSecondDevice(d.SecondDevice);
  if (before)
  {
    vtkSMPropertyHelper(before, "Armed").Set(0);
    before->UpdateVTKObjects();
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
vtkSMHapticDeviceProxy* vtkHapticViewLink::GetSecondDeviceProxy() const
{
  return this->Internals->SecondProxy;
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::Watch()
{
  auto& d = *this->Internals;
  const auto watch = [this, &d](vtkObject* object, unsigned long event, auto method)
  {
    if (object)
    {
      d.Observers.emplace_back(object, object->AddObserver(event, this, method));
    }
  };
  watch(d.View, vtkCommand::DeleteEvent, &vtkHapticViewLink::OnEvent);
  watch(d.View, vtkCommand::UpdateDataEvent, &vtkHapticViewLink::OnEvent);
  watch(d.DeviceProxy, vtkCommand::DeleteEvent, &vtkHapticViewLink::OnEvent);
  watch(d.Style, vtkCommand::DisableEvent, &vtkHapticViewLink::OnEvent);
  watch(
    vtkSMProxyManager::GetProxyManager(), vtkCommand::UnRegisterEvent, &vtkHapticViewLink::OnEvent);
  watch(vtkProcessModule::GetProcessModule(), vtkCommand::ConnectionClosedEvent,
    &vtkHapticViewLink::OnEvent);
  watch(d.Style, vtkCommand::ModifiedEvent, &vtkHapticViewLink::OnEvent);
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::OnEvent(vtkObject* caller, unsigned long event, void* data)
{
  auto& d = *this->Internals;
  const auto* const info = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
  switch (event)
  {
    case vtkCommand::ModifiedEvent:
      this->Modified(); // a key may have changed the touch mode
      break;
    case vtkCommand::UpdateDataEvent:
      if (d.DeviceProxy)
      {
        this->ShowNotes(); // another file may have been read
      }
      break;
    case vtkCommand::DisableEvent:
      this->End("ParaView gave the view another way of interaction. Attach again when it is done.");
      break;
    case vtkCommand::UnRegisterEvent:
      if (info->Proxy && info->Proxy == d.View)
      {
        this->End(ViewClosed);
      }
      else if (info->Proxy && info->Proxy == d.DeviceProxy)
      {
        this->End(DeviceDeleted);
      }
      else if (info->Proxy && info->Proxy == d.SecondProxy)
      {
        this->SetSecondDevice(nullptr);
      }
      break;
    case vtkCommand::DeleteEvent:
      if (caller == d.DeviceProxy.GetPointer())
      {
        d.DeviceProxy = nullptr; // nothing may be sent through the proxy any more
        this->End(DeviceDeleted);
      }
      else
      {
        this->End(ViewClosed);
      }
      break;
    default:
      d.DeviceProxy = nullptr;
      d.SecondProxy = nullptr;
      d.Style->ForgetVolumes();
      this->End(ViewClosed); // the view was closed together with the connection
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::Detach()
{
  auto& d = *this->Internals;
  if (!d.Style)
  {
    return;
  }
  // Disarm first, because the hands are no longer shown afterwards.
  d.Device->Disarm();
  this->SetSecondDevice(nullptr);
  for (auto& [object, tag] : d.Observers)
  {
    if (object)
    {
      object->RemoveObserver(tag);
    }
  }
  d.Observers.clear();
  d.Props.reset();
  if (d.Interactor->GetInteractorStyle() == d.Style)
  {
    d.Interactor->SetInteractorStyle(d.StyleBefore);
  }
  d.Style->SetDevice(nullptr);
  d.Style->SetDeviceProxy(nullptr);
  d.Style->SetView(nullptr);
  const vtkSmartPointer<vtkSMHapticDeviceProxy> proxy = d.DeviceProxy.GetPointer();
  vtkInternals after;
  after.LastStyle = d.Style;
  after.Reason = d.Reason;
  d = std::move(after);
  if (proxy)
  {
    vtkSMPropertyHelper(proxy, "Armed").Set(0);
    proxy->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::End(const char* reason)
{
  const vtkSmartPointer<vtkHapticViewLink> self(this);
  this->Detach();
  this->Internals->Reason = reason;
  this->InvokeEvent(vtkCommand::EndEvent);
}

//------------------------------------------------------------------------------
bool vtkHapticViewLink::IsAttached() const
{
  return this->Internals->Style != nullptr;
}

//------------------------------------------------------------------------------
std::string vtkHapticViewLink::GetReason() const
{
  return this->Internals->Reason;
}

//------------------------------------------------------------------------------
vtkSMRenderViewProxy* vtkHapticViewLink::GetView() const
{
  return this->Internals->View;
}

//------------------------------------------------------------------------------
vtkSMHapticDeviceProxy* vtkHapticViewLink::GetDeviceProxy() const
{
  return this->Internals->DeviceProxy;
}

//------------------------------------------------------------------------------
vtkInteractorStyleHaptic* vtkHapticViewLink::GetStyle() const
{
  return this->Internals->Style;
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::SetTouchMode(bool on)
{
  auto& d = *this->Internals;
  if (!d.Style || on == d.Style->GetTouchMode())
  {
    return;
  }
  // If the user has pressed a button, the pointer is outside the view, so begin the touch at the
  // view's centre.
  const int* const size = d.Interactor->GetSize();
  d.Interactor->SetEventInformation(size[0] / 2, size[1] / 2);
  d.Style->SetTouchMode(on);
  d.Style->SetArmed(d.Style->GetTouchMode());
}

//------------------------------------------------------------------------------
std::string vtkHapticViewLink::GetKeys() const
{
  vtkHapticViewStyle* const style = this->Internals->Style;
  vtkStringArray* const actions = vtkInteractorStyleHaptic::GetKeyActions();
  std::string lines;
  for (vtkIdType i = 0; style && i < actions->GetNumberOfValues(); ++i)
  {
    const std::string action = actions->GetValue(i);
    const std::string keys = style->GetKey(action.c_str());
    lines += keys.empty() ? keys : action + "\t" + keys + "\n";
  }
  return lines;
}

//------------------------------------------------------------------------------
bool vtkHapticViewLink::GetTouchMode() const
{
  return this->Internals->Style && this->Internals->Style->GetTouchMode();
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::SetSlicesFollowTip(bool on)
{
  this->SlicesFollowTip = on;
  if (vtkHapticViewStyle* const style = this->Internals->Style)
  {
    style->SetSlicesFollowTip(on);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticViewLink::GetSlicesFollowTip() const
{
  return this->SlicesFollowTip;
}

//------------------------------------------------------------------------------
void vtkHapticViewLink::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->GetView() << "\n";
  os << indent << "DeviceProxy: " << this->GetDeviceProxy() << "\n";
  os << indent << "SecondDeviceProxy: " << this->GetSecondDeviceProxy() << "\n";
  os << indent << "Style: " << this->GetStyle() << "\n";
  os << indent << "SlicesFollowTip: " << (this->SlicesFollowTip ? "On" : "Off") << "\n";
  os << indent << "Reason: " << this->GetReason() << "\n";
}
