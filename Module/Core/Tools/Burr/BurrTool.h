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
 * The burr removes spheres of the head's radius, whose centre follows the head's: in steps of a
 * quarter voxel at most, each as far as the energy so far pays for. While the head is pressed in,
 * the sphere stays behind; so tissue is removed in proportion to the pressed depth, as by Archard's
 * law, and the cavity has the head's radius. A tick passes its unspent energy to the next one, at
 * most the cost of the next step. If the centre has reached the head, and tissue between the
 * samples still holds the head, larger spheres are removed, up to a voxel.
 *
 * The time of a tick is bounded (MostBurrWork). If the energy pays for more, because the head has
 * many voxels or the tissue is soft, a step goes on in the next ticks, in parts, and keeps its
 * energy: the burr removes less than Q, and saves more than a step costs, until it catches up.
 *
 * Removal gives no energy: the contacts follow the receding surface, and lose energy. A cycle of
 * the hand creates none (ShellCoupling.h).
 *
 * A fraction of the force may vibrate, at the frequency of the rotation or, if that is too fast to
 * be felt, at the first half, quarter ... of it that can be felt. Its mean is zero. It gives the
 * hand at most the work that the hand has lost to the burr before.
 */
#ifndef BurrTool_h
#define BurrTool_h

#include "Core/State/BurrState.h"
#include "Core/Tools/Burr/SphereCarver.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

namespace VolumeHaptics
{

/**
 * The work (CarvingCost) after which a tick begins no further brick. It takes about a fifth of a
 * millisecond, whatever the size of the burr and of the volume.
 */
constexpr std::size_t MostBurrWork = 20480;

/** The hand that holds a burr. */
struct BurrHand
{
  Vector3 Position; ///< m
  bool IsSpinning = false;
  double Step = 0.0; ///< s, the time since the last tick; with 0, nothing is removed
};

/** The working memory of a burr, kept between ticks. Larger tools need more of it. */
struct BurrMemory
{
  ShellMemory& Shell;
  SphereCarver& Carver;
};

/** The results of one tick. */
struct BurrRecord
{
  ShellRecord Shell;
  Vector3 Force;              ///< N, on the hand, with the vibration
  double Energy = 0.0;        ///< J, spent on removal
  double RemovedVolume = 0.0; ///< mm^3
  std::size_t Work = 0;       ///< work of the removal; less than MostBurrWork plus one brick's work
  bool IsUnfinished = false;  ///< whether the head has moved farther than tissue could be removed
};

/** Advances the burr of a model by one tick: first the forces, then the removal. */
void TickBurr(const HapticModel& model, const BurrHand& hand, ShellState& shell, BurrState& state,
  const BurrMemory& memory, BurrRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
