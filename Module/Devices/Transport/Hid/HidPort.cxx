// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidPort.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"

#include <chrono>
#include <thread>

namespace VolumeHaptics
{
namespace
{

/**
 * Number of attempts to claim a device: another program's HidDeviceInfo::GetState may claim it for
 * a moment.
 */
constexpr int Attempts = 10;
constexpr std::chrono::milliseconds AttemptPause(5);
/**
 * Duration (ns) of a write above which the device counts as one that no longer accepts reports. It
 * is longer than a working device needs, and equals the watchdog time of the slowest device.
 */
constexpr std::int64_t StuckTime = 500000000;

std::string ErrorOf(hid_device* device)
{
  const wchar_t* const wide = hid_error(device);
  std::string text;
  for (const wchar_t* c = wide; c && *c; ++c)
  {
    text += *c < 128 ? static_cast<char>(*c) : '?';
  }
  return text;
}

} // namespace

bool HidPort::Open(const HidDeviceInfo& info, std::string& error)
{
  this->Close();
  this->TryAgain();
  HidClaim::Answer answer = HidClaim::Answer::InUse;
  for (int i = 0; i < Attempts && answer == HidClaim::Answer::InUse; ++i)
  {
    if (i > 0)
    {
      std::this_thread::sleep_for(AttemptPause);
    }
    const std::lock_guard<std::mutex> lock(GetHidMutex());
    answer = this->Claim.Own(info.Path);
  }
  this->InUse = answer == HidClaim::Answer::InUse;
  switch (answer)
  {
    case HidClaim::Answer::InUse:
      error = info.GetLabel() +
        " is in use. Close it where it is open, in this program or in another one.";
      return false;
    case HidClaim::Answer::Forbidden:
      error = info.GetLabel() + ": " + info.GetPermissionCure();
      return false;
    case HidClaim::Answer::Missing:
      error = info.GetLabel() + " is no longer plugged in. Plug it in and open it again.";
      return false;
    case HidClaim::Answer::Held:
      break;
  }
  const std::lock_guard<std::mutex> lock(GetHidMutex());
  this->Device = hid_open_path(info.Path.c_str());
  if (!this->Device)
  {
    error = info.GetLabel() + " can't be opened (" + ErrorOf(nullptr) +
      "). Plug it in again, then open it.";
    this->Claim.Release();
    return false;
  }
  return true;
}

void HidPort::Close() noexcept
{
  if (this->Device)
  {
    const std::lock_guard<std::mutex> lock(GetHidMutex());
    hid_close(this->Device);
    this->Device = nullptr;
  }
  this->Claim.Release();
}

int HidPort::Read(std::uint8_t* bytes, std::size_t size, int time) noexcept
{
  return hid_read_timeout(this->Device, bytes, size, time);
}

template <typename F>
bool HidPort::Send(F&& send) noexcept
{
  if (this->Stuck)
  {
    return false;
  }
  const std::int64_t begin = ServoClock::Now();
  const bool isTaken = send();
  this->Stuck = !isTaken && ServoClock::Now() - begin > StuckTime;
  return isTaken;
}

bool HidPort::Write(const std::uint8_t* report, std::size_t size) noexcept
{
  return this->Send(
    [&]
    {
      return this->WritesByClaim ? this->Claim.Write(report, size)
                                 : hid_write(this->Device, report, size) == static_cast<int>(size);
    });
}

bool HidPort::SendFeature(const std::uint8_t* report, std::size_t size) noexcept
{
  return this->Send([&] { return hid_send_feature_report(this->Device, report, size) >= 0; });
}

int HidPort::GetFeature(std::uint8_t* report, std::size_t size) noexcept
{
  return hid_get_feature_report(this->Device, report, size);
}

} // namespace VolumeHaptics
