// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Hfab/HfabProtocol.h"

#include <algorithm>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{
/** Limit of the digits of a number; it suffices for the counts of any encoder. */
constexpr int MostDigits = 9;
} // namespace

void HfabReader::Reset() noexcept
{
  this->Field = -1;
  this->BadLines = 0;
}

bool HfabReader::Fail() noexcept
{
  this->Field = -1;
  ++this->BadLines;
  return false;
}

bool HfabReader::Receive(char byte) noexcept
{
  const bool isUnderWay = this->Field >= 0;
  if (byte == '[')
  {
    // Count a truncated answer as a bad line.
    this->BadLines += isUnderWay ? 1 : 0;
    this->Field = this->Digits = 0;
    this->IsNegative = false;
    this->Numbers = {};
    return false;
  }
  if (!isUnderWay)
  {
    return false;
  }
  int& number = this->Numbers[static_cast<std::size_t>(this->Field)];
  if (byte >= '0' && byte <= '9')
  {
    if (++this->Digits > MostDigits)
    {
      return this->Fail();
    }
    number = 10 * number + (byte - '0');
    return false;
  }
  if (byte == '-' && this->Digits == 0 && !this->IsNegative)
  {
    this->IsNegative = true;
    return false;
  }
  const bool ends = byte == ']';
  if ((byte != ',' && !ends) || this->Digits == 0 || ends != (this->Field == Fields - 1))
  {
    return this->Fail();
  }
  number = this->IsNegative ? -number : number;
  this->IsNegative = false;
  this->Digits = 0;
  ++this->Field;
  if (!ends)
  {
    return false;
  }
  this->Answer.Model = this->Numbers[0];
  std::copy(&this->Numbers[1], &this->Numbers[1] + 6, this->Answer.Counts.begin());
  this->Answer.Error = this->Numbers[Fields - 1];
  this->Field = -1;
  return true;
}

HfabMessage EncodeHfab(const std::array<int, 3>& milliamperes) noexcept
{
  HfabMessage message;
  const int size = std::snprintf(message.Bytes.data(), message.Bytes.size(), "[%d,%d,%d]\n",
    milliamperes[0], milliamperes[1], milliamperes[2]);
  message.Size = std::max(HfabMessage::LeastSize, static_cast<std::size_t>(size));
  return message;
}

} // namespace VolumeHaptics
