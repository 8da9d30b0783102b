// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The paper's eq. 1: a force against the gradient at the tip, and damping. There is no proxy.
 */
#ifndef ForceField_h
#define ForceField_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Computes one tick from record.Tip; writes all of the record. */
void StepForceField(const HapticModel& model, ServoState& state, TickRecord& record,
  const MethodInput& input) noexcept;

/** Returns the damping force (N) on a tip that has come from a place within one tick. */
Vector3 ComputeFieldDamping(
  const HapticModel& model, const Vector3& from, const TickRecord& record) noexcept;

/**
 * Returns where the material at the last tick's tip is now: damping acts against the motion
 * relative to the material. Returns the last tip itself if displacements are not known
 * (CarriedProxy.h).
 */
Vector3 ComputeFieldPlace(const HapticModel& model, const ServoState& state) noexcept;

/** Returns the force (N) against the gradient. */
Vector3 ComputeFieldPush(const HapticModel& model, const TickRecord& record) noexcept;

/** See Method::Reach. */
Vector3 FindFieldReach(const HapticModel& model) noexcept;
/** See Method::Drag. */
Vector3 FindFieldDrag(
  const HapticModel& model, const ServoState& before, const TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
