// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticViewStyle.h"

#include "HapticUndoExclusion.h"
#include "HapticVolumeFrames.h"

#include "vtkCommand.h"
#include "vtkHapticDevice.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSession.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"
#include "vtkTimerLog.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Makes the slices of ParaView's Orthographic Slice Views follow the tip of a device.
 *
 * When the tip has moved, sets the property SlicePosition of all such views in a session, and draws
 * the views. This takes at most a fifth of the time, so that the view with the hand is not delayed.
 * While the tip is at rest, the user can move the slices.
 */
class HapticSlices
{
public:
  /**
   * Moves the slices to the tip. Must be called often. A tip outside the filter's image is replaced
   * by the nearest position in the image.
   */
  void Update(vtkSMSession* session, vtkVolumeHapticsFilter* filter, const double tip[3]);

private:
  double Last[3] = { 0.0, 0.0, 0.0 }; ///< last tip to which the slices were moved
  bool IsKnown = false;
  double NextTime = 0.0; ///< earliest time of the next move (s)
};

namespace
{

constexpr double ShortestPause = 0.05; // s: shortest pause between two moves
constexpr double PauseFraction = 4.0;  // pause as a multiple of the drawing time

/** Arms or disarms a device, as an order that can't be undone: "undo" must not arm a device. */
void OrderArmed(vtkSMProxy* device, bool on)
{
  if (device)
  {
    const VolumeHapticsLive::HapticUndoExclusion exclusion;
    vtkSMPropertyHelper(device, "Armed").Set(on ? 1 : 0);
    device->UpdateVTKObjects();
  }
}

bool IsArmOrdered(vtkSMProxy* device)
{
  return device && vtkSMPropertyHelper(device, "Armed").GetAsInt() != 0;
}

bool IsArmed(vtkHapticDevice* device)
{
  const int status = device ? device->GetStatus() : vtkHapticDevice::CLOSED;
  return status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
}

std::vector<vtkSMViewProxy*> CollectSliceViews(vtkSMSession* session)
{
  std::vector<vtkSMViewProxy*> views;
  vtkNew<vtkSMProxyIterator> proxies;
  proxies->SetSession(session);
  proxies->SetModeToOneGroup();
  for (proxies->Begin("views"); !proxies->IsAtEnd(); proxies->Next())
  {
    auto* const view = vtkSMViewProxy::SafeDownCast(proxies->GetProxy());
    if (view && std::strcmp(view->GetXMLName(), "OrthographicSliceView") == 0)
    {
      views.push_back(view);
    }
  }
  return views;
}

} // namespace

void HapticSlices::Update(
  vtkSMSession* session, vtkVolumeHapticsFilter* filter, const double tip[3])
{
  const double now = vtkTimerLog::GetUniversalTime();
  if (std::equal(tip, tip + 3, this->Last) || now < this->NextTime)
  {
    return;
  }
  const bool isFirst = !this->IsKnown;
  std::copy(tip, tip + 3, this->Last);
  this->IsKnown = true;
  if (isFirst)
  {
    return; // the first position of a device is not a motion
  }
  double position[3];
  std::copy(tip, tip + 3, position);
  if (vtkImageData* const image = filter ? filter->GetTouchedImage() : nullptr)
  {
    const double* const bounds = image->GetBounds();
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = std::min(std::max(position[axis], bounds[2 * axis]), bounds[2 * axis + 1]);
    }
  }
  for (vtkSMViewProxy* const view : CollectSliceViews(session))
  {
    vtkSMPropertyHelper(view, "SlicePosition").Set(position, 3);
    view->UpdateVTKObjects();
    if (vtkSMPropertyHelper(view, "EnableRenderOnInteraction", true).GetAsInt() == 1)
    {
      view->StillRender();
    }
  }
  const double end = vtkTimerLog::GetUniversalTime();
  this->NextTime = end + std::max(ShortestPause, PauseFraction * (end - now));
}

} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticViewStyle);

using namespace VolumeHaptics;

//------------------------------------------------------------------------------
vtkHapticViewStyle::vtkHapticViewStyle()
  : Slices(std::make_unique<VolumeHaptics::HapticSlices>())
  , Frames(std::make_unique<VolumeHaptics::HapticVolumeFrames>())
{
  // Remove the key that compares settings: the properties of the filter Volume Haptics define the
  // settings, and ParaView's undo and redo can compare them.
  this->SetKey("Compare", "");
  // Remove the keys of these actions, because this view has nothing to slice, to measure or to
  // edit.
  for (const char* const action : { "Slices", "Point", "Distance", "Angle", "Path", "Area", "Undo",
         "Redo", "RemoveLast", "Measurements", "FunctionEditor", "NextFunction", "Propose",
         "DropProposal", "DockEditor", "ResetFunctions", "Labels" })
  {
    this->SetKey(action, "");
  }
  // Avoid keys that ParaView's main window uses itself: s, d, f, g and b begin a selection, which
  // ends the touch.
  this->SetKey("Help", "question");
  this->SetKey("Graph", "G");
  this->SetKey("Details", "D");
  this->SetKey("AtTheEnd", "B");
  this->SetKey("LargerWorkspace", "greater");
  this->SetKey("SmallerWorkspace", "less");
}

//------------------------------------------------------------------------------
vtkHapticViewStyle::~vtkHapticViewStyle() = default;

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetView(vtkSMRenderViewProxy* view)
{
  this->View = view;
  this->Frames->SetView(view);
  // Always pick in this renderer, whichever renderer is under the pointer.
  vtkRenderer* const renderer = view ? view->GetRenderer() : nullptr;
  this->SetDefaultRenderer(renderer);
  this->SetCurrentRenderer(renderer);
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::ForgetVolumes()
{
  this->Frames->Forget();
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetPointerQuery(void (*query)(int position[2]))
{
  VolumeHaptics::HapticVolumeFrames::SetPointerQuery(query);
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetDeviceProxy(vtkSMHapticDeviceProxy* device)
{
  this->DeviceProxy = device;
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetSecondDeviceProxy(vtkSMHapticDeviceProxy* device)
{
  this->SecondProxy = device;
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Superclass::SetInteractor(interactor);
  if (!interactor)
  {
    this->InvokeEvent(vtkCommand::DisableEvent);
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::OnTimer()
{
  if (this->IsBusy)
  {
    return;
  }
  this->IsBusy = true;
  // Keep this object alive, because a poll or a frame may close the view and delete it.
  const vtkSmartPointer<vtkHapticViewStyle> self(this);
  for (const auto& proxy : { this->DeviceProxy, this->SecondProxy })
  {
    if (proxy)
    {
      proxy->Poll();
    }
  }
  if (this->Interactor)
  {
    this->Superclass::OnTimer();
    this->MoveSlices();
  }
  this->IsBusy = false;
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::MoveSlices()
{
  vtkHapticDevice* const device = this->GetDevice();
  if (this->SlicesFollowTip && this->View && this->DeviceProxy && device && device->IsRunning())
  {
    const VolumeHapticsLive::HapticUndoExclusion exclusion;
    this->Slices->Update(this->View->GetSession(), this->DeviceProxy->GetFilter(),
      device->GetState()->GetTipPosition());
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetArmed(bool on)
{
  OrderArmed(this->DeviceProxy, on);
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::ToggleArmed()
{
  const bool isSecond = this->SecondProxy && this->SecondProxy->GetDevice()->IsRunning();
  const bool isArmed =
    IsArmOrdered(this->DeviceProxy) && (!isSecond || IsArmOrdered(this->SecondProxy));
  const bool on = !isArmed && !this->GetClutch();
  this->SetArmed(on);
  if (isSecond)
  {
    OrderArmed(this->SecondProxy, on);
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::OnKeyPress()
{
  // Query the actions before the key press changes the touch mode, which changes the actions of
  // keys with Ctrl.
  const bool isTouch = this->IsPressOf("Touch");
  const bool isMethod = this->IsPressOf("NextMethod");
  if (this->IsPressOf("Arm") && this->DeviceProxy)
  {
    this->ToggleArmed();
    this->DrawScene(true);
    return;
  }
  this->Superclass::OnKeyPress();
  if (isTouch && (!this->GetTouchMode() || !this->GetClutch()))
  {
    this->SetArmed(this->GetTouchMode());
  }
  else if (isMethod)
  {
    this->ReportMethod();
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::ReportMethod()
{
  vtkSMProxy* const touch =
    this->DeviceProxy ? vtkSMPropertyHelper(this->DeviceProxy, "Touch").GetAsProxy() : nullptr;
  vtkVolumeHapticsFilter* const filter =
    this->DeviceProxy ? this->DeviceProxy->GetFilter() : nullptr;
  if (touch && filter)
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", touch);
    vtkSMPropertyHelper(touch, "Method").Set(filter->GetMethod());
    vtkSMPropertyHelper(touch, "Solver").Set(filter->GetSolver());
    touch->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::OnChar()
{
  if (this->View && this->Interactor && this->Interactor->GetKeyCode() == 'r')
  {
    this->View->ResetCamera();
    this->DrawScene(false);
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::DrawScene(bool quickly)
{
  if (!this->View ||
    vtkSMPropertyHelper(this->View, "EnableRenderOnInteraction", true).GetAsInt() != 1)
  {
    return;
  }
  using Touch = VolumeHaptics::HapticVolumeFrames::Touch;
  vtkHapticDevice* const device = this->GetDevice();
  const bool isArmed = IsArmed(device) || IsArmed(this->GetSecondDevice());
  const bool isTouched = this->GetTouchMode() ||
    (device && device->GetPlayback()->HasTimeSteps() && device->GetPlayback()->IsPlaying());
  this->Frames->Draw(quickly,
    !this->GetAutoAdjustVolumeQuality() ? Touch::Off
      : isArmed                         ? Touch::Armed
      : isTouched                       ? Touch::On
                                        : Touch::Off);
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View.GetPointer() << "\n";
  os << indent << "SlicesFollowTip: " << (this->SlicesFollowTip ? "On" : "Off") << "\n";
  os << indent << "DeviceProxy: " << this->DeviceProxy.GetPointer() << "\n";
  os << indent << "SecondProxy: " << this->SecondProxy.GetPointer() << "\n";
}
