// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Carries the proxy along with a volume that moves.
 *
 * The material law depends on the tip's motion only: an approaching wall would sweep through a
 * resting hand unfelt. So before each tick the proxy x_p goes along with the surface, which is a
 * level of V(x, t):
 *
 *   V(x_p, t + dt) = L,
 *
 * where L is the level of the surface that holds the proxy (PreciseState::Level); or V(x_p, t),
 * where no surface holds it but one could, because T_N W_d > 0. Then the law is applied, with the
 * tip at its place: beyond T_N W_d the proxy slips through the surface, so that a wall never pushes
 * more strongly than it holds, and outward the proxy is free.
 *
 * The proxy moves along the gradient: along the surface, values do not show how the volume moves.
 * Levels of PRECISE are the estimator's, with their own gradients: Newton's method. Levels of PAPER
 * are levels of V, whose slope differs from the estimator's: the secant method. If displacements
 * are known (BakedVolume::TrackMaterial), proxy and reached tip first move with the material,
 * wherever they are; so a volume that moves as a whole is felt as the tip's opposite motion:
 * surfaces take along a hand that friction holds, and a medium drags it. The level then only
 * corrects the remaining error.
 *
 * With the level, the proxy does not move inward past the tip, since a surface pushes and never
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

/** The volume at the carried proxy. */
struct CarriedProxy
{
  Vector3 Shift;     ///< m, the proxy's motion with the material
  Vector3 Motion;    ///< m, the proxy's motion by the level
  double Work = 0.0; ///< J, the wall's work against the spring
  /**
   * The surface through the proxy, with an ascending normal; none if the volume has not changed
   * there.
   */
  std::optional<Surface> There;
};

/**
 * Moves state.Proxy (and with the material state.Precise.ReachedTip) from data time state.CarriedTo
 * to state.DataTime, the time of `now`. For a volume that moves, and a state that is enabled.
 */
CarriedProxy CarryProxy(
  const HapticModel& model, ServoState& state, const FieldAtTime& now, TickMemory* memory) noexcept;

} // namespace VolumeHaptics

#endif
