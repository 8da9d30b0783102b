// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/RateTip.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Longest time step (s) that is integrated, so that the tip does not jump after a delay of the
 * thread.
 */
constexpr double LongestRound = 0.02;

} // namespace

void RateTip::Begin(HardwareExchange& exchange) noexcept
{
  this->Told = {};
  this->LastRound = ServoClock::Now();
  exchange.Report(this->Told);
}

void RateTip::Move(HardwareExchange& exchange, const Vector3& push, const Vector3& turn,
  std::uint32_t buttons) noexcept
{
  const double elapsed = std::min(ServoClock::SecondsSince(this->LastRound), LongestRound);
  this->LastRound = ServoClock::Now();
  DeviceSample sample;
  sample.Tip = ClampNorm(this->Told.Tip + (FullSpeed * elapsed) * push, Radius);
  sample.Buttons = buttons;
  sample.Turn = FullTurn * turn;
  const bool isNew = !IsIdentical(sample.Tip, this->Told.Tip) ||
    sample.Buttons != this->Told.Buttons || !IsIdentical(sample.Turn, this->Told.Turn);
  if (isNew)
  {
    this->Told = sample;
    exchange.Report(sample);
  }
  else
  {
    exchange.Confirm();
  }
}

} // namespace VolumeHaptics
