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
#include "VTK/Trace/HapticTipPath.h"

#include <cstddef>
#include <memory>

namespace VolumeHaptics
{

class TipPathWalk
{
public:
  TipPathWalk(const TipPath& path, double period);

  /** Computes the next tick. Returns its model: the given one, placed as the recording says. */
  std::shared_ptr<const HapticModel> Tick(
    std::shared_ptr<const HapticModel> model, TickRecord& record);
  /** Time of the last tick (s). */
  double GetTime() const;

private:
  void Step(const HapticModel& model, const Vector3& tip, TickRecord& record,
    const LocalSurfaceResult& result);

  const TipPath& Path;
  const double Period;
  std::size_t Next = 0;
  ServoState State;
  ResidentServo Servo;
  ForceGate Gate;   ///< only its opening is used
  TickRecord Whole; ///< of the last tick, with the force before the residency scales it
};

} // namespace VolumeHaptics

#endif
