// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Moves the proxy with a moving volume.
 *
 * The material law depends only on the tip's motion, so an approaching wall would pass through a
 * resting hand unfelt. To prevent this, the proxy x_p moves with the surface before each tick. The
 * surface is a level of V(x, t):
 *
 *   V(x_p, t + dt) = L.
 *
 * L is the level of the surface that holds the proxy (PreciseState::Level). If no surface holds it
 * but one could, because T_N W_d > 0, L is V(x_p, t). Then the law is applied, with the tip at its
 * own position. If the force exceeds T_N W_d, the proxy slips through the surface, so that a wall
 * never pushes more strongly than it holds. Outward, the proxy moves freely.
 *
 * The proxy moves along the gradient, because values do not show how the volume moves along a
 * surface. Levels of the solver Precise are the estimator's, with their own gradients, so Newton's
 * method is used. Levels of the solver Paper are levels of V, whose slope differs from the
 * estimator's, so the secant method is used. If displacements are known
 * (BakedVolume::TrackMaterial), proxy and reached tip first move with the material, wherever they
 * are, and the level only corrects the remaining error. A volume that moves as a whole thus feels
 * like the opposite motion of the tip: surfaces move a hand that friction holds, and a medium drags
 * it.
 *
 * Following the level, the proxy does not move inward past the tip, because a surface pushes and
 * never pulls. Surfaces of labels do not move, nor does the material where they are felt.
 */
#ifndef CarriedProxy_h
#define CarriedProxy_h

#include "Core/Law/MaterialLaw.h"
#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

#include <optional>

namespace VolumeHaptics
{

/** The result of carrying the proxy with the volume. */
struct CarriedProxy
{
  Vector3 Shift;     ///< motion of the proxy with the material (m)
  Vector3 Motion;    ///< motion of the proxy by the level (m)
  double Work = 0.0; ///< work of the wall on the spring (J)
  /**
   * The surface through the proxy, whose normal points to higher values. None if the volume has not
   * changed there.
   */
  std::optional<Surface> There;
};

/**
 * Moves state.Proxy from the data time state.CarriedTo to state.DataTime, whose field is `now`. If
 * the material's motion is known, also moves state.Precise.ReachedTip. The volume must move, and
 * the state must be enabled.
 */
CarriedProxy CarryProxy(
  const HapticModel& model, ServoState& state, const FieldAtTime& now, TickMemory* memory) noexcept;

} // namespace VolumeHaptics

#endif
