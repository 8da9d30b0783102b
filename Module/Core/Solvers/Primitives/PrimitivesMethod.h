// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * HapticMethod::Primitives: the hand feels vectors, tensors, ridges, guides and surfaces by modes.
 *
 * The proxy moves to the balance of the model's modes (ModePrimitives.h) and a spring with the
 * CouplingStiffness (PrimitiveFollower.h). Where no mode holds it, the proxy moves freely.
 */
#ifndef PrimitivesMethod_h
#define PrimitivesMethod_h

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/Method.h"
#include "Core/Solvers/Primitives/ModePrimitives.h"
#include "Core/State/ServoState.h"

#include <array>

namespace VolumeHaptics
{

/**
 * Computes a tick. In the record, NormalForce is the magnitude of the whole force and Normal its
 * direction. The contact is sticking if the proxy stays, and sliding if it moves. No material is
 * recorded.
 */
void StepPrimitives(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept;

/** Implements Method::Reach. */
Vector3 FindPrimitivesReach(const HapticModel& model) noexcept;

/** The forces (N, device, on the hand) of a model's modes, in the order of the modes. */
using ModeForces = std::array<Vector3, ModeField::Most>;

/**
 * Returns the forces of the last tick, given the state after it. They are zero for other methods.
 */
ModeForces ComputeModeForces(const HapticModel& model, const ServoState& state) noexcept;

} // namespace VolumeHaptics

#endif
