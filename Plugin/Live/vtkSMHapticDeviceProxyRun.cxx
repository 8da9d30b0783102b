// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkSMHapticDeviceProxy that makes the device do what the properties say.
#include "vtkSMHapticDeviceProxyInternals.h"

#include "vtkSMPropertyHelper.h"

namespace
{

/** Faults of before Arm stay visible for some ticks after it (s). */
constexpr double FaultAge = 0.05;

} // namespace

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TakeLimits()
{
  vtkHapticDevice* const device = this->Internals->Device;
  const double force = vtkSMPropertyHelper(this, "MaximumForce").GetAsDouble();
  double& taken = this->Internals->MaximumForce;
  if (force != taken)
  {
    taken = force;
    force > 0.0 ? device->SetMaximumForce(force) : device->ResetMaximumForce();
  }
  device->SetMaximumForceRate(vtkSMPropertyHelper(this, "MaximumForceRate").GetAsDouble());
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TakeTip()
{
  auto& d = *this->Internals;
  std::array<double, 3> tip;
  vtkSMPropertyHelper(this, "VirtualTip").Get(tip.data(), 3);
  if (tip != d.Tip && d.Device->GetDeviceId() == "virtual")
  {
    d.Tip = tip;
    d.Device->SetVirtualTip(tip.data());
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TakeOrders()
{
  auto& d = *this->Internals;
  if (!d.Device->IsRunning())
  {
    return;
  }
  const bool arm = this->GetInt("Armed") != 0;
  const bool record = this->GetInt("Recording") != 0;
  if (!this->GetInt("Running"))
  {
    this->StopHand("");
    return;
  }
  // Others, too, may have armed it: the property has the last word.
  const int status = d.Device->GetStatus();
  if (!arm && (d.IsArmed || status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE))
  {
    d.Device->Disarm();
    d.IsArmed = false;
  }
  this->TakeLimits();
  this->TakeTip();
  if (record != d.IsRecording)
  {
    this->TakeRecording();
  }
  if (arm && !d.IsArmed && this->CanReachServer())
  {
    d.Device->UpdateState();
    d.ArmedAt = d.Device->GetTime();
    d.Device->Arm();
    d.IsArmed = true;
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TakeCuts()
{
  auto& d = *this->Internals;
  if (d.Device->IsRunning() && (!this->GetInt("Armed") || !this->GetInt("Running")))
  {
    d.Device->Disarm();
    d.IsArmed = false;
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TakeRecording()
{
  auto& d = *this->Internals;
  const bool record = this->GetInt("Recording") != 0;
  const char* const file = vtkSMPropertyHelper(this, "RecordingFile").GetAsString();
  std::string error;
  if (!record)
  {
    d.Log.Continue(d.Device);
    d.Log.IsOpen() ? d.Log.Stop(d.Device, error) : d.Device->StopRecording();
    d.IsRecording = false;
  }
  else if (this->IsLocal())
  {
    d.IsRecording = d.Device->StartRecording(file);
  }
  else
  {
    d.IsRecording = d.Log.Start(file, d.Device, error);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
  if (record && !d.IsRecording)
  {
    this->Reset("Recording");
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::FollowFault()
{
  auto& d = *this->Internals;
  const bool isFault = d.Device->GetStatus() == vtkHapticDevice::FAULT;
  if (d.IsLost && d.Device->IsRunning() &&
    (isFault || d.Device->GetStatus() <= vtkHapticDevice::READY))
  {
    this->StopHand(d.Notice); // it has faded, or was cut off before
    return;
  }
  const bool isReady = d.Device->GetStatus() >= vtkHapticDevice::READY;
  if (d.IsArmed && (!isReady || (isFault && d.Device->GetTime() > d.ArmedAt + FaultAge)))
  {
    // Arming anew is for the user, who then sees a change of the property.
    d.IsArmed = false;
    this->Reset("Armed");
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::FollowRunning()
{
  auto& d = *this->Internals;
  vtkHapticDevice* const device = d.Device;
  const std::string id = vtkSMPropertyHelper(this, "Device").GetAsString();
  if (device->IsOpen() && device->GetDeviceId() != id)
  {
    this->Shutdown();
  }
  if (!this->GetInt("Running") || device->IsRunning())
  {
    return;
  }
  d.Notice.clear();
  vtkVolumeHapticsFilter* const filter = d.Touch.GetFilter();
  if (filter && !filter->GetInputDataObject(0, 0) && !d.Problem.empty())
  {
    // A server that refuses its volume gives nothing to start with, and has said why.
    this->StopHand("");
    d.Notice = d.Problem;
    return;
  }
  const auto text = [this](const char* name)
  { return std::string(vtkSMPropertyHelper(this, name).GetAsString()); };
  device->SetFirmwareFile(text("FirmwareFile").c_str());
  device->SetHomingTime(vtkSMPropertyHelper(this, "HomingTime").GetAsDouble());
  double newtons[2];
  vtkSMPropertyHelper(this, "NewtonsPerFullScale").Get(newtons, 2);
  device->SetNewtonsPerFullScale(newtons);
  device->SetServoRate(vtkSMPropertyHelper(this, "ServoRate").GetAsDouble());
  device->SetVolumeHaptics(filter);
  if (!device->IsOpen() && device->Open(id.c_str()))
  {
    d.Tip.fill(VTK_DOUBLE_MAX);
  }
  if (device->IsOpen())
  {
    this->TakeLimits();
    this->TakeTip();
  }
  if (!device->IsOpen() || !device->Start())
  {
    this->StopHand("");
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::Publish()
{
  auto& d = *this->Internals;
  vtkVolumeHapticsFilter* const filter = d.Touch.GetFilter();
  if (!d.Device->IsRunning())
  {
    return;
  }
  if (d.Device->GetVolumeHaptics() && !filter)
  {
    this->StopHand("Stopped, since there is nothing to touch any more: set Touch.");
    return;
  }
  vtkDataObject* const image = filter ? filter->GetInputDataObject(0, 0) : nullptr;
  if (!filter || !image)
  {
    if (filter && d.Problem.empty())
    {
      d.Problem = "There is no image to touch: give the filter that Touch names an Input.";
    }
    return;
  }
  d.Device->SetVolumeHaptics(filter);
  if (!d.Device->IsPublished()) // by a view, or by Start
  {
    d.Device->Publish();
  }
}
