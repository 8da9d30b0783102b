// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/RoundTripInUse.h"

namespace VolumeHaptics
{

bool RoundTripInUse::Update(double measured, std::int64_t now, bool isFelt) noexcept
{
  if (!(measured > 0.0))
  {
    return false;
  }
  if (measured > Margin * this->Used)
  {
    this->Used = measured;
    this->ShorterSince = 0;
    return true;
  }
  if (measured * Margin >= this->Used)
  {
    this->ShorterSince = 0;
    return false;
  }
  this->ShorterSince = this->ShorterSince == 0 ? now : this->ShorterSince;
  if (isFelt || now - this->ShorterSince < PatienceTime)
  {
    return false;
  }
  this->Used = measured;
  this->ShorterSince = 0;
  return true;
}

} // namespace VolumeHaptics
