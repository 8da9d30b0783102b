// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walks a tip path tick by tick, as the servo would.
 */
#ifndef TipPathWalk_h
#define TipPathWalk_h

#include "Core/Servo/ForceGate.h"
#include "Core/Servo/ResidentServo.h"
#include "VTK/Trace/RecordedPath.h"
#include "VTK/Trace/TipReader.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace VolumeHaptics
{

class TipPathWalk
{
public:
  explicit TipPathWalk(const TipReader& tips);
  explicit TipPathWalk(const RecordedPath& recording);

  /** Computes the next tick. Returns its model: the given one, placed as the recording says. */
  std::shared_ptr<const HapticModel> Tick(std::shared_ptr<const HapticModel> model);
  /** The record of the last tick. */
  const TickRecord& GetRecord() const;
  /** Time of the last tick (s). */
  double GetTime() const;

private:
  void Step(const HapticModel& model, const Vector3& tip, const LocalSurfaceResult& result);

  std::optional<TipReader> Tips; ///< empty for a recording
  const RecordedPath* const Recording = nullptr;
  std::size_t Next = 0; ///< of a recording
  ServoState State;
  ResidentServo Servo;
  ForceGate Gate;    ///< only its opening is used
  TickRecord Whole;  ///< of the last tick, with the force before the residency scales it
  TickRecord Scaled; ///< the same with the force that is felt, while the gate is not open
};

} // namespace VolumeHaptics

#endif
