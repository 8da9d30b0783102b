// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/DualSenseDriver.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <cstdlib>

namespace VolumeHaptics
{
namespace
{

constexpr const char* Word = "dualsense";
constexpr std::int64_t FirstReportTime = 500000000; // ns
constexpr int Steps = 255;
constexpr int MostBadReports = 5; // limit of consecutive bad reports

} // namespace

DualSenseDriver::DualSenseDriver(int number)
  : HidDriver("A DualSense")
  , Number(number)
{
}

std::vector<std::string> DualSenseDriver::MakeWords(int number)
{
  return { Word, std::to_string(number) };
}

std::unique_ptr<HardwareDriver> DualSenseDriver::MakeFromWords(
  const std::vector<std::string>& words)
{
  return words.size() == 2 && words[0] == Word
    ? std::make_unique<DualSenseDriver>(std::atoi(words[1].c_str()))
    : nullptr;
}

bool DualSenseDriver::IsDualSense(const HidDeviceInfo& info)
{
  return DualSense::IsKnown(info.Vendor, info.ProductId);
}

std::vector<HidDeviceInfo> DualSenseDriver::Choose(std::string& error) const
{
  const std::vector<HidDeviceInfo> pads = ListHidDevices(&DualSenseDriver::IsDualSense);
  if (static_cast<std::size_t>(this->Number) >= pads.size())
  {
    error = "The DualSense is no longer connected. Plug it in, or switch it on.";
    return {};
  }
  return { pads[static_cast<std::size_t>(this->Number)] };
}

bool DualSenseDriver::Prepare(const HidDeviceInfo& info, std::string& error)
{
  std::uint8_t feature[64]{ DualSense::CalibrationReport };
  this->Port.GetFeature(feature, 41);
  feature[0] = DualSense::FirmwareReport;
  const int size = this->Port.GetFeature(feature, sizeof(feature));
  this->IsNewer = DualSense::HasNewerVibration(
    info.ProductId, feature, static_cast<std::size_t>(std::max(0, size)));
  this->Link = DualSense::Link::Unknown;
  const std::int64_t begin = ServoClock::Now();
  while (this->Link == DualSense::Link::Unknown && ServoClock::Now() - begin < FirstReportTime)
  {
    std::uint8_t bytes[LongestReport];
    const int count = this->Port.Read(bytes, sizeof(bytes), 10);
    if (count < 0)
    {
      break;
    }
    DualSense::Decode(bytes, static_cast<std::size_t>(count), this->Link, this->State);
  }
  if (this->Link == DualSense::Link::Unknown)
  {
    error = this->GetName() +
      " sends no reports that are known. Press its PS button, or connect it "
      "by its cable; then open it again.";
    return false;
  }
  return this->Send(0, 0);
}

bool DualSenseDriver::Send(int strong, int weak) noexcept
{
  const DualSense::Report report =
    DualSense::Encode(this->Link, this->IsNewer, strong, weak, this->Reports++);
  this->Strong = strong;
  this->Weak = weak;
  this->SentAt = ServoClock::Now();
  return report.Size > 0 && this->Port.Write(report.Bytes.data(), report.Size);
}

void DualSenseDriver::Begin(HardwareExchange& exchange, bool)
{
  this->Drain();
  this->Levels.Silence();
  this->BadReports = 0;
  this->LastRound = ServoClock::Now();
  this->Tip.Begin(exchange);
  this->Report(exchange, DeviceStage::Ready, "");
}

void DualSenseDriver::Work(HardwareExchange& exchange)
{
  if (!this->Listen(exchange))
  {
    return;
  }
  const PadMotion motion = Steer(this->State);
  this->Tip.Move(exchange, motion.Push, motion.Turn, this->State.Buttons);
  this->Show(exchange);
}

bool DualSenseDriver::Listen(HardwareExchange& exchange)
{
  std::uint8_t bytes[LongestReport];
  bool hasNews = false;
  for (int i = 0; i < LongestQueue; ++i)
  {
    const int size = this->Read(exchange, bytes, i == 0 ? 1 : 0);
    if (this->IsLost())
    {
      return false;
    }
    if (size == 0)
    {
      break;
    }
    DualSense::Link link = this->Link;
    const char* const wrong =
      DualSense::Decode(bytes, static_cast<std::size_t>(size), link, this->State);
    hasNews = hasNews || !wrong;
    // A report that was corrupted on the radio link is not an error, because the next one follows
    // at once.
    this->BadReports = wrong ? this->BadReports + 1 : 0;
    if (this->BadReports > MostBadReports)
    {
      this->Lose(exchange,
        (std::string("sent ") + wrong + ", again and again. Reconnect it, then Home() and Arm().")
          .c_str());
      return false;
    }
  }
  if (this->IsSilent(hasNews))
  {
    this->Lose(
      exchange, "no longer reports. Check its cable or battery, then Home() and Arm() again.");
    return false;
  }
  return true;
}

void DualSenseDriver::Show(HardwareExchange& exchange)
{
  const Vector3 force = exchange.GetForce();
  const double elapsed = ServoClock::SecondsSince(this->LastRound);
  this->LastRound = ServoClock::Now();
  const VibrationLevels levels = this->Levels.Advance(force, elapsed);
  const int strong = Vibration::Quantize(levels.Strong, Steps);
  const int weak = Vibration::Quantize(levels.Weak, Steps);
  const bool isSame = strong == this->Strong && weak == this->Weak;
  const bool isSilent = strong == 0 && weak == 0;
  if (!isSame && (isSilent || ServoClock::SecondsSince(this->SentAt) >= SendPeriod) &&
    !this->Send(strong, weak))
  {
    this->Lose(exchange,
      "does not accept what is sent to it. Check its cable or battery, then Home() and Arm() "
      "again.");
    return;
  }
  exchange.RecordTaken();
}

} // namespace VolumeHaptics
