// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A burr: a sphere that is held by tissue, and removes it while it spins.
 *
 * The head is a point shell (ShellCoupling.h) that does not turn. With the force F that the hand
 * feels, the friction mu, and the speed v = 2 pi a n of its rim, it has the power mu F v, which
 * removes tissue of specific energy U at the rate
 *
 *   Q = mu F v/U.
 *
 * What is removed is a sphere of the head's radius, whose centre follows that of the head: in steps
 * of a quarter voxel at most, each as far as the energy so far pays for. While the head is pressed
 * in, it stays behind; so tissue is removed in proportion to how deep it is pressed, as by
 * Archard's law, and the cavity that is left has the head's radius. What a tick does not spend, the
 * next one has, but no more than the next step costs.
 *
 * Removal takes nothing but the tissue: the contacts follow the surface that recedes, and lose
 * energy. A cycle of the hand creates none (ShellCoupling.h).
 *
 * A share of the force may vibrate, at the frequency of the rotation or, if that is too fast to be
 * felt, at the first half, quarter ... of it that is not. Its mean is zero. The hand gets no more
 * work of it than the hand has lost to the burr before.
 */
#ifndef BurrTool_h
#define BurrTool_h

#include "Core/Tools/Burr/SphereCarver.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

namespace VolumeHaptics
{

/** A burr; all numbers are at least 0. */
struct BurrSettings
{
  ShellSettings Shell;
  double Radius = 2e-3;   ///< a, m
  double Speed = 1000.0;  ///< n, revolutions a second
  double Friction = 0.3;  ///< mu, between burr and tissue
  double Vibration = 0.0; ///< share of the force, 0 to 1
};

/** A burr, baked for the servo tick. Immutable. */
class Burr
{
public:
  static constexpr std::size_t DefaultPoints = 1000;

  /** @param specificEnergy U, J/mm^3, against the value */
  Burr(const BurrSettings& settings, const Polyline& specificEnergy,
    std::size_t points = DefaultPoints);

  const BurrSettings Settings;
  const SpecificEnergyTable SpecificEnergy;
  const PointShell Shell;
  const double RimSpeed; ///< v, m/s
  /** Hz, that of the vibration: at most MostFrequency. */
  const double Frequency;

  static constexpr double MostFrequency = 250.0;
};

/** The state from which the next tick goes on, together with BurrMemory. */
struct BurrState
{
  ShellState Shell;
  bool IsCarving = false; ///< whether Carved is a place to go on from
  bool IsRemoved = false; ///< whether the sphere at Carved was removed
  Vector3 Carved;         ///< m, the centre of the sphere that is removed
  double Unspent = 0.0;   ///< J
  ///@{
  /** J and m, of the last steps: what a step costs. */
  double LastCost = 0.0;
  double LastWay = 0.0;
  ///@}
  double Idle = 0.0;  ///< s, since the burr last removed something
  double Phase = 0.0; ///< of the vibration, 0 to 1
  double Lost = 0.0;  ///< J, that the hand has lost, and the vibration may give back
  Vector3 Vibration;  ///< N, of the last tick
};

class BurrMemory
{
public:
  explicit BurrMemory(const Burr& burr)
    : Shell(burr.Shell)
  {
  }
  ShellMemory Shell;
  SphereCarver Carver;
};

/** The results of one tick. */
struct BurrRecord
{
  ShellRecord Shell;
  Vector3 Force;              ///< N, on the hand, with the vibration
  double Energy = 0.0;        ///< J, spent on removal
  double RemovedVolume = 0.0; ///< mm^3
  bool IsUnfinished = false;  ///< the head has moved farther than tissue could be removed
};

/**
 * Advances the state by one tick: first the requests to the removal, in whose ticks nothing is
 * felt; then the forces; then what they remove.
 * @param hand only its position counts
 * @param step s, since the last tick; without a step nothing is removed
 */
void TickBurr(const HapticModel& model, const Burr& burr, const Vector3& hand, bool isSpinning,
  double step, BurrState& state, BurrMemory& memory, BurrRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
