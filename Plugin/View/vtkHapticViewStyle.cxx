// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticViewStyle.h"

#include "HapticSlices.h"
#include "HapticUndoExclusion.h"
#include "HapticVolumeFrames.h"
#include "vtkHapticDevice.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSMHapticDeviceProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMTrace.h"
#include "vtkVolumeHapticsFilter.h"

#include <string>

vtkStandardNewMacro(vtkHapticViewStyle);

//------------------------------------------------------------------------------
vtkHapticViewStyle::vtkHapticViewStyle()
  : Slices(std::make_unique<VolumeHaptics::HapticSlices>())
  , Frames(std::make_unique<VolumeHaptics::HapticVolumeFrames>())
{
  // No key compares settings: the properties of the filter Volume Haptics say what is felt, and
  // ParaView's undo and redo compare.
  this->SetKey("Compare", "");
  // This view has nothing to slice, to measure or to edit.
  for (const char* const action : { "Slices", "Point", "Distance", "Angle", "Path", "Area", "Undo",
         "Redo", "RemoveLast", "Measurements", "FunctionEditor", "NextFunction", "Propose",
         "DropProposal", "DockEditor", "ResetFunctions", "Labels" })
  {
    this->SetKey(action, "");
  }
  // ParaView's main window takes its own keys first; s, d, f, g and b begin a selection, which ends
  // the touch.
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
  // This renderer takes precedence over the renderer under the pointer.
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
  // A poll or a frame may close the view, and delete this.
  const vtkSmartPointer<vtkHapticViewStyle> self(this);
  if (this->DeviceProxy)
  {
    this->DeviceProxy->Poll();
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
    this->Slices->Follow(this->View->GetSession(), this->DeviceProxy->GetFilter(),
      device->GetState()->GetTipPosition());
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::SetArmed(bool on)
{
  if (this->DeviceProxy)
  {
    const VolumeHapticsLive::HapticUndoExclusion exclusion; // undo must not arm a device
    vtkSMPropertyHelper(this->DeviceProxy, "Armed").Set(on ? 1 : 0);
    this->DeviceProxy->UpdateVTKObjects();
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::OnKeyPress()
{
  const char* const symbol = this->Interactor->GetKeySym();
  const std::string key = symbol ? symbol : "";
  const auto isKeyOf = [&](const char* action)
  {
    return !key.empty() &&
      (" " + this->GetKey(action) + " ").find(" " + key + " ") != std::string::npos;
  };
  if (isKeyOf("Arm") && this->DeviceProxy)
  {
    const bool isArmed = vtkSMPropertyHelper(this->DeviceProxy, "Armed").GetAsInt() != 0;
    this->SetArmed(!isArmed && !this->GetClutch());
    this->DrawScene(true);
    return;
  }
  this->Superclass::OnKeyPress();
  if (isKeyOf("Touch") && (!this->GetTouchMode() || !this->GetClutch()))
  {
    this->SetArmed(this->GetTouchMode());
  }
  else if (isKeyOf("NextMethod"))
  {
    this->TellMethod();
  }
}

//------------------------------------------------------------------------------
void vtkHapticViewStyle::TellMethod()
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
  const int status = device ? device->GetStatus() : vtkHapticDevice::CLOSED;
  const bool isArmed = status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
  const bool isTouched = this->GetTouchMode() ||
    (device && device->GetPlayback()->HasFrames() && device->GetPlayback()->IsPlaying());
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
}
