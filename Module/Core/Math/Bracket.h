// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The search for the place where a motion has to end.
 */
#ifndef Bracket_h
#define Bracket_h

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

/** A remainder where there is nothing to go too far. */
constexpr double Nothing = std::numeric_limits<double>::infinity();

/** The nearest (voxels) that a bracket around a step of a material function gets. */
constexpr double NarrowBracket = 1e-3;

/** Finds where a falling function crosses zero between 0 and 1: regula falsi, Illinois' way. */
class Bracket
{
public:
  Bracket(double low, double high, double voxels) noexcept
    : AtLow(low)
    , AtHigh(high)
    , Length(voxels)
    , IsOpen(high < 0.0)
  {
  }

  bool IsNarrow() const noexcept
  {
    return !this->IsOpen || (this->High - this->Low) * this->Length <= NarrowBracket;
  }
  double GetHigh() const noexcept { return this->High; }

  double Next(int trial) noexcept
  {
    if (this->IsNarrow())
    {
      return this->Now = this->High;
    }
    const double share =
      trial % 3 == 2 ? 0.5 : std::clamp(this->AtLow / (this->AtLow - this->AtHigh), 0.02, 0.98);
    return this->Now = this->Low + share * (this->High - this->Low);
  }

  void Narrow(double value) noexcept
  {
    if (!this->IsOpen || this->Now >= this->High)
    {
      return;
    }
    if (value == Nothing)
    {
      this->Low = this->Now;
    }
    else if (value < 0.0)
    {
      this->High = this->Now;
      this->AtHigh = value;
      this->AtLow *= this->LastWasHigh ? 0.5 : 1.0;
      this->LastWasHigh = true;
    }
    else
    {
      this->Low = this->Now;
      this->AtLow = value;
      this->AtHigh *= this->LastWasHigh ? 1.0 : 0.5;
      this->LastWasHigh = false;
    }
  }

private:
  double Low = 0.0;
  double High = 1.0;
  double Now = 1.0;
  double AtLow;
  double AtHigh;
  double Length;
  bool IsOpen;
  bool LastWasHigh = true;
};

} // namespace VolumeHaptics

#endif
