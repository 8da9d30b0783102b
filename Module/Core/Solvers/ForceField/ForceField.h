// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The force field of the paper's eq. 1: a force opposite to the gradient at the tip, with damping
 * and without a proxy.
 */
#ifndef ForceField_h
#define ForceField_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Computes a tick for record.Tip, and writes the whole record. */
void StepForceField(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept;

/** Returns the damping force (N) on a tip that has moved from `from` within one tick. */
Vector3 ComputeFieldDamping(
  const HapticModel& model, const Vector3& from, const TickRecord& record) noexcept;

/**
 * Returns the present position of the material that was at the last tick's tip, because the damping
 * acts on motion relative to the material. Returns the last tip itself if displacements are not
 * known (CarriedProxy.h).
 */
Vector3 ComputeFieldPlace(const HapticModel& model, const ServoState& state) noexcept;

/** Returns the force (N) opposite to the gradient. */
Vector3 ComputeFieldPush(const HapticModel& model, const TickRecord& record) noexcept;

/** Implements Method::Reach. */
Vector3 FindFieldReach(const HapticModel& model) noexcept;
/** Implements Method::Drag. */
Vector3 FindFieldDrag(
  const HapticModel& model, const ServoState& before, const TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
