// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The round trip that determines the caps of stiffness and damping. It follows the measured round
 * trip, but ignores small and short changes.
 *
 * A longer round trip takes effect at once, because otherwise the loop might give energy to the
 * hand. A shorter one raises the stiffness, which would give energy to a hand that presses a
 * spring. It therefore takes effect only if it lasts, and only while nothing is felt. Changes by
 * less than a fifth are ignored.
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
  /** Time (ns) for which a shorter round trip must last. */
  static constexpr std::int64_t PatienceTime = 2000000000;

  /** Resets the object, for another device. */
  void Reset() noexcept { *this = RoundTripInUse(); }

  /**
   * Updates the round trip in use. `measured` (s) is the measured round trip or, if it is longer,
   * the servo's period; 0 if it is not known. `now` is in ns. `isFelt` is whether anything is felt.
   * Returns whether the round trip in use has changed.
   */
  bool Update(double measured, std::int64_t now, bool isFelt) noexcept;

  /** Returns the round trip in use (s), or 0 if it is not known yet. */
  double Get() const noexcept { return this->Used; }

private:
  double Used = 0.0;
  /** Time (ns) since which the measured round trip is shorter; 0 if it is not shorter. */
  std::int64_t ShorterSince = 0;
};

} // namespace VolumeHaptics

#endif
