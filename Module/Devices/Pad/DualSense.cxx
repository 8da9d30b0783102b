// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/DualSense.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

enum ReportId : std::uint8_t
{
  CableIn = 0x01,
  CableOut = 0x02,
  Wireless = 0x31 ///< number of input and output reports over Bluetooth
};

constexpr std::size_t CableInSize = 64;
constexpr std::size_t CableOutSize = 63;
constexpr std::size_t WirelessSize = 78;
constexpr std::size_t CrcSize = 4;
constexpr std::uint8_t InSeed = 0xA1;
constexpr std::uint8_t OutSeed = 0xA2;
constexpr std::uint8_t OutTag = 0x10; // a byte in every output report over Bluetooth

///@{
/** Indices of bytes in the part of an input report that is the same by cable and by Bluetooth. */
enum InPlace
{
  LeftX,
  LeftY,
  RightX,
  RightY,
  LeftTrigger,
  RightTrigger,
  Buttons = 7
};
enum OutPlace
{
  Flags = 0,
  Weak = 2,
  Strong = 3,
  MoreFlags = 38
};
///@}
constexpr std::uint8_t ClassicVibration = 1U << 0; // bit of Flags
// bit of Flags that selects motors instead of sound
constexpr std::uint8_t SelectVibration = 1U << 1;
constexpr std::uint8_t NewerClassicVibration = 1U << 2; // bit of MoreFlags
constexpr std::size_t VersionPlace = 44;                // index in the firmware report
constexpr unsigned NewerVersion = 2 << 8 | 21;

struct ButtonPlace
{
  int Byte;
  int Bit;
  std::uint32_t Button;
};
// The buttons in this order: square, cross, circle, triangle; L1, R1; create, options, both sticks;
// PS.
constexpr ButtonPlace ButtonPlaces[] = { { 0, 4, PadWest }, { 0, 5, PadSouth }, { 0, 6, PadEast },
  { 0, 7, PadNorth }, { 1, 0, PadLeftShoulder }, { 1, 1, PadRightShoulder }, { 1, 4, PadSelect },
  { 1, 5, PadStart }, { 1, 6, PadLeftStick }, { 1, 7, PadRightStick }, { 2, 0, PadMode } };

std::uint32_t ReadCrc(const std::uint8_t* bytes) noexcept
{
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | std::uint32_t{ bytes[3] } << 24;
}

PadState ReadState(const std::uint8_t* bytes) noexcept
{
  PadState state;
  state.LeftX = ScaleStick(bytes[LeftX], 0, 255);
  state.LeftY = ScaleStick(bytes[LeftY], 0, 255);
  state.RightX = ScaleStick(bytes[RightX], 0, 255);
  state.RightY = ScaleStick(bytes[RightY], 0, 255);
  state.LeftTrigger = ScaleTrigger(bytes[LeftTrigger], 0, 255);
  state.RightTrigger = ScaleTrigger(bytes[RightTrigger], 0, 255);
  for (const ButtonPlace& place : ButtonPlaces)
  {
    const bool isHeld = (bytes[Buttons + place.Byte] >> place.Bit & 1) != 0;
    state.Buttons |= isHeld ? place.Button : 0;
  }
  return state;
}

} // namespace

bool DualSense::IsKnown(std::uint16_t vendor, std::uint16_t product) noexcept
{
  return vendor == Vendor && (product == Product || product == EdgeProduct);
}

std::uint32_t DualSense::ComputeCrc(
  std::uint8_t first, const std::uint8_t* bytes, std::size_t size) noexcept
{
  constexpr std::uint32_t polynomial = 0xEDB88320; // with the lowest bit first
  std::uint32_t crc = 0xFFFFFFFF;
  const auto add = [&crc](std::uint8_t byte)
  {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit)
    {
      crc = crc >> 1 ^ ((crc & 1) != 0 ? polynomial : 0);
    }
  };
  add(first);
  std::for_each(bytes, bytes + size, add);
  return ~crc;
}

const char* DualSense::Decode(
  const std::uint8_t* bytes, std::size_t size, Link& link, PadState& state) noexcept
{
  if (size == CableInSize && bytes[0] == CableIn)
  {
    link = Link::Cable;
    state = ReadState(bytes + 1);
  }
  else if (size > 0 && bytes[0] == Wireless)
  {
    if (size != WirelessSize)
    {
      return "a report 0x31 that has not 78 bytes";
    }
    if (ComputeCrc(InSeed, bytes, size - CrcSize) != ReadCrc(bytes + size - CrcSize))
    {
      return "a report with a wrong checksum";
    }
    link = Link::Bluetooth;
    state = ReadState(bytes + 2);
  }
  return nullptr;
}

bool DualSense::HasNewerVibration(
  std::uint16_t product, const std::uint8_t* firmware, std::size_t size) noexcept
{
  return product == EdgeProduct ||
    (size >= VersionPlace + 2 && firmware[0] == FirmwareReport &&
      (firmware[VersionPlace] | firmware[VersionPlace + 1] << 8) >= static_cast<int>(NewerVersion));
}

DualSense::Report DualSense::Encode(
  Link link, bool isNewer, int strong, int weak, unsigned number) noexcept
{
  Report report;
  if (link == Link::Unknown)
  {
    return report;
  }
  const bool isWireless = link == Link::Bluetooth;
  report.Size = isWireless ? WirelessSize : CableOutSize;
  std::uint8_t* const bytes = report.Bytes.data();
  bytes[0] = isWireless ? Wireless : CableOut;
  if (isWireless)
  {
    bytes[1] = static_cast<std::uint8_t>((number & 0xF) << 4);
    bytes[2] = OutTag;
  }
  std::uint8_t* const common = bytes + (isWireless ? 3 : 1);
  common[Flags] = static_cast<std::uint8_t>(SelectVibration | (isNewer ? 0 : ClassicVibration));
  common[MoreFlags] = isNewer ? NewerClassicVibration : 0;
  common[Strong] = static_cast<std::uint8_t>(std::clamp(strong, 0, 255));
  common[Weak] = static_cast<std::uint8_t>(std::clamp(weak, 0, 255));
  if (isWireless)
  {
    const std::uint32_t crc = ComputeCrc(OutSeed, bytes, report.Size - CrcSize);
    for (std::size_t i = 0; i < CrcSize; ++i)
    {
      bytes[report.Size - CrcSize + i] = static_cast<std::uint8_t>(crc >> 8 * i);
    }
  }
  return report;
}

} // namespace VolumeHaptics
