// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/State/NeedleState.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/** Tissues belong to one stretch if their frictions differ by less than this fraction. */
constexpr double SameShaft = 0.005;
/** A friction (N per metre) above that of any tissue. */
constexpr float MostShaft = 1e12F;
/** A length (m) above that of any needle. */
constexpr float MostLength = 1e9F;

} // namespace

void NeedleTrack::Append(double depth, double shaft, std::int64_t label) noexcept
{
  const auto begin = static_cast<float>(this->Size > 0 ? depth : 0.0);
  const auto friction = static_cast<float>(shaft);
  if (this->Size > 0)
  {
    NeedleStretch& last = (*this)[this->Size - 1];
    const double most = std::max(last.Shaft, friction);
    if (last.Label == label && std::abs(last.Shaft - friction) <= SameShaft * most)
    {
      return;
    }
    if (begin <= last.Begin)
    {
      last = { last.Begin, friction, label };
      return;
    }
    if (this->Size == Most)
    {
      this->MergeTwo(depth);
    }
  }
  this->Stretches[static_cast<std::size_t>(this->Size++)] = { begin, friction, label };
}

void NeedleTrack::MergeTwo(double end) noexcept
{
  // Keep the last stretch, because the needle has just left its tissue.
  int least = 0;
  double leastCost = std::numeric_limits<double>::infinity();
  for (int i = 0; i + 1 < this->Size; ++i)
  {
    const NeedleStretch& first = (*this)[i];
    const NeedleStretch& second = (*this)[i + 1];
    const double until = i + 2 < this->Size ? (*this)[i + 2].Begin : end;
    const double length = std::min<double>(second.Begin - first.Begin, until - second.Begin);
    // Merge tissues of one label first, whatever their friction.
    const double labels = first.Label == second.Label ? 0.0 : 1e6;
    const double cost = length * (labels + std::abs(second.Shaft - first.Shaft));
    if (cost < leastCost)
    {
      least = i;
      leastCost = cost;
    }
  }
  NeedleStretch& first = (*this)[least];
  const NeedleStretch& second = (*this)[least + 1];
  const double until = least + 2 < this->Size ? (*this)[least + 2].Begin : end;
  const double ofFirst = second.Begin - first.Begin;
  const double ofSecond = until - second.Begin;
  const double whole = ofFirst + ofSecond;
  const double sum = ofFirst * first.Shaft + ofSecond * second.Shaft;
  first.Label = ofSecond > ofFirst ? second.Label : first.Label;
  first.Shaft = static_cast<float>(whole > 0.0 ? sum / whole : second.Shaft);
  for (int i = least + 1; i + 1 < this->Size; ++i)
  {
    (*this)[i] = (*this)[i + 1];
  }
  --this->Size;
}

double NeedleTrack::Sum(double depth) const noexcept
{
  double sum = 0.0;
  for (int i = 0; i < this->Size; ++i)
  {
    const double end = i + 1 < this->Size ? (*this)[i + 1].Begin : depth;
    sum += (*this)[i].Shaft * std::max(0.0, end - (*this)[i].Begin);
  }
  return sum;
}

bool NeedleTrack::IsPossible() const noexcept
{
  float last = 0.0F;
  for (int i = 0; i < Most; ++i)
  {
    const NeedleStretch& stretch = (*this)[i];
    // The comparisons are false for NaN, too.
    const bool isGood = stretch.Begin >= 0.0F && stretch.Begin < MostLength &&
      stretch.Shaft >= 0.0F && stretch.Shaft <= MostShaft;
    if (!isGood || (i < this->Size && stretch.Begin < last))
    {
      return false;
    }
    last = stretch.Begin;
  }
  return true;
}

} // namespace VolumeHaptics
