// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/DriftLine.h"

namespace VolumeHaptics
{

void DriftLine::Reset() noexcept
{
  this->Count = 0;
  this->Next = 0;
}

void DriftLine::Add(const Vector3& tip, double time) noexcept
{
  // Accept a tip that is half a millisecond early, so that a tick that woke up late does not cost a
  // whole interval.
  if (this->Count > 0 && time - this->LastTime < Spacing - 5e-4)
  {
    return;
  }
  this->Entries[this->Next] = { tip, time };
  this->LastTime = time;
  this->Next = (this->Next + 1) % Capacity;
  this->Count += this->Count < Capacity ? 1 : 0;
}

void DriftLine::FitFrom(int first) noexcept
{
  constexpr double share = 1.0 / Fitted;
  this->Middle = {};
  this->MiddleTime = 0.0;
  for (int i = first; i < first + Fitted; ++i)
  {
    this->Middle += share * this->Get(i).Tip;
    this->MiddleTime += share * this->Get(i).Time;
  }
  Vector3 moment;
  double squares = 0.0;
  for (int i = first; i < first + Fitted; ++i)
  {
    const double time = this->Get(i).Time - this->MiddleTime;
    moment += time * (this->Get(i).Tip - this->Middle);
    squares += time * time;
  }
  this->Velocity = squares > 0.0 ? (1.0 / squares) * moment : Vector3{};
  Vector3 residual;
  for (int i = first; i < first + Fitted; ++i)
  {
    const Vector3 d = this->GetDistance(i);
    residual += share * Vector3{ d.X * d.X, d.Y * d.Y, d.Z * d.Z };
  }
  this->Spread = { std::sqrt(residual.X), std::sqrt(residual.Y), std::sqrt(residual.Z) };
}

Vector3 DriftLine::ComputeSurprise() noexcept
{
  this->FitFrom(0);
  Vector3 largest;
  for (int i = Fitted; i < Capacity; ++i)
  {
    const Vector3 d = this->GetDistance(i);
    largest = Most(largest, { std::fabs(d.X), std::fabs(d.Y), std::fabs(d.Z) });
  }
  return largest;
}

} // namespace VolumeHaptics
