// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A burr is a sphere that tissue holds, and that removes tissue while it spins.
 *
 * The head is a point shell (ShellCoupling.h) that does not rotate. Let F be the force that the
 * hand feels, mu the friction, v = 2 pi a n the speed of the rim, and U the specific energy of the
 * tissue. Then the burr has the power mu F v, and removes tissue at the rate
 *
 *   Q = mu F v/U.
 *
 * The burr removes spheres with the head's radius. Their centre follows the head's centre, in steps
 * of at most a quarter of a voxel, each as far as the energy pays for it. While the head is pressed
 * in, the sphere stays behind. The burr thus removes tissue in proportion to the depth, as in
 * Archard's law, and the cavity has the head's radius. Unspent energy is kept for the next tick,
 * but at most the cost of the next step. If the centre has reached the head, and tissue between the
 * samples still holds the head, larger spheres are removed, by up to a voxel.
 *
 * The work of a tick is limited (MostBurrWork). If the energy pays for more, because the head
 * covers many voxels or the tissue is soft, a step continues in the next ticks, in parts, and its
 * energy is saved. Until the burr has caught up, it removes less than Q, and saves more energy than
 * the cost of a step.
 *
 * Removal gives no energy to the hand: the contacts follow the receding surface and lose energy. A
 * closed motion of the hand creates no energy (ShellCoupling.h).
 *
 * A fraction of the force may vibrate with the frequency of the rotation. If this frequency is too
 * high to be felt, it is halved until it can be felt. The mean of the vibration is zero. The
 * vibration gives the hand at most the energy that the hand has lost to the burr before.
 */
#ifndef BurrTool_h
#define BurrTool_h

#include "Core/State/BurrState.h"
#include "Core/Tools/Burr/SphereCarver.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

namespace VolumeHaptics
{

/**
 * After this work (CarvingCost), a tick starts no more bricks. This takes about a fifth of a
 * millisecond, whatever the size of the burr and of the volume.
 */
constexpr std::size_t MostBurrWork = 20480;

/** The hand that holds a burr. */
struct BurrHand
{
  Vector3 Position; ///< position (m)
  bool IsSpinning = false;
  double Step = 0.0; ///< time since the last tick (s); with 0, nothing is removed
};

/** Memory of a burr between ticks. Larger tools need more memory. */
struct BurrMemory
{
  ShellMemory& Shell;
  SphereCarver& Carver;
};

/** The results of a tick. */
struct BurrRecord
{
  ShellRecord Shell;
  Vector3 Force;              ///< force on the hand, including the vibration (N)
  double Energy = 0.0;        ///< energy spent on removal (J)
  double RemovedVolume = 0.0; ///< volume removed in the tick (mm^3)
  std::size_t Work = 0;      ///< work of the removal; below MostBurrWork plus the work of one brick
  bool IsUnfinished = false; ///< whether tissue could not be removed as far as the head has moved
};

/** Computes a tick of the burr of a model: first the forces, then the removal. */
void TickBurr(const HapticModel& model, const BurrHand& hand, ShellState& shell, BurrState& state,
  const BurrMemory& memory, BurrRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
