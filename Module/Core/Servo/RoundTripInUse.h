// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The round trip by which stiffness and damping are capped: it follows the measured one, but not
 * every change of it.
 *
 * A longer round trip means that the hand may be given energy, so that it counts at once. A shorter
 * one would let the stiffness rise, which gives energy to a hand that rests in a spring: it counts
 * only if it lasts, and while nothing is felt. Changes by less than a fifth do not count.
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

  /** Of another device. */
  void Reset() noexcept { *this = RoundTripInUse(); }

  /**
   * The measured round trip (s; 0 if it is not known, or the servo's period if that is longer), at
   * a time `now` (ns), and whether anything is felt. True if another one is in use now.
   */
  bool Follow(double measured, std::int64_t now, bool isFelt) noexcept;

  /** s; 0 if none is known yet. */
  double Get() const noexcept { return this->Used; }

private:
  double Used = 0.0;
  std::int64_t ShorterSince = 0; ///< ns; 0 if it is not shorter
};

} // namespace VolumeHaptics

#endif
