// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Session/HapticDeviceHolder.h"

#include "Devices/Common/DeviceRegistry.h"
#include "Devices/Replay/ReplayDevice.h"
#include "VTK/Session/HapticSignals.h"
#include "VTK/Session/HapticStateTable.h"

#include <algorithm>
#include <utility>

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

} // namespace

bool HapticDeviceHolder::Open(
  const std::string& id, const DeviceOptions& options, std::string& error)
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
    this->IsReplay = true;
  }
  else
  {
    this->Backend = MakeDevice(id, options, error);
  }
  if (!this->Backend || !this->Backend->Open(error))
  {
    this->Backend.reset();
    this->Close();
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
  ++this->Opening;
  // Arming is for the device that is at hand, not for the next one.
  this->ArmsAtStart = false;
  this->IsReplay = false;
  this->Replay = {};
  this->Id.clear();
}

void HapticDeviceHolder::Start(double rate, const SafetyLimits& limits,
  std::shared_ptr<const HapticModel> model, const Affine3& deviceToWorld)
{
  if (this->IsReplay)
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
  auto session = std::make_unique<HapticSession>(*this->Backend, rate, limits, std::move(model));
  GuardSession(session.get());
  this->Session = std::move(session);
  if (this->FindLongWork())
  {
    this->Session->GetLoop().Hold();
  }
  if (std::exchange(this->ArmsAtStart, false))
  {
    this->Session->GetLoop().Arm();
  }
}

void HapticDeviceHolder::Stop()
{
  if (this->Session)
  {
    // A process that ends meanwhile still ends the force.
    this->Session->End();
    ReleaseSession(this->Session.get());
    this->Session.reset();
    this->State.Gate = GateState::Disarmed;
    this->State.Reason = GateReason::Ordered;
    this->State.Share = 0.0;
    this->State.Command = {};
    Copy({}, this->Force);
  }
}

void HapticDeviceHolder::Attend()
{
  if (this->Session)
  {
    this->Session->GetLoop().Attend();
  }
}

void HapticDeviceHolder::Arm(bool on)
{
  if (!this->Session)
  {
    this->ArmsAtStart = on;
    return;
  }
  if (on)
  {
    GuardSession(this->Session.get());
  }
  on ? this->Session->GetLoop().Arm() : this->Session->GetLoop().Disarm();
}

void HapticDeviceHolder::FadeOut()
{
  this->ArmsAtStart = false;
  if (this->Session)
  {
    this->Session->GetLoop().FadeOut();
  }
}

const HapticDeviceHolder::Work* HapticDeviceHolder::FindLongWork() const
{
  const auto found = std::find_if(
    this->Works.begin(), this->Works.end(), [](const Work& work) { return work.IsLong; });
  return found == this->Works.end() ? nullptr : &*found;
}

bool HapticDeviceHolder::BeginWork(const std::string& what, bool isLong)
{
  const bool isFirst = isLong && !this->FindLongWork();
  this->Works.push_back({ what, isLong });
  if (isFirst && this->Session)
  {
    this->Session->Hold();
  }
  return isFirst;
}

bool HapticDeviceHolder::EndWork()
{
  const bool wasLong = this->FindLongWork() != nullptr;
  this->Works.pop_back();
  const bool isLast = wasLong && !this->FindLongWork();
  if (isLast && this->Session)
  {
    this->Session->GetLoop().Release();
  }
  return isLast;
}

void HapticDeviceHolder::Home()
{
  if (this->Backend)
  {
    this->Arm(false);
    this->Backend->Home();
  }
}

bool HapticDeviceHolder::Update(const Affine3& deviceToWorld)
{
  if (!this->Session)
  {
    return false;
  }
  this->Attend();
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
  Copy(this->State.Turn, this->TurnRate);
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

void HapticDeviceHolder::DrainStates(const Affine3& deviceToWorld, vtkTable* table, int reader)
{
  if (!table)
  {
    this->Session ? this->Session->StopTaking(reader) : void();
    return;
  }
  StateTable rows;
  this->Attend();
  if (this->Session)
  {
    for (const StateRow& state : this->Session->TakeStates(reader))
    {
      const HapticModel* const model = this->Session->FindModel(state.Generation);
      rows.Append(state, model ? model->DeviceToWorld : deviceToWorld);
    }
  }
  rows.WriteTo(table);
}

} // namespace VolumeHaptics
