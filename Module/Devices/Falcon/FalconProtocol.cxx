// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

namespace
{
constexpr std::uint8_t Begin = '<';
constexpr std::uint8_t End = '>';
constexpr std::uint8_t Base = 0x41;
constexpr std::size_t BitsPlace = 13;
constexpr std::size_t UnknownPlace = 14;
constexpr std::size_t EndPlace = 15;
constexpr std::uint8_t LowNibble = 0x0F;
constexpr std::uint8_t MostBits = 0x7F;
constexpr int HomedShift = 4;

FalconPacket Encode(const FalconCounts& numbers, std::uint8_t bits) noexcept
{
  FalconPacket packet;
  packet[0] = Begin;
  for (int i = 0; i < 3; ++i)
  {
    const auto word = static_cast<std::uint16_t>(numbers[i]);
    for (int nibble = 0; nibble < 4; ++nibble)
    {
      packet[1 + 4 * i + nibble] =
        static_cast<std::uint8_t>(Base + ((word >> (4 * nibble)) & LowNibble));
    }
  }
  packet[BitsPlace] = static_cast<std::uint8_t>(Base + bits);
  packet[UnknownPlace] = Base;
  packet[EndPlace] = End;
  return packet;
}

FalconFlaw Decode(
  const std::uint8_t* bytes, std::size_t size, FalconCounts& numbers, std::uint8_t& bits) noexcept
{
  if (size != FalconPacketSize)
  {
    return FalconFlaw::Length;
  }
  for (std::size_t place = 0; place < size; ++place)
  {
    const FalconFlaw flaw = FalconCheck(place, bytes[place]);
    if (flaw != FalconFlaw::None)
    {
      return flaw;
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    int word = 0;
    for (int nibble = 3; nibble >= 0; --nibble)
    {
      word = word * 16 + (bytes[1 + 4 * i + nibble] - Base);
    }
    numbers[i] = static_cast<std::int16_t>(word >= 0x8000 ? word - 0x10000 : word);
  }
  bits = static_cast<std::uint8_t>(bytes[BitsPlace] - Base);
  return FalconFlaw::None;
}
} // namespace

const char* FalconFlawText(FalconFlaw flaw) noexcept
{
  switch (flaw)
  {
    case FalconFlaw::None:
      return "nothing is wrong";
    case FalconFlaw::Length:
      return "a packet is not 16 bytes long";
    case FalconFlaw::Begin:
      return "a packet does not begin with '<'";
    case FalconFlaw::Nibble:
      return "a number in a packet has a digit that is not within 'A' to 'P'";
    case FalconFlaw::Bits:
      return "a packet's bits for buttons and homing are out of range";
    case FalconFlaw::End:
      return "a packet does not end with '>'";
  }
  return "unknown";
}

FalconFlaw FalconCheck(std::size_t place, std::uint8_t byte) noexcept
{
  switch (place)
  {
    case 0:
      return byte == Begin ? FalconFlaw::None : FalconFlaw::Begin;
    case BitsPlace:
      return byte >= Base && byte - Base <= MostBits ? FalconFlaw::None : FalconFlaw::Bits;
    case UnknownPlace:
      return FalconFlaw::None;
    case EndPlace:
      return byte == End ? FalconFlaw::None : FalconFlaw::End;
    default:
      return byte >= Base && byte - Base <= LowNibble ? FalconFlaw::None : FalconFlaw::Nibble;
  }
}

FalconPacket FalconEncode(const FalconOrder& order) noexcept
{
  return Encode(order.Motors, order.Lights & LowNibble);
}

FalconPacket FalconRunPacket(FalconOrder order) noexcept
{
  order.Lights |= FalconHome;
  return FalconEncode(order);
}

FalconPacket FalconEncode(const FalconReport& report) noexcept
{
  const int homed = (report.Homed & FalconAllHomed) << HomedShift;
  return Encode(report.Encoders, static_cast<std::uint8_t>(homed | (report.Buttons & LowNibble)));
}

FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconReport& report) noexcept
{
  std::uint8_t bits = 0;
  const FalconFlaw flaw = Decode(bytes, size, report.Encoders, bits);
  if (flaw == FalconFlaw::None)
  {
    report.Buttons = bits & LowNibble;
    report.Homed = static_cast<std::uint8_t>((bits >> HomedShift) & FalconAllHomed);
  }
  return flaw;
}

FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconOrder& order) noexcept
{
  std::uint8_t bits = 0;
  const FalconFlaw flaw = Decode(bytes, size, order.Motors, bits);
  if (flaw == FalconFlaw::None)
  {
    order.Lights = bits & LowNibble;
  }
  return flaw;
}

} // namespace VolumeHaptics
