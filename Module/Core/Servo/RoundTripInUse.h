// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The round trip that caps stiffness and damping: it follows the measured one, but ignores small
 * and short changes.
 *
 * A longer round trip may give energy to the hand, so it counts at once. A shorter one lets the
 * stiffness rise, which gives energy to a hand that rests in a spring: it counts only if it lasts,
 * and while nothing is felt. Changes by less than a fifth do not count.
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
  static constexpr std::int64_t PatienceTime = 2000000000; ///< ns

  /** Starts anew, with another device. */
  void Reset() noexcept { *this = RoundTripInUse(); }

  /**
   * Updates the round trip in use with the measured one (s; 0 if it is not known, or the servo's
   * period if that is longer), at a time `now` (ns); `isFelt` tells whether anything is felt.
   * Returns true if the round trip in use has changed.
   */
  bool Update(double measured, std::int64_t now, bool isFelt) noexcept;

  /** Returns the round trip in use (s); 0 if it is not known yet. */
  double Get() const noexcept { return this->Used; }

private:
  double Used = 0.0;
  std::int64_t ShorterSince = 0; ///< ns, when the measured round trip became shorter; 0: it is not
};

} // namespace VolumeHaptics

#endif
