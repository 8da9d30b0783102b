// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/VibrationDriver.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/PadLimits.h"

#include <algorithm>
#include <exception>

namespace VolumeHaptics
{
namespace
{

constexpr int RoundPause = 2; // ms, while the servo sends nothing
constexpr int LostPause = 10; // ms

} // namespace

VibrationDriver::VibrationDriver(std::unique_ptr<VibrationService> service)
  : Service(std::move(service))
{
}

std::string VibrationDriver::GetName() const
{
  return this->Service->GetName() + ", vibration, not force";
}

DeviceLimits VibrationDriver::GetLimits() const
{
  return MakePadLimits();
}

bool VibrationDriver::Reconnect(const std::string& /*identity*/,
  const std::function<bool()>& /*mustStop*/, std::string& /*error*/)
{
  // A service that does not run yet is not an error.
  std::string ignored;
  return this->Service->Connect(ignored);
}

void VibrationDriver::Serve(HardwareExchange& exchange)
{
  /** Ends the vibration when leaving the scope, even by an exception. */
  struct AtEnd
  {
    VibrationService* Service;
    ~AtEnd()
    {
      try
      {
        this->Service->Show(0.0);
      }
      catch (const std::exception&)
      {
        // There is no memory for a message.
        this->Service->StopAtCrash();
      }
    }
  };
  const AtEnd atEnd{ this->Service.get() };
  this->Begin(exchange);
  while (!exchange.MustStop() && this->State != VibrationService::State::Gone)
  {
    this->IsLost = exchange.HasSlept() || this->IsLost;
    if (exchange.DrainHomeRequest())
    {
      this->Begin(exchange);
    }
    exchange.WaitForWake(this->IsLost ? LostPause : RoundPause);
    this->Round(exchange);
  }
}

void VibrationDriver::Begin(HardwareExchange& exchange)
{
  this->Levels.Silence();
  this->State = VibrationService::State::Waiting;
  this->IsLost = false;
  this->Told.clear();
  this->LastRound = ServoClock::Now();
  exchange.Report({});
}

void VibrationDriver::Round(HardwareExchange& exchange)
{
  // Quench() and Close() wait until this thread has requested the force and received zero.
  const Vector3 force = exchange.GetForce();
  const double elapsed = ServoClock::SecondsSince(this->LastRound);
  this->LastRound = ServoClock::Now();
  const VibrationLevels levels = this->Levels.Advance(force, elapsed);
  const VibrationService::State before = this->State;
  this->State = this->Service->Show(this->IsLost ? 0.0 : std::max(levels.Strong, levels.Weak));
  const std::string text =
    this->State == VibrationService::State::Ready ? "" : this->Service->GetText();
  if (this->State != before || text != this->Told)
  {
    const DeviceStage stage = this->State == VibrationService::State::Ready ? DeviceStage::Ready
      : this->State == VibrationService::State::Waiting                     ? DeviceStage::Homing
                                                                            : DeviceStage::Lost;
    exchange.SetCondition(stage, this->GetName().c_str(), text.c_str());
    this->Told = text;
  }
  exchange.Confirm();
  exchange.RecordTaken();
}

} // namespace VolumeHaptics
