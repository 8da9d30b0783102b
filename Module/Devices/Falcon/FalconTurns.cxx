// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconTurns.h"

#include <algorithm>

namespace VolumeHaptics
{

void FalconTurns::Sent(std::int64_t now) noexcept
{
  this->Turn = Side::Device;
  this->Owed = std::min(this->Owed + 1, MostOwed);
  this->Since = now;
}

void FalconTurns::Answered(std::int64_t now, int reports) noexcept
{
  this->Owed = std::max(this->Owed - reports, 0);
  if (this->Turn != Side::Host)
  {
    this->Turn = this->Owed > 0 || this->Doubts > 0 ? Side::Drain : Side::Host;
    this->Since = now;
  }
}

void FalconTurns::Abandon() noexcept
{
  this->Turn = Side::Host;
  this->Owed = this->Doubts = 0;
}

bool FalconTurns::CheckMissed(std::int64_t now, bool isSending) noexcept
{
  const bool missed = (this->Turn == Side::Device || isSending) && now - this->Since >= AnswerTime;
  if (missed)
  {
    this->Turn = Side::Host;
    this->Doubts = MostDoubts;
    this->Since = now;
  }
  return missed;
}

bool FalconTurns::MaySend(std::int64_t now) noexcept
{
  if (this->Turn == Side::Drain && now - this->Since >= SilentTime)
  {
    this->Doubts = this->Owed > 0 ? this->Doubts - 1 : 0;
    this->Owed = this->Doubts > 0 ? this->Owed : 0;
    this->Turn = Side::Host;
  }
  return this->Turn == Side::Host;
}

} // namespace VolumeHaptics
