// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticXRController.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/Vibration.h"
#include "VTK/Experimental/HapticXRControllerSettings.h"
#include "VTK/Experimental/XRActions.h"
#include "VTK/Experimental/XRVibration.h"

#include "vtkCallbackCommand.h"
#include "vtkEventData.h"
#include "vtkHapticDevice.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderWindowInteractor3D.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHapticXRController);

using namespace VolumeHaptics;

namespace
{

constexpr int AmplitudeSteps = 255;

/** Reads a controller's pose from an event; false if a number is not finite. */
bool ReadPose(const vtkEventDataDevice3D& event, double reach, double tip[3], double wxyz[4])
{
  double direction[3];
  double turn[4]; // degrees, then the axis
  event.GetWorldPosition(tip);
  event.GetWorldDirection(direction);
  event.GetWorldOrientation(turn);
  vtkMath::Normalize(direction);
  vtkMath::Normalize(turn + 1);
  const double half = 0.5 * vtkMath::RadiansFromDegrees(turn[0]);
  wxyz[0] = std::cos(half);
  bool isFinite = std::isfinite(wxyz[0]);
  for (int i = 0; i < 3; ++i)
  {
    tip[i] += reach * direction[i];
    wxyz[i + 1] = std::sin(half) * turn[i + 1];
    isFinite = isFinite && std::isfinite(tip[i]) && std::isfinite(wxyz[i + 1]);
  }
  return isFinite;
}

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticXRController::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Observer;
  double Pending = 0.0; ///< largest amplitude since the last one that was sent
  std::int64_t SentAt = 0;
  bool WasRefused = false; ///< the refusal was reported
};

//------------------------------------------------------------------------------
vtkHapticXRController::vtkHapticXRController()
  : Internals(new vtkInternals)
{
  this->Internals->Observer->SetClientData(this);
  this->Internals->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
    { static_cast<vtkHapticXRController*>(self)->Follow(event, data); });
}

//------------------------------------------------------------------------------
vtkHapticXRController::~vtkHapticXRController()
{
  this->SetInteractor(nullptr);
}

//------------------------------------------------------------------------------
void vtkHapticXRController::SetDevice(vtkHapticDevice* device)
{
  if (this->Internals->Device != device)
  {
    this->Internals->Device = device;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticXRController::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
void vtkHapticXRController::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  auto& d = *this->Internals;
  if (d.Interactor == interactor)
  {
    return;
  }
  if (d.Interactor)
  {
    d.Pending = 0.0;
    this->Vibrate(0.0);
    d.Interactor->RemoveObserver(d.Observer);
  }
  d.Interactor = interactor;
  d.WasRefused = false;
  if (interactor)
  {
    for (const unsigned long event : { vtkCommand::Move3DEvent, vtkCommand::Select3DEvent,
           vtkCommand::Button3DEvent, vtkCommand::RenderEvent })
    {
      interactor->AddObserver(event, d.Observer);
    }
  }
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkHapticXRController::GetInteractor()
{
  return this->Internals->Interactor;
}

//------------------------------------------------------------------------------
bool vtkHapticXRController::WriteActions(const char* manifest, const char* folder)
{
  std::string error;
  if (!manifest || !folder)
  {
    error = "WriteActions() needs the file of a manifest and a folder, but got a null pointer.";
  }
  else if (BindVibration(manifest, this->ActionName, folder, error))
  {
    return true;
  }
  vtkErrorMacro(<< error);
  return false;
}

//------------------------------------------------------------------------------
bool vtkHapticXRController::CanVibrate()
{
  return VolumeHaptics::CanVibrate(this->Internals->Interactor);
}

//------------------------------------------------------------------------------
void vtkHapticXRController::Follow(unsigned long event, void* data)
{
  vtkHapticDevice* const device = this->Internals->Device;
  if (event == vtkCommand::RenderEvent)
  {
    this->FollowFrame();
    return;
  }
  auto* const any = static_cast<vtkEventData*>(data);
  vtkEventDataDevice3D* const pose = any ? any->GetAsEventDataDevice3D() : nullptr;
  const vtkEventDataDevice hand =
    this->Hand == RIGHT ? vtkEventDataDevice::RightController : vtkEventDataDevice::LeftController;
  const std::string id = device ? device->GetDeviceId() : std::string();
  if (!pose || pose->GetDevice() != hand || (id != "vibration:xr" && id != "virtual"))
  {
    return;
  }
  if (event != vtkCommand::Move3DEvent)
  {
    device->SetVirtualButtons(pose->GetAction() == vtkEventDataAction::Press ? 1 : 0);
    return;
  }
  auto* const room = vtkRenderWindowInteractor3D::SafeDownCast(this->Internals->Interactor);
  double tip[3];
  double wxyz[4];
  // A controller that is out of sight may have any pose.
  if (ReadPose(*pose, this->Reach * (room ? room->GetPhysicalScale() : 1.0), tip, wxyz))
  {
    device->SetVirtualTip(tip);
    device->SetVirtualTipOrientation(wxyz);
  }
}

//------------------------------------------------------------------------------
void vtkHapticXRController::FollowFrame()
{
  auto& d = *this->Internals;
  if (d.Device)
  {
    d.Device->UpdateState();
    d.Pending = std::max(d.Pending, d.Device->TakeVibration());
  }
  const int steps = Vibration::Quantize(d.Pending, AmplitudeSteps);
  const double amplitude = static_cast<double>(steps) / AmplitudeSteps;
  const bool isSame = amplitude == this->Amplitude;
  const bool isDue = Vibration::IsDue(isSame, steps == 0, ServoClock::SecondsSince(d.SentAt));
  // The amplitude of a frame that comes too early is kept.
  d.Pending = isSame || isDue ? 0.0 : d.Pending;
  if (isDue)
  {
    this->Vibrate(amplitude);
  }
}

//------------------------------------------------------------------------------
void vtkHapticXRController::Vibrate(double amplitude)
{
  auto& d = *this->Internals;
  const bool isNew = amplitude != this->Amplitude;
  this->Amplitude = amplitude;
  d.SentAt = ServoClock::Now();
  if (this->CanVibrate() && !d.WasRefused &&
    !ApplyVibration(
      d.Interactor, { this->ActionName, this->Hand, amplitude, Vibration::ReplayTime }))
  {
    d.WasRefused = true;
    vtkWarningMacro("The controller can't vibrate: the interactor refuses the action \""
      << this->ActionName
      << "\". Give the interactor the manifest that WriteActions() makes, then SetInteractor().");
  }
  if (isNew)
  {
    this->InvokeEvent(vtkCommand::UserEvent, &this->Amplitude);
  }
}

//------------------------------------------------------------------------------
void vtkHapticXRController::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << "\n";
  os << indent << "Interactor: " << this->GetInteractor() << "\n";
  PrintSettings(os, indent, this, XRControllerSettings);
  os << indent << "ActionName: " << this->ActionName << "\n";
  os << indent << "Amplitude: " << this->Amplitude << "\n";
}
