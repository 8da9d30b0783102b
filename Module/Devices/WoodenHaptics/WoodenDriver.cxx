// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/WoodenHaptics/WoodenDriver.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

///@{
/**
 * Vendor, product and name of the two published controllers. All devices with such a controller
 * have its numbers, and most have its name.
 */
constexpr std::uint16_t MbedVendor = 0x1234;
constexpr std::uint16_t MbedProduct = 0x0006;
constexpr const char* MbedName = "hid device";
constexpr std::uint16_t TeensyVendor = 0x16C0;
constexpr std::uint16_t TeensyProduct = 0x0486;
constexpr const char* TeensyName = "teensyduino rawhid";
///@}
/**
 * HID usage page of the board's second interface. It has the same name, but only sends the board's
 * log, so it is skipped.
 */
constexpr std::uint16_t LogPage = 0xFFC9;

/** Time (ns) between two packets with motor currents while no packet arrives from the board. */
constexpr std::int64_t SendPeriod = 2000000;
/**
 * Longest pause (s) between rounds. After a longer one the motion is unknown, because the kernel
 * may have dropped packets.
 */
constexpr double LateRound = 0.03;
/**
 * Time (s) between two preset packets. They are repeated because the firmware processes only the
 * last of several waiting packets.
 */
constexpr double PresetPeriod = 0.1;

constexpr const char* AskForRest =
  "needs to know where its arm is: put the arm into its rest pose, hold it still, and press "
  "Home().";
constexpr const char* AskForConsent =
  "has the name and numbers of its board, which other devices share, such as a Polhem. "
  "Nothing was sent to it. If it is a WoodenHaptics, put the arm into its rest pose, hold it "
  "still, and press Home().";
constexpr const char* AskAgain = ", then press Home() and put the arm into its rest pose.";

///@{
/**
 * Converts from the arm's axes (towards the hand, right, up) to the device's axes (right, up,
 * towards the hand).
 */
Vector3 ArmToDevice(const Vector3& arm)
{
  return { arm.Y, arm.Z, arm.X };
}

Vector3 ToArm(const Vector3& device)
{
  return { device.Z, device.X, device.Y };
}
///@}

bool IsMbed(const HidDeviceInfo& info)
{
  return info.Vendor == MbedVendor && info.ProductId == MbedProduct;
}

bool IsTeensy(const HidDeviceInfo& info)
{
  return info.Vendor == TeensyVendor && info.ProductId == TeensyProduct &&
    info.UsagePage != LogPage;
}

/**
 * Returns whether a device has a controller's numbers, and a word in its name (case-insensitive).
 */
bool IsNamed(const HidDeviceInfo& info, const char* word)
{
  std::string product = info.Product;
  std::transform(product.begin(), product.end(), product.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return (IsMbed(info) || IsTeensy(info)) && product.find(word) != std::string::npos;
}

/**
 * Returns whether a device identifies itself as a WoodenHaptics, which no published firmware does.
 */
bool SaysWhatItIs(const HidDeviceInfo& info)
{
  return IsNamed(info, "woodenhaptics");
}

/**
 * Returns whether a device has packets of the size in the published firmware, unlike other programs
 * for this board. Also returns true if the descriptor can't be read.
 */
bool HasPacketsOfMbed(const HidDeviceInfo& info)
{
  HidReportDescriptor descriptor;
  std::string reason;
  return !info.ReadDescriptor(descriptor, reason) ||
    (descriptor.GetReportSize(HidReportKind::Input, 0) == WoodenHaptics::PacketSize &&
      descriptor.GetReportSize(HidReportKind::Output, 0) == WoodenHaptics::PacketSize);
}

} // namespace

WoodenDriver::WoodenDriver(int number)
  : HidDriver("WoodenHaptics")
  , Number(number)
{
}

bool WoodenDriver::IsWooden(const HidDeviceInfo& info)
{
  const bool isBoard = (IsMbed(info) && IsNamed(info, MbedName) && HasPacketsOfMbed(info)) ||
    (IsTeensy(info) && IsNamed(info, TeensyName));
  return (SaysWhatItIs(info) || isBoard) && !IsNamed(info, "polhem");
}

bool WoodenDriver::IsPolhem(const HidDeviceInfo& info)
{
  return IsNamed(info, "polhem");
}

std::vector<HidDeviceInfo> WoodenDriver::Choose(std::string& error) const
{
  const std::vector<HidDeviceInfo> devices = ListHidDevices(&WoodenDriver::IsWooden);
  if (static_cast<std::size_t>(this->Number) >= devices.size())
  {
    const std::vector<HidDeviceInfo> others = ListHidDevices(&WoodenDriver::IsPolhem);
    error = !devices.empty()
      ? "There is no WoodenHaptics with this number. Count from 0, as EnumerateDevices() does."
      : !others.empty()
      ? others.front().GetLabel() +
        " can't be used: its linkage, encoders and rest pose are not those of a WoodenHaptics, so "
        "that positions and forces would be wrong. Plug in a WoodenHaptics instead."
      : "No WoodenHaptics is plugged in. Plug it in and switch it on; it is known by its board: "
        "USB ids 1234:0006 and the name \"HID DEVICE\", or 16c0:0486 and \"Teensyduino RawHID\".";
    return {};
  }
  return { devices[static_cast<std::size_t>(this->Number)] };
}

bool WoodenDriver::Prepare(const HidDeviceInfo& info, std::string& error)
{
  HidReportDescriptor descriptor;
  std::string reason;
  this->InputSize = this->OutputSize = WoodenHaptics::PacketSize;
  if (info.ReadDescriptor(descriptor, reason))
  {
    this->InputSize = descriptor.GetReportSize(HidReportKind::Input, 0);
    this->OutputSize = descriptor.GetReportSize(HidReportKind::Output, 0);
  }
  const std::size_t most = HidDriver::LongestReport - 1;
  if (descriptor.UsesReportIds() || this->InputSize < WoodenHaptics::PacketSize ||
    this->OutputSize < WoodenHaptics::PacketSize ||
    std::max(this->InputSize, this->OutputSize) > most)
  {
    error = info.GetLabel() +
      " does not exchange packets of 14 bytes, as its report descriptor says. It needs the "
      "firmware of WoodenHaptics.";
    return false;
  }
  this->HasConsent = SaysWhatItIs(info);
  this->Now = Phase::Asking;
  return true;
}

void WoodenDriver::Begin(HardwareExchange& exchange, bool isAnew)
{
  const bool isHeld = this->Now == Phase::Waiting || this->Now == Phase::Consent;
  if (!isAnew && isHeld)
  {
    this->HasConsent = true;
    this->Now = Phase::Presetting;
    this->LastRound = ServoClock::Now();
    this->PresetBegin = this->LastPreset = ServoClock::Now();
    this->Report(exchange, DeviceStage::Homing, "is learning that its arm is in the rest pose.");
    this->Send(exchange, this->Device.EncodeCalibration());
    return;
  }
  this->HasTip = false;
  this->Drain();
  if (!this->HasConsent)
  {
    this->Now = Phase::Consent;
    this->Report(exchange, DeviceStage::Homing, AskForConsent);
    return;
  }
  this->Now = Phase::Asking;
  this->LastRound = ServoClock::Now();
  this->LastSent = 0;
  this->Report(exchange, DeviceStage::Homing, "is asked where its arm is.");
}

void WoodenDriver::Work(HardwareExchange& exchange)
{
  if (this->Now == Phase::Consent)
  {
    // Ignore the device's packets until the user has confirmed the device.
    std::uint8_t ignored[LongestReport];
    this->Read(exchange, ignored, 1);
    this->IsSilent(true);
    return;
  }
  const bool isLate = ServoClock::SecondsSince(this->LastRound) > LateRound;
  this->LastRound = ServoClock::Now();
  this->HasTip = this->HasTip && !isLate;
  std::uint8_t bytes[LongestReport];
  bool hasNews = false;
  for (int i = 0; i < LongestQueue && !this->IsLost(); ++i)
  {
    const int size = this->Read(exchange, bytes, i == 0 ? 1 : 0);
    if (size <= 0)
    {
      break;
    }
    hasNews = true;
    this->ReceivePacket(exchange, bytes, size);
  }
  // After a pause, the kernel may have dropped packets.
  this->HasTip = this->HasTip && !isLate;
  if (!this->IsLost() && this->IsSilent(hasNews))
  {
    this->Lose(exchange,
      "does not answer. Check its cable and its power, then Home() and Arm() again; if that "
      "does not help, plug it in again, then Open() and Start() it.");
  }
  if (this->IsLost())
  {
    return;
  }
  if (this->Now == Phase::Presetting && ServoClock::SecondsSince(this->LastPreset) > PresetPeriod)
  {
    this->LastPreset = ServoClock::Now();
    this->Send(exchange, this->Device.EncodeCalibration());
  }
  else if (hasNews || ServoClock::Now() - this->LastSent >= SendPeriod)
  {
    const std::array<double, 3> angles = this->Device.ComputeAngles(this->Input.Counts);
    const Vector3 force = ToArm(exchange.GetForce());
    const auto currents = this->Device.ComputeCurrents(angles, force);
    if (this->Send(exchange, WoodenHaptics::EncodeCurrents(currents)))
    {
      exchange.RecordTaken();
    }
  }
}

void WoodenDriver::ReceivePacket(HardwareExchange& exchange, const std::uint8_t* bytes, int size)
{
  if (static_cast<std::size_t>(size) != this->InputSize ||
    WoodenHaptics::Decode(bytes, WoodenHaptics::PacketSize, this->Input))
  {
    this->Lose(exchange,
      "sent a packet of a wrong size. Check its cable and its firmware, then Home() and Arm() "
      "again.");
    return;
  }
  this->UpdateHand(exchange);
  if (!this->IsLost())
  {
    this->UpdatePhase(exchange);
  }
}

void WoodenDriver::UpdateHand(HardwareExchange& exchange)
{
  const Vector3 tip = this->Device.ComputeTip(this->Device.ComputeAngles(this->Input.Counts));
  const bool jumps = this->HasTip && Norm(tip - this->Tip) > FarthestStep;
  this->Tip = tip;
  this->HasTip = true;
  if (this->Now == Phase::Ready && this->Input.WantsCalibration)
  {
    this->Lose(exchange,
      (std::string("wants to be calibrated: its calibration button was pressed. Let the arm rest") +
        AskAgain)
        .c_str());
  }
  else if (this->Now == Phase::Ready && jumps)
  {
    this->Lose(exchange,
      (std::string("reports a jump of its arm that no hand can make, or has lost the zero of its "
                   "encoders. Check its "
                   "power, its encoders and their cables") +
        AskAgain)
        .c_str());
  }
}

void WoodenDriver::UpdatePhase(HardwareExchange& exchange)
{
  const bool isSet =
    this->Now == Phase::Presetting && !this->Input.WantsCalibration && this->IsAtRest();
  if (this->Now == Phase::Asking)
  {
    this->Now = Phase::Waiting;
    this->Report(exchange, DeviceStage::Homing, AskForRest);
  }
  else if (this->Now == Phase::Presetting && !isSet &&
    ServoClock::SecondsSince(this->PresetBegin) > PresetTime)
  {
    this->Now = Phase::Waiting;
    this->Report(exchange, DeviceStage::Homing,
      "did not accept the pose of its arm: hold the arm still in its rest pose, and press Home() "
      "again.");
  }
  if (isSet || this->Now == Phase::Ready)
  {
    DeviceSample sample;
    sample.Tip = ArmToDevice(this->Tip);
    exchange.Report(sample);
  }
  if (isSet)
  {
    this->Now = Phase::Ready;
    this->Report(exchange, DeviceStage::Ready, "");
  }
}

bool WoodenDriver::IsAtRest() const noexcept
{
  const std::array<std::int16_t, 3>& rest = this->Device.GetGeometry().RestCounts;
  bool isAtRest = true;
  for (std::size_t joint = 0; joint < rest.size(); ++joint)
  {
    isAtRest = isAtRest && std::abs(this->Input.Counts[joint] - rest[joint]) <= RestTolerance;
  }
  return isAtRest;
}

bool WoodenDriver::Send(HardwareExchange& exchange, const WoodenHaptics::Packet& packet)
{
  std::uint8_t report[LongestReport]{};
  std::copy(packet.begin(), packet.end(), report);
  this->LastSent = ServoClock::Now();
  return this->Write(exchange, report, 1 + this->OutputSize);
}

void WoodenDriver::Rest() noexcept
{
  if (!this->HasConsent)
  {
    return;
  }
  const std::uint8_t zeros[LongestReport]{};
  this->Port.Write(zeros, 1 + this->OutputSize);
}

} // namespace VolumeHaptics
