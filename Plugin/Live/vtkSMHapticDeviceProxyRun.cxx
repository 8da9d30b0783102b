// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkSMHapticDeviceProxy that makes the device do what the properties say.
#include "vtkSMHapticDeviceProxyInternals.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPVSession.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"

#include <algorithm>
#include <cstring>

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
  if (force > 0.0 && force != device->GetMaximumForce())
  {
    device->SetMaximumForce(force);
  }
  device->SetMaximumForceRate(vtkSMPropertyHelper(this, "MaximumForceRate").GetAsDouble());
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::TakeTip()
{
  auto& d = *this->Internals;
  std::array<double, 3> tip;
  vtkSMPropertyHelper(this, "VirtualTip").Get(tip.data(), 3);
  if (tip != d.Tip)
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
  if (!arm && d.IsArmed)
  {
    d.Device->Disarm();
    d.IsArmed = false;
  }
  this->TakeLimits();
  this->TakeTip();
  if (record != d.IsRecording)
  {
    if (record)
    {
      d.IsRecording =
        d.Device->StartRecording(vtkSMPropertyHelper(this, "RecordingFile").GetAsString());
    }
    else
    {
      d.Device->StopRecording();
      d.IsRecording = false;
    }
    if (record != d.IsRecording)
    {
      this->Reset("Recording");
    }
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
void vtkSMHapticDeviceProxy::FollowFault()
{
  auto& d = *this->Internals;
  const bool isReady = d.Device->GetStatus() >= vtkHapticDevice::READY;
  const bool isFault = d.Device->GetStatus() == vtkHapticDevice::FAULT;
  if (d.IsArmed && (!isReady || (isFault && d.Device->GetTime() > d.ArmedAt + FaultAge)))
  {
    // Arming anew is for the user, who then sees a change of the property.
    d.IsArmed = false;
    this->Reset("Armed");
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticDeviceProxy::FollowData()
{
  auto& d = *this->Internals;
  d.Touch.Follow(vtkSMPropertyHelper(this, "Touch").GetAsProxy());
  vtkVolumeHapticsFilter* const filter = d.Touch.GetFilter();
  if (!filter)
  {
    return;
  }
  d.Errors.Catch(filter);
  unsigned int port = 0;
  vtkSMSourceProxy* const volume = d.Touch.GetInput("Input", port);
  d.Image.Follow(volume, port, filter, 0);
  unsigned int surfacePort = 0;
  d.Surface.Follow(d.Touch.GetInput("Surface", surfacePort), surfacePort, filter, 2);
  vtkVolumeProperty* const seen =
    this->GetInt("FollowOpacity") ? d.Opacity.Find(volume, filter) : nullptr;
  filter->GetProperty()->SetVisibilityFrom(d.Visibility ? d.Visibility.Get() : seen);
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
  const auto text = [this](const char* name)
  { return std::string(vtkSMPropertyHelper(this, name).GetAsString()); };
  device->SetFirmwareFile(text("FirmwareFile").c_str());
  device->SetHomingTime(vtkSMPropertyHelper(this, "HomingTime").GetAsDouble());
  double newtons[2];
  vtkSMPropertyHelper(this, "NewtonsPerFullScale").Get(newtons, 2);
  device->SetNewtonsPerFullScale(newtons);
  device->SetServoRate(vtkSMPropertyHelper(this, "ServoRate").GetAsDouble());
  device->SetVolumeHaptics(d.Touch.GetFilter());
  if (!device->IsOpen() && device->Open(id.c_str()))
  {
    d.Tip.fill(VTK_DOUBLE_MAX);
  }
  if (device->IsOpen())
  {
    this->TakeLimits();
    this->TakeTip();
  }
  d.PublishedTime = 0;
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
    d.Problem =
      filter ? "There is no image to touch: give the filter that Touch names an Input." : "";
    return;
  }
  vtkDataObject* const surface = filter->GetInputDataObject(2, 0);
  const vtkMTimeType time =
    std::max({ filter->GetMTime(), image->GetMTime(), surface ? surface->GetMTime() : 0 });
  if (time != d.PublishedTime || d.Device->GetVolumeHaptics() != filter)
  {
    d.PublishedTime = time;
    d.Device->SetVolumeHaptics(filter);
    d.Device->Publish();
  }
}
