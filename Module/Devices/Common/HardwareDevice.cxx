// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/HardwareDevice.h"

#include "Core/Realtime/CrashGuard.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"

#include <exception>
#include <system_error>
#include <tuple>

namespace VolumeHaptics
{

namespace
{

constexpr std::int64_t LookPeriod = 500 * ServoClock::Millisecond;
constexpr std::int64_t LookPause = 10 * ServoClock::Millisecond;
/**
 * Number of attempts before an error is reported. The first attempts may fail because the system
 * grants access to a new device with a delay.
 */
constexpr int SilentAttempts = 10;

bool AreSame(const DeviceLimits& a, const DeviceLimits& b)
{
  const auto values = [](const DeviceLimits& limits)
  {
    // Name every member, so that this function no longer compiles when a member is added, until
    // that member is compared, too.
    const auto& [force, stiffness, damping, speed, own, radius, least, axes, moves, vibrates,
      torque, continuous] = limits;
    return std::make_tuple(force, stiffness, damping, speed, own, radius, least, axes, moves,
      vibrates, torque, continuous);
  };
  return values(a) == values(b);
}

} // namespace

DriverFacts::DriverFacts(const HardwareDriver& driver)
  : Name(driver.GetName())
  , Limits(driver.GetLimits())
  , Identity(driver.GetIdentity())
  , KeepsIdentity(driver.KeepsIdentity())
{
}

bool HardwareDriver::Return(
  const DriverFacts& before, const std::function<bool()>& mustStop, std::string& error)
{
  if (!this->Reconnect(before.Identity, mustStop, error))
  {
    return false;
  }
  const bool isSame =
    this->GetIdentity() == before.Identity && AreSame(this->GetLimits(), before.Limits);
  if (!isSame)
  {
    this->Disconnect();
    error = before.Name + " is back with other limits than before. Open() and Start() it.";
  }
  return isSame;
}

void HardwareDriver::ServeUntilStop(HardwareExchange& exchange)
{
  const DriverFacts before(*this);
  const std::function<bool()> mustStop = [&exchange]
  {
    // Quench() and Close() wait until this thread has requested the force and received zero.
    exchange.GetForce();
    return exchange.MustStop();
  };
  this->Serve(exchange);
  bool isConnected = true;
  int attempts = 0;
  while (!exchange.MustStop())
  {
    if (isConnected)
    {
      this->Disconnect();
      isConnected = false;
    }
    // Sleep, because the servo still wakes the exchange.
    const std::int64_t end = ServoClock::Now() + LookPeriod;
    while (ServoClock::Now() < end && !exchange.IsHomeRequested() && !mustStop())
    {
      ServoClock::SleepUntil(ServoClock::Now() + LookPause);
    }
    std::string error;
    isConnected = !exchange.MustStop() && this->Return(before, mustStop, error);
    if (isConnected)
    {
      attempts = 0;
      exchange.BeginAgain();
      this->Serve(exchange);
      continue;
    }
    const std::string text = error.empty() ? before.Name + " " + UnpluggedText : error;
    if (!error.empty() && ++attempts > SilentAttempts)
    {
      exchange.SetCondition(DeviceStage::Lost, text.c_str());
    }
    exchange.RefuseHomeRequest(text.c_str());
  }
}

HardwareDevice::HardwareDevice(std::unique_ptr<HardwareDriver> driver)
  : Driver(std::move(driver))
  , Facts(*this->Driver)
{
}

HardwareDevice::~HardwareDevice()
{
  this->Close();
  if (this->IsAbandoned)
  {
    // leaked, because its destructor would end the parent's connection
    static_cast<void>(this->Driver.release());
  }
}

bool HardwareDevice::Open(std::string& error)
{
  this->Close();
  if (this->IsAbandoned)
  {
    error = "The device is in use by the process that this one was forked from. Open() it before "
            "or after, not in both.";
    return false;
  }
  if (!this->Driver->Connect(error))
  {
    return false;
  }
  this->Facts = DriverFacts(*this->Driver);
  this->Exchange.Begin();
  try
  {
    this->Process = ServoClock::GetProcess();
    this->Priority = std::make_unique<ServoPriority>();
    this->Thread = std::thread([this] { this->Run(); });
  }
  catch (const std::system_error& e)
  {
    error = std::string("No thread could be started for the device: ") + e.what() + ".";
    this->Driver->Disconnect();
    return false;
  }
  this->SeekPriority();
  return true;
}

void HardwareDevice::SeekPriority()
{
  try
  {
    this->Request = std::thread(
      [this]
      {
        ServoClock::BlockSignals();
        this->Priority->AskRealtimeKit();
      });
  }
  catch (const std::system_error&) // the device also works without real-time priority
  {
  }
}

void HardwareDevice::Run()
{
  ServoClock::BlockSignals();
  this->Priority->Raise();
  const CrashGuard guard([](void* driver) noexcept
    { static_cast<HardwareDriver*>(driver)->SendLastZero(); },
    this->Driver.get());
  try
  {
    this->Driver->ServeUntilStop(this->Exchange);
  }
  catch (const std::exception& e)
  {
    // Memory may have run out, for example. Only the device's own watchdog can end the force now.
    this->Exchange.SetCondition(DeviceStage::Lost, e.what());
  }
}

void HardwareDevice::Close()
{
  if (this->Thread.joinable() && this->Process != ServoClock::GetProcess())
  {
    // The threads don't exist in the forked process, so they can be neither joined nor detached:
    // leak them.
    static_cast<void>(new std::thread(std::move(this->Thread)));
    static_cast<void>(new std::thread(std::move(this->Request)));
    this->IsAbandoned = true;
  }
  if (this->Thread.joinable())
  {
    this->Exchange.Quench();
    this->Exchange.RequestStop();
    this->Priority->RequestStop();
    this->Thread.join();
    if (this->Request.joinable())
    {
      this->Request.join();
    }
    this->Driver->Disconnect();
  }
}

} // namespace VolumeHaptics
