// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Searches for the root of a falling function, for example for the end of a motion.
 */
#ifndef RootBracket_h
#define RootBracket_h

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

/**
 * Value for Narrow() if the function has no root up to the argument that Next() returned. The
 * bracket then begins there.
 */
constexpr double NoRoot = std::numeric_limits<double>::infinity();

/**
 * A bracket of this width (voxels) is narrow enough. A limit is needed because a material function
 * with a step may have no root.
 */
constexpr double NarrowBracket = 1e-3;

/**
 * Encloses the root of a falling function on [0, 1] (regula falsi, Illinois variant).
 *
 * Next() proposes an argument, and Narrow() receives the function's value there:
 *
 *   RootBracket bracket(f(0), f(1), length);
 *   for (int trial = 0; !bracket.IsNarrow(); ++trial)
 *   {
 *     bracket.Narrow(f(bracket.Next(trial)));
 *   }
 *
 * `length` is the length (voxels) of a motion from 0 to 1.
 */
class RootBracket
{
public:
  RootBracket(double low, double high, double voxels) noexcept
    : AtLow(low)
    , AtHigh(high)
    , Length(voxels)
    , IsOpen(high < 0.0)
  {
  }

  /** Returns true if the bracket is narrow enough, or if there is no root. */
  bool IsNarrow() const noexcept
  {
    return !this->IsOpen || (this->High - this->Low) * this->Length <= NarrowBracket;
  }
  /**
   * Returns the upper end of the bracket, where the function is negative, or 1 if there is no root.
   */
  double GetHigh() const noexcept { return this->High; }

  /** Returns the argument to evaluate next. Every third call halves the bracket. */
  double Next(int trial) noexcept
  {
    if (this->IsNarrow())
    {
      return this->Now = this->High;
    }
    const double fraction =
      trial % 3 == 2 ? 0.5 : std::clamp(this->AtLow / (this->AtLow - this->AtHigh), 0.02, 0.98);
    return this->Now = this->Low + fraction * (this->High - this->Low);
  }

  /** Narrows the bracket, given the function's value at the argument that Next() returned. */
  void Narrow(double value) noexcept
  {
    if (!this->IsOpen || this->Now >= this->High)
    {
      return;
    }
    if (value == NoRoot)
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
