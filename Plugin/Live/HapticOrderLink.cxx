// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticOrderLink.h"

#include "HapticDataLink.h"
#include "HapticReport.h"
#include "vtkSMHapticDeviceProxy.h"

#include "vtkHapticDevice.h"
#include "vtkSMPropertyHelper.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace VolumeHapticsLive
{
HapticOrderLink::HapticOrderLink(vtkSMHapticDeviceProxy* proxy, vtkHapticDevice* device,
  HapticReport& report, std::function<bool()> canReachServer)
  : Proxy(proxy)
  , Device(device)
  , Report(report)
  , CanReachServer(std::move(canReachServer))
{
  this->DisarmObserver->SetClientData(this);
  this->DisarmObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<HapticOrderLink*>(self)->ApplyDisarm(); });
  // Observe after all others, because other observers may disarm the device for a clutch.
  device->AddObserver(vtkCommand::DisableEvent, this->DisarmObserver, -VTK_FLOAT_MAX);
}

void HapticOrderLink::Leave()
{
  this->Device->RemoveObserver(this->DisarmObserver);
}

void HapticOrderLink::ApplyDisarm()
{
  // Keep Armed while the device does not run, because it may be an order for the next start.
  if (this->Device->IsRunning() && !this->Device->IsArmOrdered())
  {
    this->Reset("Armed");
  }
}

int HapticOrderLink::GetInt(const char* name) const
{
  return vtkSMPropertyHelper(this->Proxy, name).GetAsInt();
}

void HapticOrderLink::Reset(const char* name)
{
  vtkSMPropertyHelper(this->Proxy, name).Set(0);
}

void HapticOrderLink::ApplyLimits()
{
  const double force = vtkSMPropertyHelper(this->Proxy, "MaximumForce").GetAsDouble();
  if (force != this->MaximumForce)
  {
    this->MaximumForce = force;
    force > 0.0 ? this->Device->SetMaximumForce(force) : this->Device->ResetMaximumForce();
  }
  this->Device->SetMaximumForceRate(
    vtkSMPropertyHelper(this->Proxy, "MaximumForceRate").GetAsDouble());
  this->Device->SetAttentionTime(vtkSMPropertyHelper(this->Proxy, "AttentionTime").GetAsDouble());
  this->Device->SetStiffnessGain(vtkSMPropertyHelper(this->Proxy, "StiffnessGain").GetAsDouble());
  this->Device->SetTransientGain(vtkSMPropertyHelper(this->Proxy, "TransientGain").GetAsDouble());
  this->Device->SetUseTool(this->GetInt("UseTool") != 0);
}

void HapticOrderLink::ApplyTip()
{
  std::array<double, 3> tip;
  vtkSMPropertyHelper(this->Proxy, "VirtualTip").Get(tip.data(), 3);
  if (tip != this->Tip && this->Device->GetVirtualHand()->MayMouseLead())
  {
    this->Tip = tip;
    this->Device->GetVirtualHand()->SetPosition(tip.data());
  }
}

void HapticOrderLink::Apply()
{
  if (!this->Device->IsRunning())
  {
    return;
  }
  if (!this->GetInt("Running"))
  {
    this->Stop("");
    return;
  }
  const bool arm = this->GetInt("Armed") != 0;
  const bool record = this->GetInt("Recording") != 0;
  if (!arm && this->Device->IsArmOrdered())
  {
    this->Device->Disarm();
  }
  this->ApplyLimits();
  this->ApplyTip();
  if (record != this->Recording.IsOn())
  {
    this->ApplyRecording(record);
  }
  if (!arm || this->Device->IsArmOrdered())
  {
    return;
  }
  if (this->CanReachServer())
  {
    this->Device->Arm();
  }
  if (!this->Device->IsArmOrdered()) // the device has refused the order
  {
    this->Reset("Armed");
  }
}

void HapticOrderLink::ApplyCuts()
{
  if (this->Device->IsArmOrdered() && (!this->GetInt("Armed") || !this->GetInt("Running")))
  {
    this->Device->Disarm();
  }
}

void HapticOrderLink::ApplyRecording(bool record)
{
  const char* const file = vtkSMPropertyHelper(this->Proxy, "RecordingFile").GetAsString();
  std::string error;
  record ? this->Recording.Start(file, HapticDataLink::IsLocal(this->Proxy), this->Device, error)
         : this->Recording.Stop(this->Device, error);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Proxy, << error);
  }
  if (record && !this->Recording.IsOn())
  {
    this->Reset("Recording");
  }
}

void HapticOrderLink::HandleFault(bool isServerLost)
{
  const int status = this->Device->GetStatus();
  const bool isFault = status == vtkHapticDevice::FAULT;
  if (isServerLost && this->Device->IsRunning() && (isFault || status <= vtkHapticDevice::READY))
  {
    this->Stop(this->Report.GetNotice()); // the force has already faded or was cut off
    return;
  }
  if (this->Device->IsArmOrdered() && (isFault || status < vtkHapticDevice::READY))
  {
    this->Device->Disarm(); // only the user may arm the device again
  }
}

void HapticOrderLink::ApplyRunning(vtkVolumeHapticsFilter* filter)
{
  const std::string id = vtkSMPropertyHelper(this->Proxy, "Device").GetAsString();
  if (this->Device->IsOpen() && this->Device->GetDeviceId() != id)
  {
    this->Proxy->Shutdown();
  }
  if (!this->GetInt("Running") || this->Device->IsRunning())
  {
    return;
  }
  this->Report.SetNotice("");
  if (filter && !filter->GetInputDataObject(0, 0) && this->Report.HasProblem())
  {
    // The device can't start, because the server has refused its volume and has reported the
    // reason.
    this->Stop("");
    this->Report.SetNotice(this->Report.GetProblem());
    return;
  }
  const auto text = [this](const char* name)
  { return std::string(vtkSMPropertyHelper(this->Proxy, name).GetAsString()); };
  this->Device->SetFirmwareFile(text("FirmwareFile").c_str());
  this->Device->SetHomingTime(vtkSMPropertyHelper(this->Proxy, "HomingTime").GetAsDouble());
  this->Device->SetUseGuard(vtkSMPropertyHelper(this->Proxy, "UseGuard").GetAsInt() != 0);
  double newtons[2];
  vtkSMPropertyHelper(this->Proxy, "NewtonsPerFullScale").Get(newtons, 2);
  this->Device->SetNewtonsPerFullScale(newtons);
  this->Device->SetServoRate(vtkSMPropertyHelper(this->Proxy, "ServoRate").GetAsDouble());
  this->Device->SetVolumeHaptics(filter);
  if (!this->Device->IsOpen() && this->Device->Open(id.c_str()))
  {
    this->Tip.fill(VTK_DOUBLE_MAX);
  }
  if (this->Device->IsOpen())
  {
    this->ApplyLimits();
    this->ApplyTip();
  }
  if (!this->Device->IsOpen() || !this->Device->Start())
  {
    this->Stop("");
  }
}

void HapticOrderLink::Publish(vtkVolumeHapticsFilter* filter)
{
  if (!this->Device->IsRunning())
  {
    return;
  }
  if (this->Device->GetVolumeHaptics() && !filter)
  {
    this->Stop("Stopped, since there is nothing left to touch: set Touch.");
    return;
  }
  if (!filter || !filter->GetInputDataObject(0, 0))
  {
    if (filter && !this->Report.HasProblem())
    {
      this->Report.SetProblem("There is no image to touch, so there is no force: give the filter "
                              "that Touch names an Input whose file is there, and arm again.");
    }
    if (this->Device->IsArmOrdered())
    {
      this->Device->FadeOut(); // otherwise the hand would feel the previous data
    }
    return;
  }
  this->Device->SetVolumeHaptics(filter);
  if (!this->Device->IsPublished()) // a view or Start() may already have published it
  {
    this->Device->Publish();
  }
}

void HapticOrderLink::Stop(const std::string& why)
{
  if (this->Device->IsRunning())
  {
    this->EndForce();
    this->Recording.Continue(this->Device);
    this->Device->Stop(); // also writes a recording
    this->Report.SetNotice(why);
  }
  std::string error;
  this->Recording.Close(this->Device, error);
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Proxy, << error);
  }
  for (const char* const name : Names)
  {
    if (this->Proxy->GetProperty(name))
    {
      this->Reset(name);
    }
  }
}

void HapticOrderLink::EndForce()
{
  this->Device->Disarm();
  // Wait until the force is zero, at most about 50 ms, so that a recording includes the ticks until
  // then.
  for (int i = 0; i < 50; ++i)
  {
    this->Device->UpdateState();
    const double* const force = this->Device->GetState()->GetForce();
    if (this->Device->GetStatus() <= vtkHapticDevice::READY &&
      std::all_of(force, force + 3, [](double f) { return f == 0.0; }))
    {
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

} // namespace VolumeHapticsLive
