// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/ResidentBox.h"

namespace VolumeHaptics
{

ResidentBox::ResidentBox(const VolumeView& view, double fraction) noexcept
  : Whole(fraction == 1.0)
  , Fraction(fraction)
{
  double low[3];
  double high[3];
  for (int a = 0; a < 3; ++a)
  {
    const bool isFirst = view.First[a] <= 0;
    const bool isLast = view.Last(a) >= view.Border(a);
    low[a] = isFirst ? -HUGE_VAL : static_cast<double>(view.First[a]);
    high[a] = isLast ? HUGE_VAL : static_cast<double>(view.Last(a));
    this->Whole = this->Whole && isFirst && isLast;
  }
  this->Low = { low[0], low[1], low[2] };
  this->High = { high[0], high[1], high[2] };
}

double ResidentBox::Compute(
  const Vector3& low, const Vector3& high, const Vector3& margin) const noexcept
{
  const Vector3 before = low - margin - this->Low;
  const Vector3 behind = this->High - (high + margin);
  const Vector3 nearest = Least(before, behind);
  const double clearance = std::fmin(std::fmin(nearest.X, nearest.Y), nearest.Z);
  const double t = std::fmin(std::fmax(clearance / ResidencyBand, 0.0), 1.0);
  return this->Fraction * (t * t * (3.0 - 2.0 * t));
}

} // namespace VolumeHaptics
