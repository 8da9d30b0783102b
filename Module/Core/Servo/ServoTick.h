// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One tick of the servo: from the tip to the force on the hand.
 *
 * Offline traces and the servo loop run exactly this code. It neither allocates, locks nor throws.
 * Everything is in device space: metres, newtons.
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
 * Advances the state by one tick and writes all of the record, whose old contents do not matter.
 *
 * The first tick after enabling sets the proxy on the tip with zero force. A tip that is not
 * finite, or a million kilometres away, gives zero force and disables the state. `result` is for
 * LOCAL_SURFACE only. A memory of the last tick saves time; only one thread may use it. The memory
 * of the model's tool belongs to one thread, too; without it, a tool that needs a memory is felt as
 * a point.
 */
void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record,
  const LocalSurfaceResult& result = LocalSurfaceResult::Simulated(), TickMemory* memory = nullptr,
  ToolMemory* tool = nullptr) noexcept;

/**
 * Does the same as Tick, for the thread that owns the model's removal (if the model has one). If
 * requests to the removal wait, carries out a piece of them instead of feeling.
 */
void TickAndServe(const HapticModel& model, ServoState& state, const Vector3& tip,
  TickRecord& record, const LocalSurfaceResult& result, TickMemory* memory,
  ToolMemory* tool) noexcept;

/**
 * Returns the purely dissipative drag in a tick's force (N), against the hand's motion: the drag of
 * FORCE_FIELD; zero for the methods that pull with a spring.
 * @param before the state before the tick, at its data time
 */
Vector3 ComputeDrag(
  const HapticModel& model, const ServoState& before, const TickRecord& record) noexcept;

/**
 * Moves the state from one placement of the device to another. The proxy rests on the volume: if
 * the volume moves under the hand, the proxy moves along. Between regions of a volume, and between
 * parts of a series of time steps, the state stays as it is. `tool` is the memory of the new
 * model's tool.
 */
void CarryState(const HapticModel& from, const HapticModel& to, ServoState& state,
  ToolMemory* tool = nullptr) noexcept;

} // namespace VolumeHaptics

#endif
