// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walks the paths of a polydata, several at once.
 */
#ifndef TipPathsWalk_h
#define TipPathsWalk_h

#include "Core/Carving/TissueSnapshot.h"
#include "Core/Safety/ForceGate.h"
#include "Core/Servo/ResidentServo.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "VTK/Trace/HapticTrace.h"
#include "VTK/Trace/Paths/RecordedPath.h"
#include "VTK/Trace/Paths/TipPaths.h"

#include "vtkType.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Reads one of the paths tick by tick. The path must outlive the reader, and may have several
 * readers.
 */
class TipReader
{
public:
  TipReader(const TipPaths& paths, std::size_t path);

  /** Returns the tip at the next tick (world). Call it as often as TipPaths has ticks. */
  Vector3 Next()
  {
    ++this->Tick;
    return this->Paths.HaveTimes() ? this->FindPoint() : this->PointAt(this->Tick);
  }
  /**
   * Returns the orientation of the stylus (world) at the last tick; NoOrientation if there is none.
   */
  Quaternion GetOrientation() const
  {
    return this->Paths.HaveOrientations() ? this->ComputeOrientation() : NoOrientation;
  }
  /** Whether a burr spins at the last tick. */
  bool IsSpinning() const
  {
    const vtkIdType point = this->Paths.HaveTimes() ? this->Before : this->Tick;
    return this->Paths.IsSpinning(this->Members.At(point));
  }
  /** Returns the time of the last tick (s). */
  double GetTime() const
  {
    return this->Start + static_cast<double>(this->Tick) * this->Paths.GetPeriod();
  }

private:
  /** Computes the position at the time of the tick. */
  Vector3 FindPoint();
  /** Returns how far the tick is on the way from the point before it to the next one, 0 to 1. */
  double ComputeFraction() const;
  /** Interpolates the orientations before and after the tick. */
  Quaternion ComputeOrientation() const;
  double TimeAt(vtkIdType i) const { return this->Paths.GetTime(this->Members.At(i)); }
  Vector3 PointAt(vtkIdType i) const { return this->Paths.GetPoint(this->Members.At(i)); }

  const TipPaths& Paths;
  const TipPaths::Members Members;
  double Start = 0.0;   ///< s
  vtkIdType Tick = -1;  ///< number of the last tick
  vtkIdType Before = 0; ///< number of the last point before the tick, or at it
};

/** Finds the model for the next tick, to a tip (device), in place of the last tick's model. */
using ModelFinder = std::function<std::shared_ptr<const HapticModel>(
  std::shared_ptr<const HapticModel>, const ServoState&, const Vector3&)>;

/** Walks a tip path tick by tick, as the servo would. */
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
  ModeForces ComputeModeForces(const HapticModel& model) const;
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
  void CopyHand(const HapticModel& model);
  /**
   * Copies from a recording's tick: the spin to the state, and a request to the model's removal.
   */
  void CopyRemoval(const HapticModel& model, std::size_t i);
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

/**
 * Each path has a state of its own, and begins as if it were the only one: on the same model it
 * gives the same numbers, to the bit, whatever the number of threads. Models are immutable, and
 * all that a tick changes is in the state, so that no method needs to be left out. If tissue may be
 * removed, each path has a copy of what is left of it.
 *
 * The paths advance in rounds, between which the caller can report progress and stop. In a round,
 * threads take stretches of the paths, one by one, until it has had its ticks. If a model has to be
 * found for each tick, paths go on one after another, on the calling thread. A single path is felt
 * on the calling thread, too.
 */
class TipPathsWalk
{
public:
  TipPathsWalk(const TipPaths& paths, std::shared_ptr<const HapticModel> model,
    const HapticTrace& trace, ModelFinder finder = {});
  ~TipPathsWalk();

  bool IsDone() const { return this->TicksDone == this->Paths.GetNumberOfTicks(); }
  /** Returns the fraction of the ticks that are done, 0 to 1. */
  double GetProgress() const;
  /** Advances the paths by a round. Throws std::bad_alloc, and what the finder of models throws. */
  void Advance();
  /** Returns a tick of a recording that gave numbers that are not finite; -1 if there is none. */
  vtkIdType GetFlaw() const { return this->Flaw; }

  /**
   * Returns the tissue that is left at the end of the only path; null unless a burr went along it.
   */
  const std::vector<BrickTissue>* GetFinalTissue() const
  {
    return this->FinalTissue ? &*this->FinalTissue : nullptr;
  }
  /** Returns the written rows of the trace, for each path. */
  const std::vector<HapticTrace::Rows>& GetRows() const { return this->Rows; }

private:
  struct Runner;
  vtkIdType GetTicksLeft(std::size_t path) const;
  ///@{
  /**
   * Let paths begin, get a path to advance (null at the end of the round), and return it. Call them
   * with the mutex locked.
   */
  void Fill();
  Runner* Claim(vtkIdType& stretch);
  void GiveBack(Runner* runner);
  ///@}
  /** Advances paths until the end of the round; each thread calls this. */
  void AdvanceStretches();
  void Advance(Runner& runner, vtkIdType ticks);

  const TipPaths& Paths;
  const std::shared_ptr<const HapticModel> Model;
  const HapticTrace& Trace;
  const ModelFinder Finder;
  vtkIdType Threads = 1;
  std::size_t MostRunning = 1;
  vtkIdType RoundTicks = 0;
  std::vector<HapticTrace::Rows> Rows;
  std::atomic<vtkIdType> TicksDone{ 0 };
  vtkIdType Flaw = -1; ///< GetFlaw(), for the only path of a recording

  // These members are changed with the mutex only.
  std::mutex Mutex;
  vtkIdType RoundTicksLeft = 0;
  std::int64_t RoundEnd = 0; ///< ServoClock
  std::size_t NextPath = 0;
  std::vector<std::unique_ptr<Runner>> Running;
  bool HasFailed = false; ///< whether memory ran out
  std::optional<std::vector<BrickTissue>> FinalTissue;
};

} // namespace VolumeHaptics

#endif
