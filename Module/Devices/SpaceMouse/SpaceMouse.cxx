// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/SpaceMouse/SpaceMouse.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace VolumeHaptics
{
namespace
{
constexpr std::uint16_t Logitech = 0x046D;
constexpr std::uint16_t Connexion = 0x256F;

// SpaceMouse Plus XT, CADman, SpaceMouse Classic, Spaceball 5000, SpaceTraveler, SpacePilot,
// SpaceNavigator, SpaceExplorer, SpaceNavigator for Notebooks, SpacePilot Pro, SpaceMouse Pro,
// NuLOOQ. They have Logitech's vendor number, most of whose other products are not six-axis mice.
constexpr std::uint16_t Older[] = { 0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625, 0xC626, 0xC627,
  0xC628, 0xC629, 0xC62B, 0xC640 };
// SpaceMouse Wireless (cable, receiver), Pro Wireless (cable, receiver), Enterprise, Compact,
// Module, Pro Wireless and Wireless by Bluetooth, USB, and the universal receiver.
constexpr std::uint16_t Newer[] = { 0xC62E, 0xC62F, 0xC631, 0xC632, 0xC633, 0xC635, 0xC636, 0xC638,
  0xC63A, 0xC641, 0xC652 };
constexpr std::uint16_t WithAxisUp[] = { 0xC603, 0xC606, 0xC640 };

/** A key of the SpaceMouse Enterprise: its number in the report, and its bit in Buttons. */
struct HighKey
{
  std::size_t Number;
  unsigned Bit;
};
// The keys Enter, Delete, Tab, Space, V1, V2, V3, "11", "12".
constexpr HighKey HighKeys[] = { { 36, 27 }, { 37, 28 }, { 175, 29 }, { 176, 30 }, { 103, 31 },
  { 104, 9 }, { 105, 11 }, { 77, 6 }, { 78, 7 } };

enum ReportId : std::uint8_t
{
  Pushes = 1,
  Turns = 2,
  Buttons = 3
};

void ReadAxes(const std::uint8_t* bytes, int first, int count, SpaceMouse::State& state) noexcept
{
  for (int a = 0; a < count; ++a)
  {
    const auto counts = static_cast<std::int16_t>(bytes[2 * a] | bytes[2 * a + 1] << 8);
    state.Axes[first + a] = SpaceMouse::Scale(counts);
  }
}

template <typename List>
bool Contains(const List& list, std::uint16_t product) noexcept
{
  return std::find(std::begin(list), std::end(list), product) != std::end(list);
}
} // namespace

bool SpaceMouse::IsKnown(std::uint16_t vendor, std::uint16_t product) noexcept
{
  return (vendor == Connexion && Contains(Newer, product)) ||
    (vendor == Logitech && Contains(Older, product));
}

bool SpaceMouse::HasAxisUp(std::uint16_t vendor, std::uint16_t product) noexcept
{
  return vendor == Logitech && Contains(WithAxisUp, product);
}

double SpaceMouse::Scale(int counts) noexcept
{
  const double part = std::min(1.0, std::abs(counts) / FullScale);
  const double beyond = std::max(0.0, part - DeadZone) / (1.0 - DeadZone);
  return counts < 0 ? -beyond : beyond;
}

const char* SpaceMouse::Decode(const std::uint8_t* bytes, std::size_t size, State& state) noexcept
{
  constexpr std::size_t threeAxes = 7;
  constexpr std::size_t sixAxes = 13;
  constexpr std::size_t buttonBytes = 4;
  if (size == 0)
  {
    return "an empty packet";
  }
  switch (bytes[0])
  {
    case Pushes:
      if (size != threeAxes && size != sixAxes)
      {
        return "a report 1 that has neither 7 nor 13 bytes";
      }
      ReadAxes(bytes + 1, 0, size == sixAxes ? 6 : 3, state);
      return nullptr;
    case Turns:
      if (size != threeAxes)
      {
        return "a report 2 that has not 7 bytes";
      }
      ReadAxes(bytes + 1, 3, 3, state);
      return nullptr;
    case Buttons:
      if (size < 2)
      {
        return "a report 3 without buttons";
      }
      state.Buttons = 0;
      for (std::size_t b = 0; b < std::min(size - 1, buttonBytes); ++b)
      {
        state.Buttons |= std::uint32_t{ bytes[1 + b] } << 8 * b;
      }
      for (const HighKey& key : HighKeys)
      {
        const std::size_t at = 1 + (key.Number - 1) / 8;
        const bool isHeld = at < size && (bytes[at] >> (key.Number - 1) % 8 & 1) != 0;
        state.Buttons |= isHeld ? 1U << key.Bit : 0U;
      }
      return nullptr;
    default:
      return nullptr;
  }
}

} // namespace VolumeHaptics
