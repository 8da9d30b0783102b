// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Hid/HidField.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{
bool Fits(const HidField& field, std::size_t size) noexcept
{
  return field.BitSize >= 1 && field.BitSize <= 32 &&
    std::uint64_t{ field.BitOffset } + field.BitSize <= std::uint64_t{ size } * 8;
}
} // namespace

std::int64_t ClampToField(const HidField& field, std::int64_t value) noexcept
{
  const std::int64_t span = std::int64_t{ 1 } << field.BitSize;
  const std::int64_t least = field.IsSigned ? -span / 2 : 0;
  const std::int64_t most = least + span - 1;
  value = std::max(std::min(value, field.LogicalMaximum), field.LogicalMinimum);
  return std::max(std::min(value, most), least);
}

bool ReadRaw(const HidField& field, const std::uint8_t* payload, std::size_t size,
  std::int64_t& value) noexcept
{
  value = 0;
  if (!Fits(field, size))
  {
    return false;
  }
  for (unsigned bit = 0; bit < field.BitSize; ++bit)
  {
    const std::size_t at = std::size_t{ field.BitOffset } + bit;
    value |= std::int64_t{ payload[at / 8] >> at % 8 & 1 } << bit;
  }
  const std::int64_t span = std::int64_t{ 1 } << field.BitSize;
  if (field.IsSigned && value >= span / 2)
  {
    value -= span;
  }
  return true;
}

bool ReadValue(const HidField& field, const std::uint8_t* payload, std::size_t size,
  std::int64_t& value) noexcept
{
  return ReadRaw(field, payload, size, value) && value >= field.LogicalMinimum &&
    value <= field.LogicalMaximum;
}

bool WriteRaw(
  const HidField& field, std::uint8_t* payload, std::size_t size, std::int64_t value) noexcept
{
  if (!Fits(field, size))
  {
    return false;
  }
  const auto bits = static_cast<std::uint64_t>(value);
  for (unsigned bit = 0; bit < field.BitSize; ++bit)
  {
    const std::size_t at = std::size_t{ field.BitOffset } + bit;
    const auto mask = static_cast<std::uint8_t>(1U << at % 8);
    payload[at / 8] = static_cast<std::uint8_t>(
      (bits >> bit & 1) != 0 ? payload[at / 8] | mask : payload[at / 8] & ~mask);
  }
  return true;
}

bool WriteValue(
  const HidField& field, std::uint8_t* payload, std::size_t size, std::int64_t value) noexcept
{
  return Fits(field, size) && WriteRaw(field, payload, size, ClampToField(field, value));
}

} // namespace VolumeHaptics
