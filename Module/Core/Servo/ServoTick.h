// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One tick of the servo, from the tip to the force on the hand.
 *
 * Offline traces and the servo loop run the same code. It neither allocates, locks nor throws. All
 * quantities are in device space (metres, newtons).
 */
#ifndef ServoTick_h
#define ServoTick_h

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/LocalSurface/LocalSurfaceSolver.h"
#include "Core/State/ServoState.h"
#include "Core/State/ToolMemory.h"

namespace VolumeHaptics
{

/**
 * Advances the state by one tick, and writes the whole record.
 *
 * The first tick after enabling sets the proxy to the tip, with zero force. If the tip is not
 * finite, or a million kilometres away, the force is zero, and the state becomes disabled. `result`
 * is only for the method LocalSurface. `memory` contains samples of the last tick, which save time.
 * `tool` is the memory of the model's tool; if it is missing, the hand feels with a point instead
 * of a tool that needs a memory. Only one thread may use `memory` and `tool`.
 */
void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record,
  const LocalSurfaceResult& result = LocalSurfaceResult::Simulated(), TickMemory* memory = nullptr,
  ToolMemory* tool = nullptr) noexcept;

/**
 * Like Tick(), for the thread that owns the model's removal, if there is one. If requests to the
 * removal are pending, serves a piece of them instead, and computes no force.
 */
void TickAndServe(const HapticModel& model, ServoState& state, const Vector3& tip,
  TickRecord& record, const LocalSurfaceResult& result, TickMemory* memory,
  ToolMemory* tool) noexcept;

/**
 * Returns the purely dissipative drag (N) in a tick's force, which opposes the hand's motion. Only
 * the method ForceField has one; it is zero for methods that pull with a spring.
 * @param before state before the tick, at its data time
 */
Vector3 ComputeDrag(
  const HapticModel& model, const ServoState& before, const TickRecord& record) noexcept;

/**
 * Moves the state from one model to the next, for example to another placement of the device. The
 * proxy stays on the volume: if the volume moves under the hand, the proxy moves with it. Between
 * regions of one volume, and between time spans of one series, the state does not change. `tool` is
 * the memory of the new model's tool.
 */
void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state,
  ToolMemory* tool = nullptr) noexcept;

} // namespace VolumeHaptics

#endif
