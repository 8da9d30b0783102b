// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/SpaceMouse/SpaceMouseDriver.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr std::uint8_t LightReport = 4;
constexpr std::uint8_t ButtonReport = 3;
/** Page of the usages of these devices: multi-axis controller and joystick. */
constexpr std::uint16_t DesktopPage = 0x01;

/**
 * Converts from the device's axes to the tip's (right, up, towards the hand). The device's axes
 * point right, towards the hand and down or, if isAxisUp, right, up and away from the hand.
 */
Vector3 TurnAxes(bool isAxisUp, double x, double y, double z)
{
  return isAxisUp ? Vector3{ x, y, -z } : Vector3{ x, -z, y };
}

} // namespace

SpaceMouseDriver::SpaceMouseDriver(int number)
  : HidDriver("A SpaceMouse")
  , Number(number)
{
}

bool SpaceMouseDriver::IsSpaceMouse(const HidDeviceInfo& info)
{
  // A receiver also has an interface for a mouse or a keyboard, so use only the interface whose
  // report has six axes.
  HidReportDescriptor descriptor;
  std::string error;
  const auto isTurn = [](const HidField& field)
  {
    return field.Kind == HidReportKind::Input && field.Usage >= MakeHidUsage(DesktopPage, 0x33) &&
      field.Usage <= MakeHidUsage(DesktopPage, 0x35);
  };
  return SpaceMouse::IsKnown(info.Vendor, info.ProductId) &&
    (!info.ReadDescriptor(descriptor, error) ||
      std::any_of(descriptor.GetFields().begin(), descriptor.GetFields().end(), isTurn));
}

std::vector<HidDeviceInfo> SpaceMouseDriver::Choose(std::string& error) const
{
  const std::vector<HidDeviceInfo> devices = ListHidDevices(&SpaceMouseDriver::IsSpaceMouse);
  if (static_cast<std::size_t>(this->Number) >= devices.size())
  {
    error = devices.empty()
      ? "No SpaceMouse is plugged in. Plug it in, or its receiver, and switch it on."
      : "There is no SpaceMouse with this number. Count from 0, as EnumerateDevices() does.";
    return {};
  }
  return { devices[static_cast<std::size_t>(this->Number)] };
}

bool SpaceMouseDriver::Prepare(const HidDeviceInfo& info, std::string&)
{
  HidReportDescriptor descriptor;
  std::string reason;
  this->LightSize = info.ReadDescriptor(descriptor, reason)
    ? descriptor.GetReportSize(HidReportKind::Output, LightReport)
    : 0;
  this->LightSize = std::min(this->LightSize, static_cast<std::size_t>(LongestReport - 1));
  this->IsLit = false;
  this->IsAxisUp = SpaceMouse::HasAxisUp(info.Vendor, info.ProductId);
  return true;
}

void SpaceMouseDriver::Begin(HardwareExchange& exchange, bool)
{
  this->Drain();
  this->State = {};
  this->LastMotion = ServoClock::Now();
  this->Tip.Begin(exchange);
  this->Report(exchange, DeviceStage::Ready, "");
}

void SpaceMouseDriver::Work(HardwareExchange& exchange)
{
  this->Listen(exchange);
  if (this->IsLost())
  {
    return;
  }
  this->Move(exchange);
  const int lights = exchange.GetLights();
  this->Light(lights < 0 || (lights & 1) != 0);
}

void SpaceMouseDriver::Listen(HardwareExchange& exchange)
{
  std::uint8_t bytes[LongestReport];
  for (int i = 0; i < LongestQueue; ++i)
  {
    const int size = this->Read(exchange, bytes, i == 0 ? 1 : 0);
    if (size <= 0)
    {
      return;
    }
    const char* const wrong =
      SpaceMouse::Decode(bytes, static_cast<std::size_t>(size), this->State);
    if (wrong)
    {
      const std::string text = std::string("sent ") + wrong +
        ". It may be a model that is not known yet. Plug it in again, then Open() and Start() it.";
      this->Lose(exchange, text.c_str());
      return;
    }
    if (bytes[0] < ButtonReport)
    {
      this->LastMotion = ServoClock::Now();
    }
  }
}

void SpaceMouseDriver::Move(HardwareExchange& exchange)
{
  if (ServoClock::SecondsSince(this->LastMotion) > HoldTime)
  {
    this->State.Axes = {};
  }
  const std::array<double, 6>& axes = this->State.Axes;
  this->Tip.Move(exchange, TurnAxes(this->IsAxisUp, axes[0], axes[1], axes[2]),
    TurnAxes(this->IsAxisUp, axes[3], axes[4], axes[5]), this->State.Buttons);
}

void SpaceMouseDriver::Light(bool on) noexcept
{
  if (this->LightSize == 0 || on == this->IsLit)
  {
    return;
  }
  std::uint8_t report[LongestReport]{ LightReport, static_cast<std::uint8_t>(on ? 1 : 0) };
  this->IsLit = on;
  if (!this->Port.Write(report, this->LightSize + 1))
  {
    // The light is optional: the device is usable without it.
    this->LightSize = 0;
  }
}

void SpaceMouseDriver::End() noexcept
{
  this->Light(false);
}

} // namespace VolumeHaptics
