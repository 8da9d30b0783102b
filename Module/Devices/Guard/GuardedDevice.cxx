// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Guard/GuardedDevice.h"

#include "Core/Realtime/ServoClock.h"

#include <cstdio>
#include <exception>
#include <system_error>

namespace VolumeHaptics
{
namespace
{

constexpr int LookTime = 20; // ms
constexpr int RescueAttempts = 50;
/**
 * Longest time until zero has been sent and the device is closed. This normally takes at most a
 * second, even if the device does not answer.
 */
constexpr std::int64_t EndTime = 5000 * ServoClock::Millisecond;

} // namespace

std::unique_ptr<GuardedDevice> GuardedDevice::Make(
  std::unique_ptr<HardwareDriver> driver, std::vector<std::string> words, std::string& error)
{
  std::unique_ptr<GuardedDevice> device(new GuardedDevice(std::move(driver), std::move(words)));
  return device->Memory->Renew(error) ? std::move(device) : nullptr;
}

GuardedDevice::GuardedDevice(std::unique_ptr<HardwareDriver> driver, std::vector<std::string> words)
  : Driver(std::move(driver))
  , Facts(*this->Driver)
  , Words(std::move(words))
  , Memory(std::make_unique<GuardMemory>())
{
}

GuardedDevice::~GuardedDevice()
{
  this->Close();
}

bool GuardedDevice::IsForked() const noexcept
{
  return this->Process != 0 && this->Process != ServoClock::GetProcess();
}

bool GuardedDevice::Open(std::string& error)
{
  this->Close();
  if (this->IsAbandoned)
  {
    error = "The device is in use by the process that this one was forked from. Open() it before "
            "or after, not in both.";
    return false;
  }
  if (!this->Memory->Renew(error))
  {
    return false;
  }
  this->GetExchange().Begin();
  if (!this->Guard.Start(*this->Memory, this->Words, this->Facts, error))
  {
    return false;
  }
  this->HasDevice.store(Side::Guard);
  this->IsClosing.store(false);
  this->Process = ServoClock::GetProcess();
  try
  {
    this->Watcher = std::thread([this] { this->Watch(); });
  }
  catch (const std::system_error& e)
  {
    error = std::string("No thread could be started for the device: ") + e.what() + ".";
    this->GetExchange().RequestStop();
    this->Guard.HasEnded(static_cast<int>(EndTime / ServoClock::Millisecond));
    std::string ignored;
    this->Guard.End(ignored);
    this->Process = 0;
    return false;
  }
  return true;
}

void GuardedDevice::Watch()
{
  ServoClock::BlockSignals();
  std::int64_t end = 0;
  while (!this->Guard.HasEnded(LookTime) && !this->Guard.HasStopped() &&
    (end == 0 || ServoClock::Now() < end))
  {
    end = end == 0 && this->IsClosing.load() ? ServoClock::Now() + EndTime : end;
  }
  std::string how;
  const bool hasEndedByItself = this->Guard.End(how);
  if (hasEndedByItself && this->IsClosing.load())
  {
    return;
  }
  this->EndedCondition = this->GetExchange().GetCondition();
  if (!hasEndedByItself || this->EndedCondition.Stage != DeviceStage::Lost)
  {
    // The guard has ended without reporting a reason.
    this->EndedCondition.Stage = DeviceStage::Lost;
    std::snprintf(this->EndedCondition.Text.data(), this->EndedCondition.Text.size(),
      "The guard process, which talks to the device, %s. Zero force was sent in its place, if that "
      "was possible: watch the device. Close(), Open(), Start() and Arm() it again.",
      how.c_str());
  }
  this->HasDevice.store(Side::Rescue, std::memory_order_release);
  this->Rescue();
  this->HasDevice.store(Side::None, std::memory_order_release);
}

void GuardedDevice::Rescue() noexcept
{
  try
  {
    std::string ignored;
    bool isDone = false;
    // The system may need a moment before another process can claim the device.
    for (int attempt = 0; attempt < RescueAttempts && !isDone; ++attempt)
    {
      // Find the device by its identity, because the numbers of devices may have changed since the
      // guard started. A device that only vibrates has no identity.
      const std::string& identity = this->Facts.Identity;
      isDone = identity.empty() ? this->Driver->Connect(ignored)
                                : this->Driver->Reconnect(
                                    identity, [] { return false; }, ignored);
      if (!isDone)
      {
        ServoClock::SleepUntil(ServoClock::Now() + 10 * ServoClock::Millisecond);
      }
    }
    this->Driver->Disconnect();
  }
  catch (const std::exception&)
  {
    // Memory may have run out, for example. Nothing more can be done.
  }
}

void GuardedDevice::Close()
{
  if (this->IsForked())
  {
    if (!this->IsAbandoned)
    {
      // The thread doesn't exist in the forked process, so leak it. The guard continues to serve
      // the parent.
      static_cast<void>(new std::thread(std::move(this->Watcher)));
      this->Guard.Abandon();
      static_cast<void>(this->Driver.release());
      this->IsAbandoned = true;
    }
  }
  else if (this->Watcher.joinable())
  {
    this->IsClosing.store(true);
    this->GetExchange().Quench();
    this->GetExchange().RequestStop();
    this->Watcher.join();
    this->Process = 0;
  }
}

DeviceCondition GuardedDevice::GetCondition()
{
  return this->HasDevice.load(std::memory_order_acquire) == Side::Guard
    ? this->GetExchange().GetCondition()
    : this->EndedCondition;
}

void GuardedDevice::Home() noexcept
{
  if (!this->IsForked())
  {
    this->GetExchange().RequestHome();
  }
}

void GuardedDevice::SetLights(int lights) noexcept
{
  if (!this->IsForked())
  {
    this->GetExchange().SetLights(lights);
  }
}

DeviceState GuardedDevice::Read(double, DeviceSample& sample) noexcept
{
  const DeviceState state = this->GetExchange().Receive(sample);
  return this->HasDevice.load(std::memory_order_acquire) == Side::Guard ? state : DeviceState::Lost;
}

DeviceState GuardedDevice::Write(const Vector3& force) noexcept
{
  const DeviceState state = this->GetExchange().Give(this->Newtons.Ask(force));
  return this->HasDevice.load(std::memory_order_acquire) == Side::Guard ? state : DeviceState::Lost;
}

void GuardedDevice::Quench() noexcept
{
  if (!this->IsForked())
  {
    this->GetExchange().Quench();
  }
}

bool GuardedDevice::IsAtRest() const noexcept
{
  const Side side = this->HasDevice.load(std::memory_order_acquire);
  return side == Side::None || (side == Side::Guard && this->Memory->GetExchange().IsAtRest());
}

} // namespace VolumeHaptics
