// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticDeviceHolder.h"

#include "HapticSignals.h"
#include "HapticStateTable.h"
#include "ReplayDevice.h"
#include "vtkHapticDevice.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

const std::string ReplayPrefix = "replay:";

void Copy(const Vector3& from, double to[3])
{
  to[0] = from.X;
  to[1] = from.Y;
  to[2] = from.Z;
}

/** What is wrong, and what to do. */
const char* Explain(SafetyFault fault)
{
  switch (fault)
  {
    case SafetyFault::NotFinite:
      return "Force cut off: a force or a position was not a finite number. Check the image and "
             "the "
             "device, then Arm() again.";
    case SafetyFault::OverSpeed:
      return "Force cut off: the tip moved faster than a hand can hold the device. Take the "
             "stylus, then "
             "Arm() again.";
    case SafetyFault::DeviceLost:
      return "Force cut off: the device is gone. Plug it in, Open() and Start() it, then Arm() "
             "again.";
    case SafetyFault::None:
      break;
  }
  return "";
}

const char* Describe(ServoLoop::Privilege privilege)
{
  switch (privilege)
  {
    case ServoLoop::Privilege::Granted:
      return "granted";
    case ServoLoop::Privilege::Refused:
      return "refused (the loop may be late on a busy machine; raise the user's rtprio and memlock "
             "limits)";
    case ServoLoop::Privilege::Unknown:
      break;
  }
  return "not yet known";
}

} // namespace

bool HapticDeviceHolder::Open(const std::string& id, std::string& error)
{
  this->Close();
  if (id == "virtual")
  {
    auto device = std::make_unique<VirtualDevice>();
    this->Virtual = device.get();
    this->Backend = std::move(device);
  }
  else if (id.compare(0, ReplayPrefix.size(), ReplayPrefix) == 0)
  {
    if (!ReadTraceFile(id.substr(ReplayPrefix.size()), this->Replay, error))
    {
      return false;
    }
    this->Backend = std::make_unique<ReplayDevice>(this->Replay.Tips, id);
  }
  else
  {
    error = "There is no device \"" + id +
      "\". Give \"virtual\", \"replay:FILE\" or an id that EnumerateDevices() lists.";
    return false;
  }
  if (!this->Backend->Open(error))
  {
    this->Backend.reset();
    this->Virtual = nullptr;
    return false;
  }
  this->Id = id;
  return true;
}

void HapticDeviceHolder::Close()
{
  this->Stop();
  if (this->Backend)
  {
    this->Backend->Close();
    this->Backend.reset();
  }
  this->Virtual = nullptr;
  // Arming is for the device that is at hand, not for the next one.
  this->ArmWanted = false;
  this->Replay = {};
  this->Id.clear();
}

void HapticDeviceHolder::Start(double rate, const SafetyLimits& limits,
  std::shared_ptr<const HapticModel> model, const Affine3& deviceToWorld)
{
  if (!this->Virtual)
  {
    // A replay starts over, and where its tips are in the world, at the device's place of now.
    std::vector<Vector3> tips = this->Replay.Tips;
    if (!this->Replay.InDeviceSpace)
    {
      const Affine3 toDevice = Inverse(deviceToWorld);
      std::transform(tips.begin(), tips.end(), tips.begin(), toDevice);
    }
    this->Backend = std::make_unique<ReplayDevice>(std::move(tips), this->Id);
  }
  this->State = {};
  this->Rate = rate;
  this->Session = std::make_unique<HapticSession>(*this->Backend, rate, limits, std::move(model));
  GuardSession(this->Session.get());
  if (this->ArmWanted)
  {
    this->Session->GetLoop().Arm();
  }
}

void HapticDeviceHolder::Stop()
{
  if (this->Session)
  {
    ReleaseSession(this->Session.get());
    this->Session.reset();
    this->ArmWanted = false;
    this->State.Armed = false;
    this->State.Command = {};
    Copy({}, this->Force);
  }
}

void HapticDeviceHolder::Arm(bool on)
{
  this->ArmWanted = on;
  if (this->Session)
  {
    if (on)
    {
      GuardSession(this->Session.get());
    }
    on ? this->Session->GetLoop().Arm() : this->Session->GetLoop().Disarm();
  }
}

bool HapticDeviceHolder::Update(const Affine3& deviceToWorld)
{
  if (!this->Session)
  {
    return false;
  }
  ServoLoop& loop = this->Session->GetLoop();
  loop.Collect();
  if (!loop.ReadState())
  {
    return false;
  }
  this->State = loop.GetState();
  const HapticModel* const model = this->Session->FindModel(this->State.Generation);
  const Affine3 toWorld = model ? model->DeviceToWorld : deviceToWorld;
  const Matrix3 rotation = (1.0 / std::cbrt(Determinant(toWorld.Linear))) * toWorld.Linear;
  const TickRecord& record = this->State.Record;
  Copy(toWorld(record.Tip), this->Tip);
  Copy(toWorld(record.Proxy), this->Proxy);
  Copy(rotation * this->State.Command, this->Force);
  Copy(rotation * record.Force, this->ComputedForce);
  Copy(rotation * record.Normal, this->Normal);
  // Fig. 4: on both sides of where the proxy was when the tick began.
  const Vector3 start = this->State.Before.Enabled ? this->State.Before.Proxy : record.Tip;
  const Vector3 reach = (model ? model->KernelLength : 0.0) * record.Normal;
  Copy(toWorld(start + reach), this->SurfacePosition);
  Copy(toWorld(start - reach), this->MediumPosition);
  return true;
}

void HapticDeviceHolder::DrainStates(const Affine3& deviceToWorld, vtkTable* table)
{
  StateTable rows;
  if (this->Session)
  {
    for (const ServoSnapshot& state : this->Session->TakeStates())
    {
      const HapticModel* const model = this->Session->FindModel(state.Generation);
      rows.Append(state, model ? model->DeviceToWorld : deviceToWorld);
    }
  }
  rows.WriteTo(table);
}

int HapticDeviceHolder::GetStatus() const
{
  if (!this->Backend)
  {
    return vtkHapticDevice::CLOSED;
  }
  if (!this->Session)
  {
    return this->ArmWanted ? vtkHapticDevice::ARMED : vtkHapticDevice::READY;
  }
  if (this->State.Fault != SafetyFault::None)
  {
    return vtkHapticDevice::FAULT;
  }
  if (!this->State.Armed)
  {
    return this->ArmWanted ? vtkHapticDevice::ARMED : vtkHapticDevice::READY;
  }
  return this->State.Stale ? vtkHapticDevice::ARMED : vtkHapticDevice::ACTIVE;
}

std::string HapticDeviceHolder::GetStatusText() const
{
  switch (this->GetStatus())
  {
    case vtkHapticDevice::CLOSED:
      return "Closed. Open() a device.";
    case vtkHapticDevice::FAULT:
      return Explain(this->State.Fault);
    default:
      break;
  }
  if (!this->Session)
  {
    return "Ready: " + this->Id + ". Start() the servo.";
  }
  std::string text;
  if (this->State.Device == DeviceState::Lost)
  {
    text = "Lost: " + this->Id + " is gone. Plug it in, Open() and Start() it.";
  }
  else if (this->State.Device == DeviceState::Finished)
  {
    text = "Finished: " + this->Id + " has come to its end.";
  }
  else if (this->State.Armed && this->State.Stale)
  {
    text = "Armed, but " + this->Id + " gives no fresh positions: no force.";
  }
  else
  {
    text = this->State.Armed ? "Active: " + this->Id + "."
                             : "Running: " + this->Id + ". Arm() lets force through.";
  }
  ServoLoop& loop = this->Session->GetLoop();
  text += std::string(" Real-time priority ") + Describe(loop.GetRealTimePriority()) +
    ", locked memory " + Describe(loop.GetLockedMemory()) + ".";
  return text;
}

} // namespace VolumeHaptics
