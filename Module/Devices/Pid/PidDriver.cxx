// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidDriver.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Pid/PidMapper.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <thread>

namespace VolumeHaptics
{
namespace
{

bool IsOpenFfboard(const HidDeviceInfo& info)
{
  return info.Vendor == 0x1209 && info.ProductId == 0xFFB0;
}

/** Returns whether the vendor number belongs to Arduino (two numbers) or SparkFun. */
bool IsArduino(const HidDeviceInfo& info)
{
  return info.Vendor == 0x2341 || info.Vendor == 0x2A03 || info.Vendor == 0x1B4F;
}

/** Returns whether all force-feedback reports have the sizes of ArduinoJoystickWithFFBLibrary's. */
bool HasSizesOfLibrary(const HidReportDescriptor& descriptor)
{
  // Sizes of the output reports 1 to 14. Report 9 does not exist, and report 8 lacks the second
  // axis.
  constexpr std::size_t outputs[] = { 17, 13, 14, 11, 3, 5, 15, 1, 0, 3, 1, 1, 1, 4 };
  // Sizes of the feature reports 5 to 7.
  constexpr std::size_t features[] = { 3, 4, 4 };
  bool isSame = true;
  for (std::size_t i = 0; i < std::size(outputs); ++i)
  {
    const auto id = static_cast<std::uint8_t>(1 + i);
    isSame = isSame && descriptor.GetReportSize(HidReportKind::Output, id) == outputs[i];
  }
  for (std::size_t i = 0; i < std::size(features); ++i)
  {
    const auto id = static_cast<std::uint8_t>(5 + i);
    isSame = isSame && descriptor.GetReportSize(HidReportKind::Feature, id) == features[i];
  }
  return isSame;
}

/** Returns whether the second axis can be enabled. */
bool HasSecondAxis(const HidReportDescriptor& descriptor)
{
  constexpr HidUsage y = MakeHidUsage(0x01, 0x31);
  const std::vector<HidField>& fields = descriptor.GetFields();
  return std::any_of(fields.begin(), fields.end(),
    [&descriptor, y](const HidField& field)
    {
      return field.Kind == HidReportKind::Output && field.Usage == y &&
        descriptor.IsWithin(field, PidMapper::Of(PidUsage::AxesEnable));
    });
}

/**
 * Number of consecutive repeated packets after which the stick counts as one that sends reports
 * periodically.
 */
constexpr int RepeatsOfStream = 20;
/**
 * A packet that equals the previous one counts as a periodic repeat only within this time (ns). A
 * repeat after a longer pause is a coincidence.
 */
constexpr std::int64_t LongestReminder = 250000000;
/**
 * Silence, in multiples of LongestGap, after which the device is lost, because two repeats are
 * missing.
 */
constexpr double MissedGaps = 2.5;
/**
 * Silence, in multiples of LongestGap, after which the tip's last position is no longer confirmed.
 */
constexpr double LateGaps = 1.5;

const char* const TwoAxes =
  "it has two axes, and firmwares disagree on the direction of the force along the second one, "
  "which could push the hand away. If only the first axis has a motor, as that of a wheel, set the "
  "second NewtonsPerFullScale to 0. Else use a stick of which the directions are known, such as an "
  "OpenFFBoard with firmware 1.16.5 or later";

} // namespace

PidFirmware DetectPidFirmware(const HidDeviceInfo& info, const HidReportDescriptor& descriptor)
{
  PidFirmware firmware;
  if (IsOpenFfboard(info))
  {
    const std::string name = "FFBoard ";
    firmware.IsKnown =
      info.Product.size() > name.size() && info.Product.compare(0, name.size(), name) == 0;
    firmware.HasShares = !HasSecondAxis(descriptor);
    if (firmware.HasShares && !firmware.IsKnown)
    {
      firmware.Objection = "older versions of its firmware disagree on the direction of the force, "
                           "which could push the hand away. Update its firmware to 1.16.5 or later";
    }
  }
  else if (IsArduino(info) && HasSizesOfLibrary(descriptor))
  {
    firmware.IsKnown = true;
    firmware.Sign = -1.0;
  }
  return firmware;
}

bool PidDriver::ReadNumbers(const std::string& id, Numbers& numbers)
{
  if (id == "pid")
  {
    numbers = {};
    return true;
  }
  const auto isDigit = [](char c)
  { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); };
  const bool isWhole = id.size() == 13 && id.compare(0, 4, "pid:") == 0 && id[8] == ':' &&
    std::all_of(id.begin() + 4, id.begin() + 8, isDigit) &&
    std::all_of(id.begin() + 9, id.end(), isDigit);
  if (isWhole)
  {
    numbers.Any = false;
    numbers.Vendor = static_cast<std::uint16_t>(std::strtoul(id.c_str() + 4, nullptr, 16));
    numbers.Product = static_cast<std::uint16_t>(std::strtoul(id.c_str() + 9, nullptr, 16));
  }
  return isWhole;
}

bool PidDriver::Mapping::Read(const HidDeviceInfo& info, bool usesSecond, std::string& error)
{
  HidReportDescriptor descriptor;
  if (!info.ReadDescriptor(descriptor, error) || !this->Device.Map(descriptor, error) ||
    !this->Stick.Map(descriptor, error))
  {
    return false;
  }
  this->Firmware = DetectPidFirmware(info, descriptor);
  if (this->Firmware.HasShares)
  {
    this->Device.UseShares();
  }
  const bool isTwo =
    usesSecond && this->Device.GetNumberOfAxes() > 1 && this->Stick.HasSecondAxis();
  if (!isTwo)
  {
    this->Device.UseOneAxis();
    this->Stick.UseOneAxis();
  }
  this->Objection = isTwo && !this->Firmware.IsKnown ? TwoAxes : this->Firmware.Objection;
  return true;
}

bool PidDriver::IsPid(const HidDeviceInfo& info, std::string& objection)
{
  Mapping mapping;
  std::string error;
  const bool isPid = mapping.Read(info, true, error);
  objection = mapping.Objection;
  return isPid;
}

PidDriver::PidDriver(const Numbers& numbers, const std::array<double, 2>& newtonsPerFullScale)
  : HidDriver("A force-feedback stick")
  , Wanted(numbers)
  , NewtonsPerFullScale(newtonsPerFullScale)
{
}

std::string PidDriver::GetIdentity() const
{
  return this->GetInfo().MakeIdentity("pid") + (this->NewtonsPerFullScale[0] < 0.0 ? "-x" : "") +
    (this->NewtonsPerFullScale[1] < 0.0 ? "-y" : "");
}

DeviceLimits PidDriver::GetLimits() const
{
  const std::array<double, 2>& full = this->NewtonsPerFullScale;
  DeviceLimits limits;
  limits.MaximumForce = this->Map.Device.GetNumberOfAxes() > 1
    ? std::min(std::abs(full[0]), std::abs(full[1]))
    : std::abs(full[0]);
  limits.MaximumSpeed = FastestStick;
  limits.WorkspaceRadius = Travel;
  limits.ForceAxes = this->Map.Device.GetNumberOfAxes() > 1 ? 3 : 1;
  limits.LeastMotion = 2.0 * Travel * this->Map.Stick.GetStep();
  return limits;
}

std::vector<HidDeviceInfo> PidDriver::Choose(std::string& error) const
{
  std::vector<HidDeviceInfo> devices;
  std::string reason;
  for (const HidDeviceInfo& info : ListHidDevices())
  {
    const bool isNamed =
      info.Vendor == this->Wanted.Vendor && info.ProductId == this->Wanted.Product;
    Mapping mapping;
    if ((this->Wanted.Any || isNamed) && mapping.Read(info, this->UsesSecondAxis(), reason))
    {
      if (!mapping.Objection.empty())
      {
        error = info.GetLabel() + " can't be used: " + mapping.Objection + ".";
      }
      else
      {
        devices.push_back(info);
      }
    }
    else if (isNamed && !this->Wanted.Any)
    {
      error = info.GetLabel() + " can't be used: " + reason +
        ". Choose a device that EnumerateDevices() lists.";
    }
  }
  if (devices.empty() && error.empty())
  {
    error = this->Wanted.Any
      ? "No force-feedback stick or wheel is plugged in. Plug it in and switch it on; it has to "
        "speak HID PID."
      : "No device with these numbers is plugged in. Plug it in, or give an id that "
        "EnumerateDevices() lists.";
  }
  return devices;
}

bool PidDriver::Prepare(const HidDeviceInfo& info, std::string& error)
{
  this->Map = Mapping();
  if (!this->Map.Read(info, this->UsesSecondAxis(), error))
  {
    error = info.GetLabel() + " can't be used: " + error + ". Plug it in again.";
    return false;
  }
  if (!this->Map.Objection.empty())
  {
    error = info.GetLabel() + " can't be used: " + this->Map.Objection + ".";
    return false;
  }
  for (std::size_t axis = 0; axis < this->NewtonsPerFullScale.size(); ++axis)
  {
    this->Settings.NewtonsPerFullScale[axis] =
      this->Map.Firmware.Sign * this->NewtonsPerFullScale[axis];
  }
  return true;
}

void PidDriver::Begin(HardwareExchange& exchange, bool)
{
  this->Stream.reset();
  this->Dialogue.emplace(this->Map.Device, this->Settings);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  this->State = {};
  this->State.Axes = { unknown, this->Map.Stick.HasSecondAxis() ? unknown : 0.0 };
  this->IsReady = false;
  this->LastSize = this->Repeats = 0;
  this->LongestGap = 0;
  this->LastPacketTime = ServoClock::Now();
  this->LastRound = ServoClock::Now();
  this->Drain();
  this->Report(exchange, DeviceStage::Homing, "is being prepared.");
}

void PidDriver::Work(HardwareExchange& exchange)
{
  if (!this->Stream)
  {
    this->GoOnWithDialogue(exchange);
    return;
  }
  const bool hasNews = this->Listen(exchange);
  if (this->IsLost())
  {
    return;
  }
  const auto silence = static_cast<double>(ServoClock::Now() - this->LastPacketTime);
  if (this->IsSilent(hasNews) && this->Repeats > RepeatsOfStream &&
    silence > MissedGaps * static_cast<double>(this->LongestGap))
  {
    this->Lose(exchange,
      "no longer reports its position. Check its cable and its power, then Home() and "
      "Arm() again; if that does not help, plug it in again, then Open() and Start() it.");
    return;
  }
  if (hasNews)
  {
    this->ReportPlace(exchange);
  }
  const bool isLate =
    this->Repeats > RepeatsOfStream && silence > LateGaps * static_cast<double>(this->LongestGap);
  if (this->SendForces(exchange) && this->IsReady && !isLate)
  {
    // The device has just received a report, so it is connected, and would have reported any
    // motion.
    exchange.Confirm();
  }
}

void PidDriver::GoOnWithDialogue(HardwareExchange& exchange)
{
  HidReport report;
  switch (this->Dialogue->GetStep(report))
  {
    case PidStep::Send:
      if (this->Send(exchange, report))
      {
        this->Dialogue->Sent(true);
      }
      break;
    case PidStep::Fetch:
      this->Fetch(report);
      break;
    case PidStep::Ready:
      this->Stream.emplace(this->Map.Device, this->Settings, *this->Dialogue);
      this->LastRound = ServoClock::Now();
      this->IsSilent(true);
      this->Report(
        exchange, DeviceStage::Homing, "has not said yet where it is: move it a little.");
      break;
    case PidStep::Failed:
      this->Lose(exchange,
        ("can't be prepared. " + this->Dialogue->GetError() +
          ". End other programs that use it and plug it in again, then Open() and Start() it.")
          .c_str());
      break;
  }
}

void PidDriver::Fetch(HidReport& report)
{
  const int size = this->Port.GetFeature(report.Bytes.data(), report.Size + 1);
  const bool came = size > 1;
  this->Dialogue->Fetched(report.Payload(), came ? static_cast<std::size_t>(size) - 1 : 0);
  // The device may still be creating the effect, so wait before the next request.
  std::this_thread::sleep_for(std::chrono::duration<double>(PidDialogue::PollPause));
}

bool PidDriver::Listen(HardwareExchange& exchange)
{
  std::array<std::uint8_t, LongestReport> bytes;
  bool hasNews = false;
  for (int i = 0; i < LongestQueue; ++i)
  {
    const int size = this->Read(exchange, bytes.data(), i == 0 ? 1 : 0);
    if (size <= 0)
    {
      return hasNews;
    }
    hasNews = true;
    const char* const wrong =
      this->Map.Stick.Decode(bytes.data(), static_cast<std::size_t>(size), this->State);
    if (wrong)
    {
      const std::string text = std::string("sent ") + wrong +
        ". Check its cable and its firmware, then Home() and Arm() again.";
      this->Lose(exchange, text.c_str());
      return hasNews;
    }
    const std::int64_t gap = ServoClock::Now() - this->LastPacketTime;
    this->LastPacketTime += gap;
    const bool repeats = size == this->LastSize && gap < LongestReminder &&
      std::equal(bytes.begin(), bytes.begin() + size, this->LastPacket.begin());
    this->Repeats = std::min(this->Repeats + (repeats ? 1 : 0), RepeatsOfStream + 1);
    this->LongestGap = repeats ? std::max(this->LongestGap, gap) : this->LongestGap;
    this->LastPacket = bytes;
    this->LastSize = size;
  }
  return hasNews;
}

void PidDriver::ReportPlace(HardwareExchange& exchange)
{
  DeviceSample sample;
  sample.Tip = { Travel * this->State.Axes[0], -Travel * this->State.Axes[1], 0.0 };
  sample.Buttons = this->State.Buttons;
  if (!IsFinite(sample.Tip))
  {
    return;
  }
  exchange.Report(sample);
  if (!this->IsReady)
  {
    this->IsReady = true;
    this->Report(exchange, DeviceStage::Ready, "");
  }
}

bool PidDriver::SendForces(HardwareExchange& exchange)
{
  const std::int64_t now = ServoClock::Now();
  double elapsed = static_cast<double>(now - this->LastRound) * ServoClock::SecondsPerNanosecond;
  this->LastRound = now;
  const Vector3 force = exchange.GetForce();
  // A positive magnitude pushes to the left or towards the hand, so reverse the signs.
  const std::array<double, 2> magnitudes{ -force.X, -force.Y };
  // For each effect, send the restart if it is due, and the magnitude.
  HidReport report;
  bool isAlive = false;
  for (int i = 0; i < 2 * this->Map.Device.GetNumberOfEffects(); ++i)
  {
    if (!this->Stream->Next(elapsed, magnitudes, report))
    {
      break;
    }
    if (!this->Send(exchange, report))
    {
      return false;
    }
    isAlive = true;
    elapsed = 0.0;
  }
  exchange.RecordTaken();
  return isAlive;
}

bool PidDriver::Send(HardwareExchange& exchange, const HidReport& report) noexcept
{
  return this->Write(
    exchange, report.Bytes.data(), report.Size + 1, report.Kind == HidReportKind::Feature);
}

void PidDriver::Rest() noexcept
{
  const HidReport stop = this->Map.Device.Control(PidUsage::StopAllEffects);
  for (int effect = 0; this->Stream && effect < this->Map.Device.GetNumberOfEffects(); ++effect)
  {
    const HidReport zero =
      this->Map.Device.SetConstant(this->Dialogue->GetBlocks()[effect], effect, 0.0, 1.0);
    this->Port.Write(zero.Bytes.data(), zero.Size + 1);
  }
  this->Port.Write(stop.Bytes.data(), stop.Size + 1);
}

void PidDriver::End() noexcept
{
  this->Rest();
  const HidReport reset = this->Map.Device.Control(PidUsage::DeviceReset);
  this->Port.Write(reset.Bytes.data(), reset.Size + 1);
}

} // namespace VolumeHaptics
