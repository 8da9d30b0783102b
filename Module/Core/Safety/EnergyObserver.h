// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects a loop of device, hand and wall that oscillates by itself. The hand feels such a wall
 * buzz.
 *
 * A sampled spring with stiffness k, period T and a delay d of the force gives more energy than it
 * takes. The observer sums up the energy that the device's port gives to the hand (Hannaford and
 * Ryu, "Time-domain passivity control of haptic interfaces", 2002),
 *
 *   E = sum of F.dx,
 *
 * where F is the force that was sent and lasts until the next one, and dx is the measured motion. E
 * does not depend on the wall, unless the wall moves by itself: the work of the wall on the spring
 * may rightly reach the hand, and is not counted in E. The observer needs every force that was sent
 * and every measurement.
 *
 * Cycles
 * ------
 *
 * With a mass m and a damping b, a tip that swings by A with w = sqrt(k / m) puts S = k A^2 / 2
 * into the spring and gets it back. In addition, it gets in each cycle
 *
 *   2 pi S w (d + T / 2),   of which friction takes   2 pi S b / (m w).
 *
 * In a cycle, the swing therefore changes by the factor
 *
 *   r = exp(2 pi (w (d + T / 2) - b / (m w))),                                                 (1)
 *
 * and grows if b < k (d + T / 2), which is k > 2 b / T without a delay. If a hand presses the tip
 * with F at the same time, E swings by 2 F A, and its swing changes by the square root of r. A free
 * swing of a stable loop decays, even faster if a hand holds the device. A hand can sustain a
 * swing, but no hand moves to and fro faster than 12 Hz: voluntary motions end near 8 Hz, and
 * tremor is at 8 to 12 Hz. The observer therefore looks for the cycles of E, from one maximum to
 * the next, and counts consecutive cycles that
 *
 * - take at most LongestCycle, because no hand is that fast;
 * - end near the place where they began, closer than half of their path, because a tip that is
 *   drawn over a rippled surface moves on;
 * - are longer than LeastPath, because the steps of an encoder make shorter ones;
 * - give back at least LeastShare of the largest cycle in the row, because taps do not continue by
 *   themselves;
 * - are not driven by a wall that moves to and fro, whose work is at most MostDriven of the energy
 *   that they give back.
 *
 * The port *gives energy* if the last Cycles of a row
 *
 * - together give back at least LeastEnergy, and LeastReturn of the energy that they took, because
 *   friction and drag of the wall, as in stick and slip, take more;
 * - do not decay: their second half gives back at least LeastLasting of the energy of the first
 *   half.
 *
 * By (1), a free swing of a stable loop decays if r^(Cycles / 4) < LeastLasting, which is r <
 * 0.975, for example at 13 Hz and more with b > 1.3 k (d + T / 2) and d + T / 2 >= 0.17 ms.
 *
 * FewCycles are enough if the product of their ratios given / taken is at least MuchGiven. E
 * contains a part of the gain, at most g = exp(2 pi w T / 2) in a cycle, so (1) gives r <= g^-0.3
 * if b > 1.3 k (d + T / 2). Then r^(FewCycles / 4) <= MuchGiven^-0.075 = 0.90 < LeastLasting.
 *
 * If the force changes for a reason other than the motion of the tip (a new model, the gate's
 * share), the change may rightly add energy. Excuse() then begins a new row. So do a gap in the
 * measurements and a leap of the tip. A swing below LeastSwing counts as rest.
 *
 * Limits
 * ------
 *
 * The observer can't distinguish a loop that swings more slowly than LongestCycle from a hand, and
 * does not observe a wall that is published again every few ticks. A device with a wrong sign does
 * not oscillate; PortObserver.h detects it.
 */
#ifndef EnergyObserver_h
#define EnergyObserver_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

class EnergyObserver
{
public:
  static constexpr double LongestCycle = 0.075; ///< longest cycle that counts (s)
  static constexpr double LeastPath = 1e-3;     ///< shortest path of a cycle, there and back (m)
  static constexpr double LeastSwing = 2e-5;    ///< smallest swing that counts (J)
  static constexpr double LeastShare = 0.7;
  static constexpr double MostDriven = 0.5;
  static constexpr double LeastLasting = 0.95;
  static constexpr double LeastReturn = 0.95;
  static constexpr double LeastEnergy = 2e-3; ///< least energy that a row gives back (J)
  static constexpr std::size_t Cycles = 8;
  static constexpr std::size_t FewCycles = 4;
  static constexpr double MuchGiven = 4.0;

  /** Clears all data. Afterwards, force and tip are unknown. */
  void Reset() noexcept;

  /** Begins a new row, because the energy has changed for a reason outside the loop. */
  void Excuse() noexcept;

  /**
   * Processes a measurement of the tip (m). `time` (s) is the time since the last measurement.
   * Returns true if the port gives energy, and then begins a new row.
   */
  bool Observe(const Vector3& tip, double time) noexcept;

  /**
   * Records the force (N) that is sent until the next tick, without its purely dissipative part,
   * and the work (J) of a wall that moves. Must be called in every tick.
   */
  void RecordSent(const Vector3& force, double wallWork = 0.0) noexcept;

  /**
   * Returns the energy (J) that the port has given since Reset. It is negative if the hand has put
   * in more than it got back.
   */
  double GetEnergy() const noexcept { return this->Energy; }
  /** Returns the number of cycles in the row. */
  std::size_t GetCount() const noexcept { return this->Count; }

private:
  struct Instant
  {
    double Time = 0.0; ///< time in s
    Vector3 Tip;
    double Energy = 0.0;   ///< energy E (J)
    double Path = 0.0;     ///< path of the tip (m)
    double WallWork = 0.0; ///< work of the wall (J)
  };
  Instant Now() const noexcept
  {
    return { this->Time, this->Tip, this->Energy, this->Path, this->WallWork };
  }
  bool UpdateEnergy() noexcept;
  bool CountCycle(const Instant& from, const Instant& to, double low) noexcept;
  bool IsGiving(std::size_t cycles, double leastGain) const noexcept;

  bool HasTip = false;
  double Time = 0.0;
  Vector3 Tip;
  double Path = 0.0;
  double Energy = 0.0;
  double WallWork = 0.0; ///< sum of the absolute values of the wall's work (J)
  Vector3 SentSum;       ///< sum of the forces sent in all ticks since the last measurement (N)
  double SentCount = 0.0;
  double Force = 0.0; ///< magnitude of the last force sent (N)

  bool Rises = false;   ///< whether E has risen since its last extreme
  bool HasPeak = false; ///< whether Peak is a maximum
  Instant Extreme;      ///< the highest or lowest E since it changed direction
  Instant Peak;         ///< the last maximum
  double Low = 0.0;     ///< the last minimum of E (J)
  double Swing = 0.0;   ///< the last swing of E (J)

  struct Cycle
  {
    double Taken = 0.0; ///< energy taken (J)
    double Given = 0.0; ///< energy given back (J)
  };
  std::array<Cycle, Cycles> Row{}; ///< a ring buffer of the last cycles
  std::size_t Count = 0;
  double Largest = 0.0; ///< the largest energy given back by a cycle of the row (J)
};

} // namespace VolumeHaptics

#endif
