// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Damping that is added to the force of a wall that buzzes, so that it takes energy only.
 *
 * Along the force F of the wall, with the measured speed v of the tip along F, the force becomes
 *
 *   max(0, |F| - B v).
 *
 * B is the largest damping that the device holds, but so small that the damping itself can't turn
 * the motion around before it is measured again. With the time tau by which v is late, from the
 * middle of its measurement to the end of the force,
 *
 *   B <= m / (2 tau),   m = LightMass,
 *
 * since in the time tau the damping then takes at most half of the speed even of a light stylus. To
 * be sure, an account sums up the energy that the damping has taken. If it has given more than
 * MostGiven instead, there is no more damping.
 *
 * The force stays within a bound that the caller gives. It never pulls the tip into the wall, and
 * motion along the wall is free.
 */
#ifndef PortDamper_h
#define PortDamper_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

class PortDamper
{
public:
  static constexpr double LightMass = 0.05; ///< kg
  static constexpr double MostGiven = 1e-4; ///< J

  /** Clears everything, and stops damping. */
  void Reset() noexcept;

  ///@{
  /** Starts the damping, which ends when the wall has not pushed for RestTime (s). */
  static constexpr double RestTime = 0.5;
  void Engage() noexcept { this->Engaged = true; }
  bool IsEngaged() const noexcept { return this->Engaged; }
  ///@}

  /** Processes a measurement of the tip (m), with the time (s) since the last measurement. */
  void Observe(const Vector3& tip, double time) noexcept;

  /**
   * Returns the force of the wall (N) with the damping. Called in every tick of a period (s). The
   * damping makes no force larger than `most` (N). `cap` is the largest B (N s/m) that the device
   * holds; 0 if B is not limited.
   */
  Vector3 Apply(const Vector3& wall, double most, double cap, double period) noexcept;

private:
  struct Measurement
  {
    double Time = 0.0; ///< s
    Vector3 Tip;
  };
  static constexpr std::size_t Kept = 16;

  bool Engaged = false;
  std::array<Measurement, Kept> Measurements{}; ///< a ring
  std::size_t Count = 0;
  double Time = 0.0;    ///< s, time of the last measurement
  double Free = 0.0;    ///< s, since the wall last pushed
  double Taken = 0.0;   ///< J
  double Between = 0.0; ///< s, between the last two measurements
  double Span = 0.0;    ///< s, over which the velocity is averaged
  Vector3 Velocity;     ///< m/s
  Vector3 DampedSum;    ///< N, the damping of all ticks since the last measurement
  double DampedCount = 0.0;
};

} // namespace VolumeHaptics

#endif
