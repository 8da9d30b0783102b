// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The round trip by which stiffness and damping are capped. It follows the measured one, but
 * ignores small and short changes.
 *
 * A longer round trip counts at once, because otherwise energy might be given to the hand. A
 * shorter one lets the stiffness rise, which gives energy to a hand that presses a spring, so it
 * counts only if it lasts, and only while nothing is felt. Changes by less than a fifth are
 * ignored.
 */
#ifndef RoundTripInUse_h
#define RoundTripInUse_h

#include <cstdint>

namespace VolumeHaptics
{

class RoundTripInUse
{
public:
  static constexpr double Margin = 1.2;
  /** Time in ns for which a shorter round trip must last. */
  static constexpr std::int64_t PatienceTime = 2000000000;

  /** Begins again with another device. */
  void Reset() noexcept { *this = RoundTripInUse(); }

  /**
   * Updates the round trip in use. `measured` (s) is the measured one, or the servo's period if
   * that is longer; 0 if it is not known. `now` is in ns. `isFelt`: whether anything is felt.
   * Returns whether the round trip in use has changed.
   */
  bool Update(double measured, std::int64_t now, bool isFelt) noexcept;

  /** Returns the round trip in use (s), or 0 if it is not known yet. */
  double Get() const noexcept { return this->Used; }

private:
  double Used = 0.0;
  /** Time (ns) at which the measured round trip became shorter; 0 if it is not shorter. */
  std::int64_t ShorterSince = 0;
};

} // namespace VolumeHaptics

#endif
