// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidDriver.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace VolumeHaptics
{
namespace
{

constexpr int LostPause = 10; // ms

} // namespace

bool HidDriver::Connect(std::string& error)
{
  const std::vector<HidDeviceInfo> devices = this->Choose(error);
  for (const HidDeviceInfo& info : devices)
  {
    if (this->Take(info, error))
    {
      this->HasTwin = false;
      this->LookForTwin();
      return true;
    }
    if (!this->Port.IsInUse())
    {
      return false;
    }
  }
  return false;
}

bool HidDriver::Take(const HidDeviceInfo& info, std::string& error)
{
  if (!this->Port.Open(info, error))
  {
    return false;
  }
  this->Label = info.GetLabel();
  this->Info = info;
  if (!this->Prepare(info, error))
  {
    this->Port.Close();
    return false;
  }
  return true;
}

std::vector<HidDeviceInfo> HidDriver::ListLike(const HidDeviceInfo& before) const
{
  std::vector<HidDeviceInfo> devices = ListHidDevices();
  devices.erase(std::remove_if(devices.begin(), devices.end(),
                  [&before](const HidDeviceInfo& info) { return !info.IsLike(before); }),
    devices.end());
  return devices;
}

void HidDriver::LookForTwin()
{
  for (const HidDeviceInfo& info : this->ListLike(this->Info))
  {
    this->HasTwin = this->HasTwin || info.Path != this->Info.Path;
  }
}

bool HidDriver::Reconnect(
  const std::string& /*identity*/, const std::function<bool()>& /*mustStop*/, std::string& error)
{
  const HidDeviceInfo before = this->Info;
  const std::string label = this->Label;
  const std::vector<HidDeviceInfo> devices = this->ListLike(before);
  if (devices.size() > 1 && !this->GetIdentity().empty())
  {
    error = label + " was unplugged, and " + std::to_string(devices.size()) +
      " devices have its serial number now. Open() and Start() the one that you mean.";
    return false;
  }
  for (const HidDeviceInfo& info : devices)
  {
    std::string trouble;
    if (this->Take(info, trouble))
    {
      error.clear();
      return true;
    }
    // Skip devices that are in use, because the previous device is not in use.
    error = this->Port.IsInUse() ? error : trouble;
  }
  this->Info = before;
  this->Label = label;
  return false;
}

void HidDriver::SendLastZero() noexcept
{
  this->Port.WriteByClaim();
  this->Rest();
}

void HidDriver::Serve(HardwareExchange& exchange)
{
  /** Ends the force when leaving the scope, even by an exception. */
  struct AtEnd
  {
    HidDriver* Driver;
    ~AtEnd()
    {
      if (!this->Driver->Gone)
      {
        this->Driver->Port.TryAgain();
        this->Driver->End();
      }
    }
  };
  const AtEnd atEnd{ this };
  this->Lost = this->Gone = false;
  bool wasSeen = true;
  this->Restart(exchange, true);
  while (!exchange.MustStop() && !(this->Gone && !wasSeen && this->CanReturn()))
  {
    if (this->Gone && wasSeen)
    {
      // Check for a twin now: one that is plugged in meanwhile could later be mistaken for this
      // device.
      wasSeen = false;
      this->LookForTwin();
      this->Report(exchange, DeviceStage::Lost, this->GetUnpluggedText());
      continue;
    }
    if (exchange.HasSlept())
    {
      this->Retreat();
    }
    if (exchange.DrainHomeRequest())
    {
      if (this->Gone)
      {
        this->Report(exchange, DeviceStage::Lost, this->GetUnpluggedText());
      }
      else
      {
        this->Restart(exchange, this->Lost);
      }
    }
    if (this->Lost)
    {
      this->LookWhetherGone(exchange);
    }
    else
    {
      this->Work(exchange);
    }
  }
}

void HidDriver::Restart(HardwareExchange& exchange, bool isAnew)
{
  this->Lost = false;
  this->Port.TryAgain();
  this->IsSilent(true);
  this->Begin(exchange, isAnew);
}

void HidDriver::LookWhetherGone(HardwareExchange& exchange) noexcept
{
  if (this->Gone)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(LostPause));
    return;
  }
  // After a device is unplugged, the system refuses writes for a while before reads fail, so check
  // with a read.
  std::uint8_t bytes[LongestReport];
  if (this->Port.Read(bytes, sizeof(bytes), LostPause) < 0)
  {
    this->Gone = true;
    this->Report(exchange, DeviceStage::Lost, this->GetUnpluggedText());
  }
}

bool HidDriver::IsSilent(bool hasNews) noexcept
{
  const std::int64_t now = ServoClock::Now();
  if (hasNews)
  {
    this->LastNews = now;
    this->EmptyReads = 0;
    return false;
  }
  ++this->EmptyReads;
  constexpr auto longest =
    static_cast<std::int64_t>(SilenceTime * ServoClock::NanosecondsPerSecond);
  return this->EmptyReads > SilentReads && now - this->LastNews > longest;
}

int HidDriver::Read(HardwareExchange& exchange, std::uint8_t* bytes, int time) noexcept
{
  const int size = this->Port.Read(bytes, LongestReport, time);
  if (size >= 0)
  {
    return size;
  }
  this->Gone = true;
  this->Lose(exchange, this->GetUnpluggedText());
  return 0;
}

bool HidDriver::Write(
  HardwareExchange& exchange, const std::uint8_t* report, std::size_t size, bool isFeature) noexcept
{
  if (isFeature ? this->Port.SendFeature(report, size) : this->Port.Write(report, size))
  {
    return true;
  }
  std::uint8_t bytes[LongestReport];
  this->Gone = this->Port.Read(bytes, sizeof(bytes), 0) < 0;
  this->Lose(exchange,
    this->Gone ? this->GetUnpluggedText()
               : "does not accept what is sent to it. Check its cable, then Home() and Arm() "
                 "again; if that does not help, plug it in again, then Open() and Start() it.");
  return false;
}

void HidDriver::Drain() noexcept
{
  std::uint8_t bytes[LongestReport];
  for (int i = 0; i<LongestQueue&& this->Port.Read(bytes, sizeof(bytes), 0)> 0; ++i)
  {
  }
}

void HidDriver::Retreat() noexcept
{
  this->Lost = true;
  if (!this->Gone)
  {
    this->Rest();
  }
}

void HidDriver::Lose(HardwareExchange& exchange, const char* text) noexcept
{
  // Notify the servo before sending anything, because sending may take long.
  this->Report(exchange, DeviceStage::Lost, text);
  this->Retreat();
}

void HidDriver::Report(
  HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept
{
  exchange.SetCondition(stage, this->Label.c_str(), text);
}

} // namespace VolumeHaptics
