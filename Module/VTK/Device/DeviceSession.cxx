// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/DeviceSession.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Kinds/DeviceRegistry.h"
#include "Devices/Replay/ReplayDevice.h"
#include "VTK/Device/HapticSignals.h"
#include "VTK/Device/Recording/TickCollector.h"
#include "VTK/Trace/TraceRow.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
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

void Copy(const Quaternion& from, double to[4])
{
  to[0] = from.W;
  to[1] = from.X;
  to[2] = from.Y;
  to[3] = from.Z;
}

} // namespace

bool DeviceSession::Open(const std::string& id, const DeviceOptions& options, std::string& error)
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
    this->Backend =
      std::make_unique<ReplayDevice>(this->Replay.Tips, id, this->Replay.Orientations);
    this->IsReplay = true;
  }
  else
  {
    this->Backend = MakeDevice(id, options, error);
    this->Xr = dynamic_cast<XrDevice*>(this->Backend.get());
    this->Virtual = dynamic_cast<VirtualDevice*>(this->Backend.get());
  }
  if (!this->Backend || !this->Backend->Open(error))
  {
    this->Backend.reset();
    this->Close();
    return false;
  }
  this->Id = id;
  this->Identity = this->Backend->GetIdentity();
  if (this->IsRemembered())
  {
    this->Facts = DeviceMemory::Read(this->Identity, this->MemoryTrouble);
    this->Backend->SetForceScale(this->Facts.Scale);
  }
  return true;
}

bool DeviceSession::NeedsConfirmation() const
{
  return this->HasFacts() && this->Facts.Confirmed.empty();
}

void DeviceSession::Remember()
{
  std::string error;
  if (this->IsRemembered() && !DeviceMemory::Write(this->Identity, this->Facts, error))
  {
    this->MemoryTrouble = error;
  }
}

void DeviceSession::RequireConfirmation()
{
  const DeviceLimits limits = this->Backend->GetLimits();
  this->Servo->GetLoop().RequireConfirmation(limits.ForceAxes, limits.MaximumForce);
}

void DeviceSession::ForgetConfirmation()
{
  if (this->HasFacts() && !this->Facts.Confirmed.empty())
  {
    this->Facts.Confirmed.clear();
    this->Remember();
  }
}

void DeviceSession::SetForceScale(double scale)
{
  if (this->HasFacts())
  {
    this->Backend->SetForceScale(scale);
    this->Facts.Scale = scale;
    this->Facts.Calibrated = DeviceMemory::GetToday();
    this->Remember();
  }
}

void DeviceSession::Close()
{
  this->Stop();
  if (this->Backend)
  {
    this->Backend->Close();
    this->Backend.reset();
  }
  this->Virtual = nullptr;
  this->Xr = nullptr;
  this->RoundTrip.Reset();
  this->Gain = 1.0;
  ++this->Opening;
  // The order to arm and the replay belong to this device, not to the next one.
  this->ArmsAtStart = false;
  this->IsReplay = false;
  this->Replay = {};
  this->Id.clear();
  this->Identity.clear();
  this->Facts = {};
}

void DeviceSession::TurnHand(const std::optional<Quaternion>& orientation)
{
  this->HandTurn = orientation;
  if (ServoLoop* const loop = this->GetLoop())
  {
    orientation ? loop->TurnHand(*orientation) : loop->ForgetTurn();
  }
}

void DeviceSession::Spin(bool on)
{
  this->Spinning = on;
  if (ServoLoop* const loop = this->GetLoop())
  {
    loop->Spin(on);
  }
}

void DeviceSession::Start(double rate, const SafetyLimits& limits,
  std::shared_ptr<const HapticModel> model, const Affine3& deviceToWorld)
{
  if (this->IsReplay)
  {
    // Start a replay from its beginning. Map tips in the world with the device's present placement.
    std::vector<Vector3> tips = this->Replay.Tips;
    std::vector<Quaternion> orientations = this->Replay.Orientations;
    if (!this->Replay.InDeviceSpace)
    {
      const Affine3 toDevice = Inverse(deviceToWorld);
      std::transform(tips.begin(), tips.end(), tips.begin(), toDevice);
      const Matrix3 turnToDevice = RotationOf(toDevice);
      std::transform(orientations.begin(), orientations.end(), orientations.begin(),
        [&](const Quaternion& q) { return TurnedBy(turnToDevice, q, true); });
    }
    this->Backend =
      std::make_unique<ReplayDevice>(std::move(tips), this->Id, std::move(orientations));
  }
  this->State = {};
  this->ShowNumbers();
  this->Rate = rate;
  auto servo = std::make_unique<ServoThreads>(*this->Backend, rate, limits, std::move(model));
  GuardServo(servo.get());
  this->Servo = std::move(servo);
  if (this->NeedsConfirmation())
  {
    this->RequireConfirmation();
  }
  if (this->FindLongWork())
  {
    this->Servo->GetLoop().Hold();
  }
  this->Servo->GetLoop().SetClutched(this->Clutched);
  this->TurnHand(std::optional<Quaternion>(this->HandTurn));
  this->Spin(this->Spinning);
  if (std::exchange(this->ArmsAtStart, false))
  {
    this->Servo->GetLoop().Arm();
  }
}

void DeviceSession::Stop()
{
  if (this->Servo)
  {
    // Keep the servo guarded until it has ended: if the process ends before that, the force is
    // switched off, too.
    this->Servo->End();
    ReleaseServo(this->Servo.get());
    this->Servo.reset();
    this->RegionStatus.clear();
    this->TimeStepsStatus.clear();
    this->State.Gate = GateState::Disarmed;
    this->State.Reason = GateReason::Ordered;
    this->State.Share = 0.0;
    this->State.Command = {};
    Copy(Vector3{}, this->Latest->Force);
  }
}

void DeviceSession::Attend()
{
  if (this->Servo)
  {
    this->Servo->GetLoop().Attend();
  }
}

void DeviceSession::Arm(bool on)
{
  if (!this->Servo)
  {
    this->ArmsAtStart = on;
    return;
  }
  if (on)
  {
    GuardServo(this->Servo.get());
  }
  on ? this->Servo->GetLoop().Arm() : this->Servo->GetLoop().Disarm();
}

void DeviceSession::FadeOut()
{
  this->ArmsAtStart = false;
  if (this->Servo)
  {
    this->Servo->GetLoop().FadeOut();
  }
}

void DeviceSession::SetClutched(bool on)
{
  if (this->Servo && !on && this->ReturnsAfterClutch())
  {
    GuardServo(this->Servo.get());
  }
  this->Clutched = on;
  if (this->Servo)
  {
    this->Servo->GetLoop().SetClutched(on);
  }
}

const DeviceSession::Work* DeviceSession::FindLongWork() const
{
  const auto found = std::find_if(
    this->Works.begin(), this->Works.end(), [](const Work& work) { return work.IsLong; });
  return found == this->Works.end() ? nullptr : &*found;
}

bool DeviceSession::BeginWork(const std::string& what, bool isLong)
{
  const bool isFirst = isLong && !this->FindLongWork();
  this->Works.push_back({ what, isLong });
  if (isFirst && this->Servo)
  {
    this->Servo->Hold();
  }
  return isFirst;
}

bool DeviceSession::EndWork()
{
  const bool wasLong = this->FindLongWork() != nullptr;
  this->Works.pop_back();
  const bool isLast = wasLong && !this->FindLongWork();
  if (isLast && this->Servo)
  {
    this->Servo->GetLoop().Release();
  }
  return isLast;
}

void DeviceSession::Home()
{
  if (this->Backend)
  {
    this->Arm(false);
    this->Backend->Home();
  }
}

bool DeviceSession::Update(const Affine3& deviceToWorld)
{
  if (!this->Servo)
  {
    return false;
  }
  this->Attend();
  ServoLoop& loop = this->Servo->GetLoop();
  loop.Collect();
  if (!loop.ReadState())
  {
    return false;
  }
  this->State = loop.GetState();
  if (this->State.Signs.Result == SignResult::Confirmed && this->NeedsConfirmation())
  {
    this->Facts.Confirmed = DeviceMemory::GetToday();
    this->Remember();
  }
  const HapticModel* const model = this->Servo->GetTicks().FindModel(this->State.Generation);
  const Affine3 toWorld = model ? model->DeviceToWorld : deviceToWorld;
  const Matrix3 rotation = RotationOf(toWorld);
  const TickRecord& record = this->State.Record;
  vtkHapticState& latest = *this->Latest;
  Copy(this->State.Turn, latest.TurnRate);
  const Quaternion q =
    this->State.HasOrientation ? TurnedBy(rotation, this->State.Orientation, true) : Quaternion{};
  Copy(q, latest.TipOrientation);
  Copy(toWorld(record.Tip), latest.TipPosition);
  Copy(toWorld(record.Proxy), latest.ProxyPosition);
  Copy(rotation * this->State.Command, latest.Force);
  Copy(rotation * record.Force, latest.ComputedForce);
  Copy(rotation * this->State.Torque, latest.Torque);
  Copy(rotation * record.Torque, latest.ComputedTorque);
  const bool hasShape = !IsIdentical(record.ToolOrientation, NoOrientation);
  const Quaternion tool = TurnedBy(rotation, record.ToolOrientation, hasShape);
  Copy(tool, latest.ToolOrientation);
  Copy(rotation * record.Normal, latest.Normal);
  // Compute the positions of fig. 4: x_s and x_v are on both sides of the proxy as it was at the
  // beginning of the tick.
  const Vector3 start = this->State.Before.Enabled ? this->State.Before.Proxy : record.Tip;
  const Vector3 reach = (model ? model->KernelLengthAlong(record.Normal) : 0.0) * record.Normal;
  Copy(toWorld(start + reach), latest.SurfacePosition);
  Copy(toWorld(start - reach), latest.MediumPosition);
  for (std::size_t mode = 0; mode < this->State.Modes.size(); ++mode)
  {
    Copy(rotation * this->State.Modes[mode], latest.ModeForces[mode]);
  }
  latest.Label = model ? GetTraceLabel(*model, record) : 0;
  latest.IsHeldAtLabel = model && IsHeldAtForbidden(*model, record);
  this->ShowNumbers();
  this->PollRoundTrip();
  return true;
}

void DeviceSession::ShowNumbers()
{
  vtkHapticState& latest = *this->Latest;
  const TickRecord& record = this->State.Record;
  latest.IsOriented = this->State.HasOrientation;
  latest.IsMeasured = this->State.HasOrientation && !this->State.IsOrdered;
  latest.Spins = this->State.Before.IsSpinning;
  latest.Buttons = static_cast<int>(this->State.Buttons);
  latest.Contact = static_cast<int>(record.Contact);
  latest.SurfaceValue = record.SurfaceValue;
  latest.NormalForce = record.NormalForce;
  latest.FrictionForce = record.FrictionForce;
  latest.DragForce = record.DragForce;
  // Tension of the spring at the beginning of the last tick. Only the solver PRECISE changes it
  // from 1.
  const double tension = this->State.Before.Precise.Spring.Tension;
  latest.Slack = record.Contact != ContactState::Free ? std::clamp(1.0 - tension, 0.0, 1.0) *
      std::sqrt(vtkMath::Distance2BetweenPoints(latest.TipPosition, latest.ProxyPosition))
                                                      : 0.0;
  latest.Residency = this->State.Residency;
  latest.Tick = static_cast<vtkIdType>(this->State.Tick);
  latest.Time = this->State.Time;
  latest.Modified();
}

ForceCaps DeviceSession::ComputeCaps(double rate) const
{
  const ForceCaps caps = CapsOf(this->GetLimits(), std::max(1.0 / rate, this->RoundTrip.Get()));
  return Augmented(caps, this->Gain);
}

ForceCaps DeviceSession::GetCaps() const
{
  const HapticModel* const model = this->Servo ? this->Servo->GetTicks().GetLatestModel() : nullptr;
  return model ? model->Caps : ForceCaps{};
}

void DeviceSession::PollRoundTrip()
{
  const double measured = this->Servo->GetLoop().GetTiming().GetRoundTrip();
  const bool isFelt = Norm(this->State.Record.Force) > 0.0;
  const double counted = measured > 0.0 ? std::max(measured, 1.0 / this->Rate) : 0.0;
  const bool isOther = this->RoundTrip.Update(counted, ServoClock::Now(), isFelt);
  // Raise the stiffness only when nothing is felt: it would add energy to a spring that the hand
  // presses.
  const double gain = this->RoundTrip.Get() > 0.0 ? this->WantedGain : 1.0;
  const bool isGainOther = gain < this->Gain || (gain > this->Gain && !isFelt);
  this->Gain = isGainOther ? gain : this->Gain;
  if (!isOther && !isGainOther)
  {
    return;
  }
  TickCollector& ticks = this->Servo->GetTicks();
  const HapticModel* const model = ticks.GetLatestModel();
  const ForceCaps caps = this->ComputeCaps(this->Rate);
  if (model && !(TighterCaps(model->Baked->Settings.Caps, caps) == model->Caps))
  {
    ticks.Publish(std::make_shared<const HapticModel>(*model, model->DeviceToWorld, caps));
  }
}

void DeviceSession::DrainStates(const Affine3& deviceToWorld, vtkTable* table, int reader)
{
  if (!table)
  {
    this->Servo ? this->Servo->GetTicks().StopTaking(reader) : void();
    return;
  }
  StateTable rows;
  this->Attend();
  if (this->Servo)
  {
    for (const StateRow& state : this->Servo->GetTicks().DrainStates(reader))
    {
      const HapticModel* const model = this->Servo->GetTicks().FindModel(state.Generation);
      rows.Append(state, model ? model->DeviceToWorld : deviceToWorld);
    }
  }
  rows.WriteTo(table);
}

int DeviceSession::AddReader()
{
  int reader = 0;
  while (!this->Readers.insert(reader).second)
  {
    --reader;
  }
  return reader;
}

void DeviceSession::RemoveReader(int reader)
{
  if (this->Readers.erase(reader) != 0 && this->Servo)
  {
    this->Servo->GetTicks().StopTaking(reader);
  }
}

void DeviceSession::SetBackgroundWork(const std::string& what, double share)
{
  if (share == WorkEnded)
  {
    this->BackgroundWorks.erase(what);
  }
  else
  {
    this->BackgroundWorks[what] = share;
  }
}

DeviceStatus DeviceSession::GetStatus() const
{
  DeviceStatus status;
  status.IsOpen = this->IsOpen();
  status.Id = this->Id;
  if (this->Backend)
  {
    status.Condition = this->Backend->GetCondition();
    status.Vibrates = this->Backend->GetLimits().Vibrates;
  }
  status.IsArmOrdered = this->IsArmOrdered();
  status.NeedsConfirmation = this->NeedsConfirmation();
  if (const Work* const work = this->FindLongWork())
  {
    status.LongWork = work->What;
  }
  for (const auto& [what, share] : this->BackgroundWorks)
  {
    constexpr double percent = 100.0;
    status.BackgroundWork += " Meanwhile " + what +
      (share == FractionUnknown
          ? "."
          : " (" + std::to_string(static_cast<int>(percent * share)) + " %).");
  }
  status.BackgroundWork += this->RegionStatus.empty() ? "" : " " + this->RegionStatus;
  status.BackgroundWork += this->TimeStepsStatus.empty() ? "" : " " + this->TimeStepsStatus;
  if (this->Servo)
  {
    status.State = &this->State;
    status.Orders = this->Servo->GetLoop().GetOrders();
    status.RealTimePriority = this->Servo->GetLoop().GetRealTimePriority();
    status.LockedMemory = this->Servo->GetLoop().GetLockedMemory();
    status.LockedSamples = this->Servo->GetLoop().GetLockedSamples();
    status.ReportPeriod = this->Servo->GetLoop().GetTiming().GetReportPeriod();
    status.RoundTrip = this->Servo->GetLoop().GetTiming().GetRoundTrip();
    status.Caps = this->GetCaps();
    status.RecordingTrouble = this->Servo->GetTicks().GetRecordingTrouble();
  }
  return status;
}

} // namespace VolumeHaptics
