// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walks a tip path tick by tick, as the servo would.
 */
#ifndef TipPathWalk_h
#define TipPathWalk_h

#include "Core/Safety/ForceGate.h"
#include "Core/Servo/ResidentServo.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "VTK/Trace/Paths/RecordedPath.h"
#include "VTK/Trace/Paths/TipReader.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

namespace VolumeHaptics
{

/** Finds the model for the next tick, to a tip (device), in place of the last tick's model. */
using ModelFinder = std::function<std::shared_ptr<const HapticModel>(
  std::shared_ptr<const HapticModel>, const ServoState&, const Vector3&)>;

class TipPathWalk
{
public:
  /** With a finder, each tick uses the model that it finds; the finder must outlive the walk. */
  explicit TipPathWalk(const TipReader& tips, const ModelFinder* finder = nullptr);
  explicit TipPathWalk(const RecordedPath& recording);

  /**
   * Computes the next tick. Returns its model: the given model, placed as the recording says, or
   * the model that was found. Throws the finder's exceptions.
   */
  std::shared_ptr<const HapticModel> Tick(std::shared_ptr<const HapticModel> model);
  /** Whether all ticks use one model, of a whole volume, and read their tips from a path. */
  bool IsPlain(const HapticModel& model) const
  {
    return this->Tips && !this->Finder && model.Resident.IsWhole();
  }
  /** Computes the next tick of a plain walk, directly into a record. Nothing else is done. */
  void Tick(const HapticModel& model, TickRecord& record);
  /** Returns the record of the last tick, unless that tick wrote directly into one. */
  const TickRecord& GetRecord() const;
  /** Returns the forces of the modes in the last tick, with its model. */
  ModeForces FindModeForces(const HapticModel& model) const;
  /**
   * Returns the orientation of the stylus (world) in the last tick; NoOrientation if there is none.
   */
  Quaternion GetOrientation(const HapticModel& model) const;
  /** Returns the time of the last tick (s). */
  double GetTime() const;

private:
  /** Provides memory for the tool of a model. */
  void ProvideTool(const HapticModel& model);
  /**
   * Copies from a path to the state: the orientation, turned to the device's axes, and the spin.
   */
  void TakeHand(const HapticModel& model);
  /**
   * Copies from a recording's tick: the spin to the state, and a request to the model's removal.
   */
  void TakeRemoval(const HapticModel& model, std::size_t i);
  /** Sets the state's orientation, on the device's axes, or to NoOrientation. */
  void SetOrientation(const Quaternion& orientation);
  void Step(const HapticModel& model, const Vector3& tip, const LocalSurfaceResult& result);

  std::optional<TipReader> Tips; ///< empty for a recording
  const ModelFinder* const Finder = nullptr;
  const RecordedPath* const Recording = nullptr;
  std::size_t Next = 0; ///< next tick of a recording
  ServoState State;
  ResidentServo Servo;
  TickMemory Taps;                     ///< memory of a plain walk
  std::shared_ptr<ToolMemory> Tool;    ///< null if the tool needs none
  const BakedVolume* ToolOf = nullptr; ///< volume that the tool's memory was made for
  ForceGate Gate;                      ///< only its opening is used
  TickRecord Whole;  ///< record of the last tick, with the force before the residency scales it
  TickRecord Scaled; ///< record with the force that is felt, while the gate is not open
};

} // namespace VolumeHaptics

#endif
