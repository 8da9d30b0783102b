// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds a loop of device, hand and wall that swings by itself: a wall that buzzes.
 *
 * A spring of stiffness k that is sampled with period T, and whose forces are late by d, gives more
 * energy than it takes. The observer sums up the energy that the port of the device gives to the
 * hand (Hannaford and Ryu, "Time-domain passivity control of haptic interfaces", 2002),
 *
 *   E = sum of F.dx,
 *
 * with the force F that was sent, held until the next one, and the measured motion dx. It does not
 * depend on the wall, unless the wall moves by itself: the work of the wall on the spring may
 * rightly reach the hand, and is not counted in E. Pass it every force that was sent, and each
 * measurement.
 *
 * Cycles
 * ------
 *
 * On a mass m with damping b, a tip that swings by A at w = sqrt(k / m) puts S = k A^2 / 2 into the
 * spring, gets it back, and gets on top of it, in each cycle,
 *
 *   2 pi S w (d + T / 2),   of which friction takes   2 pi S b / (m w).
 *
 * So the swing changes in a cycle by the factor
 *
 *   r = exp(2 pi (w (d + T / 2) - b / (m w))),                                                 (1)
 *
 * and grows if b < k (d + T / 2), which is k > 2 b / T without a delay. If the tip is pressed by F
 * meanwhile, E swings by 2 F A, and changes by the root of r. A free swing of a stable loop decays,
 * and a hand that holds the device takes more still. A hand can keep a swing going, but no hand
 * moves to and fro faster than 12 Hz: voluntary motions end near 8 Hz, and tremor is at 8 to 12 Hz.
 * So the observer looks for the cycles of E, from one maximum to the next, and counts those in a
 * row that
 *
 * - take at most LongestCycle: no hand makes them;
 * - end near the place at which they began, by less than half of their path: a tip that is drawn
 *   over a rippled surface moves on;
 * - are longer than LeastPath, which the steps of an encoder make by themselves;
 * - give back at least LeastShare of the largest in the row: taps do not go on by themselves;
 * - are not driven by a wall that moves to and fro: its work is at most MostDriven of what they
 *   give back.
 *
 * The port *gives energy* if the last Cycles of a row
 *
 * - together gave back LeastEnergy, and LeastReturn of what they took: friction and drag of the
 *   wall, as in stick and slip, take more;
 * - do not decay: their second half gives back at least LeastLasting of what the first half does.
 *
 * By (1) a free swing of a stable loop does decay if r^(Cycles / 4) < LeastLasting, which is r <
 * 0.975, for example at 13 Hz and more with b > 1.3 k (d + T / 2) and d + T / 2 >= 0.17 ms.
 *
 * The last FewCycles are enough if the product of their given / taken is at least MuchGiven. E has
 * a part of the gain, at most g = exp(2 pi w T / 2) in a cycle, and so (1) gives r <= g^-0.3 if b >
 * 1.3 k (d + T / 2). Then r^(FewCycles / 4) <= MuchGiven^-0.075 = 0.90 < LeastLasting.
 *
 * If the force changes for another reason than the motion of the tip (a new model, the gate's
 * share), that may add energy rightly: call Excuse, and the row begins anew. A gap in the
 * measurements and a leap do so by themselves. A swing of less than LeastSwing counts as rest.
 *
 * Limits
 * ------
 *
 * The observer can't tell a loop that swings more slowly than LongestCycle from a hand, and does
 * not observe a wall that is published anew every few ticks. A wrong sign does not swing:
 * PortObserver.h.
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
  static constexpr double LongestCycle = 0.075; ///< s
  static constexpr double LeastPath = 1e-3;     ///< m, there and back
  static constexpr double LeastSwing = 2e-5;    ///< J
  static constexpr double LeastShare = 0.7;
  static constexpr double MostDriven = 0.5;
  static constexpr double LeastLasting = 0.95;
  static constexpr double LeastReturn = 0.95;
  static constexpr double LeastEnergy = 2e-3; ///< J
  static constexpr std::size_t Cycles = 8;
  static constexpr std::size_t FewCycles = 4;
  static constexpr double MuchGiven = 4.0;

  /** Clears everything: force and tip are unknown. */
  void Reset() noexcept;

  /** Excuses the energy so far as no fault of the loop: the row begins anew. */
  void Excuse() noexcept;

  /**
   * Processes a measurement of the tip (m), with the time (s) since the last measurement. Returns
   * true if the port gives energy; the row then begins anew.
   */
  bool Observe(const Vector3& tip, double time) noexcept;

  /**
   * Records the force (N) until the next tick, without its purely dissipative part, and the work
   * (J) of a wall that moves. Called in every tick.
   */
  void RecordSent(const Vector3& force, double wallWork = 0.0) noexcept;

  /**
   * Returns the energy (J) that the port itself has given since Reset; below zero, the hand has put
   * it in.
   */
  double GetEnergy() const noexcept { return this->Energy; }
  /** Returns the number of cycles in the row. */
  std::size_t GetCount() const noexcept { return this->Count; }

private:
  struct Instant
  {
    double Time = 0.0; ///< s
    Vector3 Tip;
    double Energy = 0.0;   ///< J
    double Path = 0.0;     ///< m
    double WallWork = 0.0; ///< J
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
  double WallWork = 0.0; ///< J, the sum of absolute values
  Vector3 SentSum;       ///< N, the sum of the forces sent in all ticks since the last measurement
  double SentCount = 0.0;
  double Force = 0.0; ///< N, the last force sent

  bool Rises = false;   ///< whether E rises since its last extreme
  bool HasPeak = false; ///< whether Peak is a maximum
  Instant Extreme;      ///< the highest or lowest E since its direction changed
  Instant Peak;         ///< the last maximum
  double Low = 0.0;     ///< J, the last minimum
  double Swing = 0.0;   ///< J, the last swing

  struct Cycle
  {
    double Taken = 0.0; ///< J
    double Given = 0.0; ///< J
  };
  std::array<Cycle, Cycles> Row{}; ///< a ring of the last cycles
  std::size_t Count = 0;
  double Largest = 0.0; ///< J, the largest energy given back in the row
};

} // namespace VolumeHaptics

#endif
