// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * HapticMethod::Primitives: feels vectors, tensors, ridges, guides and surfaces by modes.
 *
 * The proxy follows the modes of the model (ModePrimitives.h) to the balance with a spring of the
 * CouplingStiffness (PrimitiveFollower.h). It moves freely where no mode holds it.
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
 * Computes one tick. The record has the whole force as its NormalForce, along its Normal; the
 * contact is sticking if the proxy stays and sliding if it moves; and there is no material.
 */
void StepPrimitives(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept;

/** See Method::Reach. */
Vector3 FindPrimitivesReach(const HapticModel& model) noexcept;

/** The forces (N, device, on the hand) of a model's modes, in their order. */
using ModeForces = std::array<Vector3, ModeField::Most>;

/** Computes the forces of the last tick from the state after it. Zero for other methods. */
ModeForces ComputeModeForces(const HapticModel& model, const ServoState& state) noexcept;

} // namespace VolumeHaptics

#endif
