// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A needle: it feels surfaces with its point, punctures them, and is then held by the tissue.
 *
 * Its axis a points from the handle to the tip. If the device measures no orientation, the axis is
 * frozen at the puncture, to the direction of the hand's motion over the last millimetre.
 *
 * **Free**, the method's own law applies. A surface is punctured when the spring breaks through it
 * along the axis. Tissue without a surface that holds is entered where R or tau resists.
 *
 * **Inserted**, with the spring k that held before the puncture, x the proxy, y the device's tip:
 *
 *   PLANE  a, T        a boundary in front of the tip, until it is punctured
 *   POINT  R           along a: the tissue that the tip cuts, only forwards
 *   shaft  F_s         along a, against motion: the integral of tau over the track
 *   LINE   a, s_l      the tissue holds the needle across its axis
 *
 * All have one anchor, and their directions are parallel or at right angles: their composition is
 * the exact minimiser. So the force along the axis is -(T + R + F_s) inserting, F_s withdrawing,
 * anything between at rest; the force across it is k times the lag, up to s_l. The tip moves in
 * steps of a quarter voxel at most, which end at boundaries between labels, to the balance.
 *
 * A puncture from R1 to R2 loses (T + R1 - R2)^2/(2(k + tau)), and so does a fall of R, with T = 0.
 * Nothing gives energy: the proxy only moves towards the tip, along the axis or across it.
 */
#ifndef NeedleTool_h
#define NeedleTool_h

#include "Core/Math/Quaternion.h"
#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{

/** Returns the direction of a stylus with a unit quaternion: the stylus's own -z. */
inline Vector3 AxisOfStylus(const Quaternion& q) noexcept
{
  return ToMatrix(q) * Vector3{ 0.0, 0.0, -1.0 };
}

/**
 * Advances an inserted needle by one tick. If the needle is withdrawn, the proxy ends at the tip,
 * free.
 */
void StepNeedle(const HapticModel& model, ServoState& state, TickRecord& record) noexcept;

/**
 * Moves the needle of a model along to another placement of the device, or releases it with another
 * tool.
 */
void CarryNeedle(const HapticModel& from, const HapticModel& to, NeedleState& needle) noexcept;

} // namespace VolumeHaptics

#endif
