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
 * next one has, but no more than the next step costs. If the centre has come to the head, and what
 * is left between the samples still holds the head, larger spheres are removed, up to a voxel.
 *
 * The time of a tick is bounded (MostBurrWork). Where more is paid for, because the head has many
 * voxels or the tissue is soft, a step goes on in the next ticks, in parts, and no energy is lost
 * meanwhile: the burr removes less than Q, and saves more than a step costs, until it catches up.
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

#include "Core/State/BurrState.h"
#include "Core/Tools/Burr/SphereCarver.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

namespace VolumeHaptics
{

/**
 * After so much work (CarvingCost) a tick begins to look at no further brick. That takes a fifth
 * of a millisecond or so, whatever the size of the burr and of the volume.
 */
constexpr std::size_t MostBurrWork = 20480;

/** The hand that holds a burr. */
struct BurrHand
{
  Vector3 Position; ///< m
  bool IsSpinning = false;
  double Step = 0.0; ///< s, since the last tick; without a step nothing is removed
};

/** What passes from tick to tick and grows with the tool. */
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
  std::size_t Work = 0;       ///< of removal; less than MostBurrWork and that of one brick
  bool IsUnfinished = false;  ///< the head has moved farther than tissue could be removed
};

/**
 * Advances the state of the burr of a model by one tick: first the forces, then what they remove.
 */
void TickBurr(const HapticModel& model, const BurrHand& hand, ShellState& shell, BurrState& state,
  const BurrMemory& memory, BurrRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
