// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/HardwareExchange.h"

#include "Core/Platform/Wake.h"
#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{

/** Difference of the two clocks (ns) that shows that the computer was asleep. */
constexpr std::int64_t ShortestSleep = 50000000;

} // namespace

HardwareExchange::HardwareExchange(Clock asleep)
  : Asleep(asleep)
  , Wake(VolumeHaptics::Wake::Open())
{
}

HardwareExchange::~HardwareExchange()
{
  if (this->Wake >= 0)
  {
    VolumeHaptics::Wake::Close(this->Wake);
  }
}

void HardwareExchange::WakeUp() noexcept
{
  VolumeHaptics::Wake::Set(this->Wake);
}

void HardwareExchange::ClearWake() noexcept
{
  VolumeHaptics::Wake::Clear(this->Wake);
}

void HardwareExchange::WaitForWake(int time) noexcept
{
  VolumeHaptics::Wake::Wait(this->Wake, time);
}

std::int64_t HardwareExchange::GetTimeAsleep() noexcept
{
  return ServoClock::GetTimeAsleep();
}

void HardwareExchange::Begin() noexcept
{
  this->StopRequested.store(false);
  this->HomeRequested.store(false);
  this->Quenched.store(true);
  this->IsUnderWay = false;
  this->TimesReadySeen = this->TimesReady.load();
  this->TimeSeen = 0;
  this->Samples.Update();
  this->TakenForces.Write({ -1, 0 });
  this->Forces.Update();
  this->MeasureAsleep();
  this->ClearWake();
  this->SetHoming();
}

void HardwareExchange::MeasureAsleep() noexcept
{
  this->SleptBefore = this->ReadAsleep();
  for (int again = 0; again < 3; ++again)
  {
    this->SleptBefore = std::max(this->SleptBefore, this->ReadAsleep());
  }
}

void HardwareExchange::RequestStop() noexcept
{
  this->StopRequested.store(true, std::memory_order_release);
  this->WakeUp();
}

void HardwareExchange::SetHoming() noexcept
{
  this->Stage.store(DeviceStage::Homing, std::memory_order_release);
  this->SetCondition(DeviceStage::Homing, "");
}

void HardwareExchange::BeginAgain() noexcept
{
  this->MeasureAsleep();
  this->SetHoming();
  this->HomeRequested.store(false, std::memory_order_release);
}

bool HardwareExchange::DrainHomeRequest() noexcept
{
  const bool requested = this->IsHomeRequested();
  if (requested)
  {
    this->SetHoming();
    this->HomeRequested.store(false, std::memory_order_release);
  }
  return requested;
}

void HardwareExchange::RefuseHomeRequest(const char* text) noexcept
{
  if (this->IsHomeRequested())
  {
    this->SetCondition(DeviceStage::Lost, text);
    this->HomeRequested.store(false, std::memory_order_release);
  }
}

void HardwareExchange::RequestHome() noexcept
{
  this->HomeRequested.store(true);
  this->WakeUp();
}

DeviceCondition HardwareExchange::GetCondition() noexcept
{
  // Read the request before the condition, because the device's thread sets its own condition
  // before it resets the request.
  const bool willHome = this->HomeRequested.load(std::memory_order_acquire);
  this->Conditions.Update();
  DeviceCondition condition = this->Conditions.Read();
  if (willHome)
  {
    condition.Stage = DeviceStage::Homing;
    condition.Text = {};
  }
  return condition;
}

void HardwareExchange::SetCondition(DeviceStage stage, const char* text) noexcept
{
  if (stage != DeviceStage::Lost && this->Stage.load() == DeviceStage::Lost)
  {
    return;
  }
  DeviceCondition condition;
  condition.Stage = stage;
  std::snprintf(condition.Text.data(), condition.Text.size(), "%s", text);
  if (stage == DeviceStage::Ready && this->Stage.load() != DeviceStage::Ready)
  {
    // Count before setting the stage: a thread that reads Ready then also reads the new count, so
    // the servo notices a homing between two ticks.
    this->TimesReady.fetch_add(1, std::memory_order_release);
  }
  this->Stage.store(stage, std::memory_order_release);
  // Write the condition after the stage: when a caller reads "ready" and calls Arm(), the servo
  // then already sees a ready device.
  this->Conditions.Write(condition);
}

void HardwareExchange::SetCondition(DeviceStage stage, const char* name, const char* text) noexcept
{
  DeviceCondition condition;
  if (*text != '\0')
  {
    std::snprintf(condition.Text.data(), condition.Text.size(), "%s %s", name, text);
  }
  this->SetCondition(stage, condition.Text.data());
}

bool HardwareExchange::HasSlept() noexcept
{
  const std::int64_t slept = this->ReadAsleep();
  const bool has = slept - this->SleptBefore > ShortestSleep;
  // If this thread was delayed between reading the two clocks, it has measured too short a sleep.
  // Without the maximum, the rest would later count as another sleep.
  this->SleptBefore = std::max(this->SleptBefore, slept);
  if (has)
  {
    this->SetCondition(DeviceStage::Lost,
      "the computer was asleep, and the hand may have moved. Home() and Arm() again.");
  }
  return has;
}

DeviceState HardwareExchange::Receive(DeviceSample& sample) noexcept
{
  const DeviceStage stage = this->Stage.load(std::memory_order_acquire);
  if (stage != DeviceStage::Ready)
  {
    this->IsUnderWay = false;
    return stage == DeviceStage::Lost ? DeviceState::Lost : DeviceState::NotReady;
  }
  const std::uint32_t times = this->TimesReady.load(std::memory_order_acquire);
  const bool hasMissed = this->IsUnderWay && times != this->TimesReadySeen;
  this->TimesReadySeen = times;
  if (hasMissed)
  {
    // The device was homed between two ticks.
    this->IsUnderWay = false;
    return DeviceState::NotReady;
  }
  const bool isTold = this->Samples.Update();
  if (isTold || this->IsUnderWay)
  {
    // Without a new sample, buttons stay pressed and rotations continue.
    sample = this->Samples.Read();
    const bool isNew = isTold && (sample.Time != this->TimeSeen || !this->IsUnderWay);
    this->TimeSeen = sample.Time;
    sample.Fresh = isNew;
    sample.Alive = isTold;
    // A sample after a pause starts a new sequence, because homing may have moved the origin.
    sample.Begins = isNew && (sample.Begins || !this->IsUnderWay);
    this->IsUnderWay = true;
  }
  this->TakenForces.Update();
  sample.Taken = this->TakenForces.Read();
  return DeviceState::Running;
}

DeviceState HardwareExchange::Give(const Vector3& force, const Vector3& torque) noexcept
{
  this->Forces.Write({ force, torque, ServoClock::Now(), this->TimesReadySeen, this->TimeSeen });
  this->Quenched.store(false, std::memory_order_release);
  this->WakeUp();
  return this->Stage.load(std::memory_order_acquire) == DeviceStage::Lost ? DeviceState::Lost
                                                                          : DeviceState::Running;
}

void HardwareExchange::Report(const DeviceSample& sample) noexcept
{
  this->Told = sample;
  this->Told.Time = sample.Time == 0 ? ServoClock::Now() : sample.Time;
  this->Samples.Write(this->Told);
}

void HardwareExchange::RecordTaken() noexcept
{
  const std::int64_t of = this->Forces.Read().Of;
  if (of != 0)
  {
    this->TakenForces.Write({ of, ServoClock::Now() });
  }
}

void HardwareExchange::Quench() noexcept
{
  this->Quenched.store(true, std::memory_order_release);
  this->ZeroRounds.store(0, std::memory_order_release);
  this->WakeUp();
}

DeviceCommand HardwareExchange::GetCommand() noexcept
{
  this->Forces.Update();
  const TimedForce& latest = this->Forces.Read();
  const double age = ServoClock::SecondsSince(latest.Time) - WatchdogTime;
  const double share = std::clamp(1.0 - age / FadeTime, 0.0, 1.0);
  const DeviceCommand command{ share * latest.Force, share * latest.Torque };
  const int rounds = this->ZeroRounds.load(std::memory_order_acquire);
  // A force from before homing was computed for another position, so it must not be sent.
  const bool flows = IsFinite(command.Force) && IsFinite(command.Torque) &&
    Norm(command.Force) + Norm(command.Torque) > 0.0 &&
    latest.TimesReady == this->TimesReady.load(std::memory_order_acquire) &&
    !this->Quenched.load(std::memory_order_acquire) &&
    this->Stage.load(std::memory_order_acquire) == DeviceStage::Ready;
  this->ZeroRounds.store(flows ? 0 : std::min(rounds + 1, 2), std::memory_order_release);
  return flows ? command : DeviceCommand{};
}

} // namespace VolumeHaptics
