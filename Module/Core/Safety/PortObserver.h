// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects a device that runs away against its force, for example because of a wrong sign.
 *
 * The observer compares the force F that was sent, which lasts until the next one, with the
 * measured motion dx of the tip (the idea of Hannaford and Ryu, "Time-domain passivity control of
 * haptic interfaces", 2002). It does not depend on the wall. It needs every force that was sent and
 * every measurement.
 *
 * Run-away
 * --------
 *
 * With a wrong sign, F.dx is negative, as if a hand pressed. But the tip accelerates where it
 * should slow down. Let n be the direction against the force, ds the path and v the speed of the
 * tip along n, and m = LightMass, lighter than any stylus with fingers. For a hand that pushes with
 * P,
 *
 *   d(m v^2 / 2) = (P - |F|) ds,   P <= m HandAcceleration + the largest recent |F|,
 *
 * because a hand that withstands a force can push as strongly when the force falls. In a contact,
 *
 *   Work    = sum of |F| ds,
 *   Excess  = sum of d(m v^2 / 2) - (m HandAcceleration + largest |F| - |F|) ds,
 *   RunAway = min(Work, Excess).
 *
 * A contact lasts as long as there is force and the tip moves along n. RunAway may not exceed
 * ContactBound. A strong hand can push a weak device back once the force is clamped, but hardly
 * while the force rises with the motion. A second Excess therefore counts gains only while |F|
 * rises, and has the smaller RisingBound. Both bounds are more than 1.6 times the largest value in
 * 100 000 sessions with correct devices; see Documentation/evaluation.md.
 *
 * A gap in the measurements or a leap of the tip begins a new contact.
 *
 * Limits
 * ------
 *
 * Two cases are not detected: a soft wall with a wrong sign moves the tip like a hand that presses,
 * and a hand that holds a device firmly keeps it from running away. Force times motion can't
 * distinguish a wrong sign from a hand that presses; the check at the first arming can
 * (SignCheck.h). EnergyObserver.h detects a loop that oscillates by itself.
 */
#ifndef PortObserver_h
#define PortObserver_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

class PortObserver
{
public:
  static constexpr double LightMass = 0.05;        ///< kg
  static constexpr double HandAcceleration = 12.0; ///< m/s^2
  static constexpr double RisingBound = 1.2e-3;    ///< limit of GetRisingRunAway() (J)
  static constexpr double ContactBound = 2.5e-3;   ///< limit of GetRunAway() (J)

  /** Clears all data. Afterwards, force and tip are unknown. */
  void Reset() noexcept;

  /**
   * Processes a measurement of the tip (m). `time` (s) is the time since the last measurement.
   * Returns true if the device moves against the force.
   */
  bool Observe(const Vector3& tip, double time) noexcept;

  /**
   * Records the force (N) that the device exerts until the next tick. Must be called in every tick.
   */
  void RecordSent(const Vector3& force) noexcept;

  ///@{
  /**
   * Return RunAway (J) in the present contact, as explained above: with gains only while the force
   * rises, or with all gains.
   */
  double GetRisingRunAway() const noexcept;
  double GetRunAway() const noexcept;
  ///@}

private:
  struct Measurement
  {
    double Time = 0.0; ///< time in s
    Vector3 Tip;
  };
  static constexpr std::size_t Kept = 64;
  const Measurement& Last(std::size_t before = 0) const noexcept
  {
    return this->Measurements[(this->Count - 1 - before) % Kept];
  }
  void Add(const Vector3& tip) noexcept;
  void BeginAt(const Vector3& tip) noexcept;
  Vector3 EstimateVelocity() const noexcept;
  void Account(const Vector3& force, const Vector3& motion, double time) noexcept;
  void EndContact() noexcept;

  std::array<Measurement, Kept> Measurements{}; ///< a ring buffer
  std::size_t Count = 0;
  double Time = 0.0; ///< time in s
  Vector3 SentSum;   ///< sum of the forces (N) of all ticks since the last measurement
  double SentCount = 0.0;
  double LargestForce = 0.0; ///< largest force (N) in the last HandTime
  double EarlierForce = 0.0; ///< force (N), smoothed over RiseTime
  Vector3 Velocity;          ///< velocity of the tip (m/s)
  bool IsContact = false;
  double Work = 0.0;         ///< Work (J), as explained above
  double Excess = 0.0;       ///< Excess (J), as explained above
  double RisingExcess = 0.0; ///< Excess with gains only while the force rises (J)
};

} // namespace VolumeHaptics

#endif
