// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A needle. Its point feels surfaces and punctures them; then the tissue holds the needle.
 *
 * The needle's axis a points from the handle to the tip. If the device does not measure an
 * orientation, the axis is set at the puncture to the direction of the hand's motion over the last
 * millimetre.
 *
 * For a **free** needle, the method's own law applies. A surface is punctured when the spring
 * breaks through it along the axis. Tissue without a surface that holds is entered where R or tau
 * resists.
 *
 * For an **inserted** needle, let k be the spring that held it before the puncture, x the proxy,
 * and y the device's tip. These primitives (Primitive.h) act on it:
 *
 *   PLANE  a, T        a boundary in front of the tip, until it is punctured
 *   POINT  R           along a: the tissue that the tip cuts, only forwards
 *   shaft  F_s         along a, against motion: the integral of tau over the track
 *   LINE   a, s_l      the tissue holds the needle across its axis
 *
 * All have the same anchor, and their directions are parallel or perpendicular, so their
 * composition is the exact minimiser. The force along the axis is therefore -(T + R + F_s) during
 * insertion, F_s during withdrawal, and any value between at rest. The force perpendicular to the
 * axis is k times the lag, up to s_l. The tip moves to the balance in steps of at most a quarter of
 * a voxel, which end at boundaries between labels.
 *
 * A puncture from R1 to R2 loses the energy (T + R1 - R2)^2/(2(k + tau)), and so does a fall of R,
 * with T = 0. The needle gives no energy to the hand: along the axis and perpendicular to it, the
 * proxy only moves towards the tip.
 */
#ifndef NeedleTool_h
#define NeedleTool_h

#include "Core/Math/Quaternion.h"
#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{

/** Returns the direction of a stylus, which is its own -z. `q` must be a unit quaternion. */
inline Vector3 AxisOfStylus(const Quaternion& q) noexcept
{
  return ToMatrix(q) * Vector3{ 0.0, 0.0, -1.0 };
}

/**
 * Computes a tick of an inserted needle. If the needle is withdrawn, the proxy is at the tip
 * afterwards, and the needle is free.
 */
void StepNeedle(const HapticModel& model, ServoState& state, TickRecord& record) noexcept;

/**
 * Moves a model's needle with the device to another placement, or releases it if the next model has
 * another tool.
 */
void CarryNeedle(const HapticModel& from, const HapticModel& to, NeedleState& needle) noexcept;

} // namespace VolumeHaptics

#endif
