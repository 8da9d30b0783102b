// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Carries the proxy along with a volume that moves.
 *
 * The material law knows the tip's motion only: a wall that comes would sweep through a resting
 * hand unfelt. So before each tick the proxy x_p goes along with the surface, which is a level of
 * V(x, t):
 *
 *   V(x_p, t + dt) = L,
 *
 * where L is the level of the surface that holds the proxy (PreciseState::Level); or V(x_p, t),
 * where none holds it but one could, because T_N W_d > 0. Then the law follows, with the tip where
 * it is: beyond T_N W_d the proxy slips through the surface, so that a wall never pushes more
 * strongly than it holds, and outward the proxy is free.
 *
 * The proxy moves along the gradient: along the surface, values do not tell how the volume moves.
 * Levels of PRECISE are the estimator's, which come with their gradients: Newton's method. Those
 * of PAPER are V, whose slope is another one: the secant method. If displacements tell more
 * (BakedVolume::FollowMaterial), proxy and reached tip first go along with the material, wherever
 * they are; so a volume that moves as a whole is felt as the tip's opposite motion: surfaces take
 * a hand along that friction holds, and a medium drags it. The level then only corrects what the
 * displacements leave.
 *
 * By the level, the proxy does not move inward past the tip, since a surface pushes and never
 * pulls. Surfaces that labels make stand still, and where they are felt, so does the material.
 */
#ifndef CarriedProxy_h
#define CarriedProxy_h

#include "Core/Law/MaterialLaw.h"
#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

#include <optional>

namespace VolumeHaptics
{

/** The volume at the proxy after it was carried. */
struct CarriedProxy
{
  Vector3 Shift;     ///< with the material, m
  Vector3 Motion;    ///< by the level, m
  double Work = 0.0; ///< J, of the wall against the spring
  /** Through the proxy, with an ascending normal; none if the volume has not changed there. */
  std::optional<Surface> There;
};

/**
 * Moves state.Proxy (and with the material state.Precise.ReachedTip) from data time state.CarriedTo
 * to state.DataTime, when the volume is as `now`. For a volume that moves, and a state that is
 * enabled.
 */
CarriedProxy CarryProxy(
  const HapticModel& model, ServoState& state, const FieldAtTime& now, TickMemory* memory) noexcept;

} // namespace VolumeHaptics

#endif
