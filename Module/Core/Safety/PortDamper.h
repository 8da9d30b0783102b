// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Damps the force of an oscillating wall. The damping only takes energy.
 *
 * Let F be the force of the wall, and v the measured speed of the tip along F. The damped force has
 * the direction of F and the magnitude
 *
 *   max(0, |F| - B v).
 *
 * B is the largest damping that the device renders. It is limited further, so that the damping
 * itself can't reverse the motion before the motion is measured again. If tau is the delay from the
 * middle of the measurement of v to the end of the force, then
 *
 *   B <= m / (2 tau),   m = LightMass,
 *
 * because the damping then takes at most half of the speed within tau, even from a light stylus. As
 * a further check, an account sums up the energy that the damping has taken. If the damping has
 * given more than MostGiven instead, it ends.
 *
 * The caller sets a bound of the force. The damping never pulls the tip into the wall, and does not
 * affect motion along the wall.
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
  static constexpr double LightMass = 0.05; ///< m (kg)
  static constexpr double MostGiven = 1e-4; ///< energy (J) that the damping may give before it ends

  /** Clears all data and ends the damping. */
  void Reset() noexcept;

  ///@{
  /** Starts the damping. It ends when the wall has not pushed for RestTime (s). */
  static constexpr double RestTime = 0.5;
  void Engage() noexcept { this->Engaged = true; }
  bool IsEngaged() const noexcept { return this->Engaged; }
  ///@}

  /** Processes a measurement of the tip (m). `time` (s) is the time since the last measurement. */
  void Observe(const Vector3& tip, double time) noexcept;

  /**
   * Returns the damped force of the wall (N). Must be called in every tick of a period (s). Damping
   * does not raise the force above `most` (N). `cap` is the largest B (N s/m) that the device
   * renders, or 0 if the device does not limit B.
   */
  Vector3 Apply(const Vector3& wall, double most, double cap, double period) noexcept;

private:
  struct Measurement
  {
    double Time = 0.0; ///< time in s
    Vector3 Tip;
  };
  static constexpr std::size_t Kept = 16;

  bool Engaged = false;
  std::array<Measurement, Kept> Measurements{}; ///< a ring buffer
  std::size_t Count = 0;
  double Time = 0.0;    ///< time of the last measurement (s)
  double Free = 0.0;    ///< time since the wall last pushed (s)
  double Taken = 0.0;   ///< energy that the damping has taken (J)
  double Between = 0.0; ///< time between the last two measurements (s)
  double Span = 0.0;    ///< time over which the velocity is averaged (s)
  Vector3 Velocity;     ///< velocity of the tip (m/s)
  Vector3 DampedSum;    ///< sum of the damping forces (N) of all ticks since the last measurement
  double DampedCount = 0.0;
};

} // namespace VolumeHaptics

#endif
