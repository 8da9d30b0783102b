// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the ticks along the paths of a polydata, several paths at a time.
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
 * Reads one of the paths tick by tick. `paths` must outlive the reader. A path may have several
 * readers.
 */
class TipReader
{
public:
  TipReader(const TipPaths& paths, std::size_t path);

  /** Returns the tip at the next tick (world). Call it as often as the path has ticks. */
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
  /** Returns whether a burr spins at the last tick. */
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
  /** Interpolates the position at the time of the tick. */
  Vector3 FindPoint();
  /** Returns the tick's position between the points before and after it, from 0 to 1. */
  double ComputeFraction() const;
  /** Interpolates the orientations before and after the tick. */
  Quaternion ComputeOrientation() const;
  double TimeAt(vtkIdType i) const { return this->Paths.GetTime(this->Members.At(i)); }
  Vector3 PointAt(vtkIdType i) const { return this->Paths.GetPoint(this->Members.At(i)); }

  const TipPaths& Paths;
  const TipPaths::Members Members;
  double Start = 0.0;   ///< time of the first tick (s)
  vtkIdType Tick = -1;  ///< number of the last tick
  vtkIdType Before = 0; ///< number of the last point that is not after the tick
};

/**
 * A function that returns the model for the next tick, given the last tick's model, the state, and
 * the tip (device).
 */
using ModelFinder = std::function<std::shared_ptr<const HapticModel>(
  std::shared_ptr<const HapticModel>, const ServoState&, const Vector3&)>;

/** Computes the ticks along a tip path one by one, like the servo. */
class TipPathWalk
{
public:
  /**
   * If there is a finder, each tick uses the model that it finds. The finder must outlive the walk.
   */
  explicit TipPathWalk(const TipReader& tips, const ModelFinder* finder = nullptr);
  explicit TipPathWalk(const RecordedPath& recording);

  /**
   * Computes the next tick and returns the tick's model: the given model, placed as the recording
   * says, or the model that the finder returned. Throws the finder's exceptions.
   */
  std::shared_ptr<const HapticModel> Tick(std::shared_ptr<const HapticModel> model);
  /** Returns whether all ticks use one model of a whole volume, and read their tips from a path. */
  bool IsPlain(const HapticModel& model) const
  {
    return this->Tips && !this->Finder && model.Resident.IsWhole();
  }
  /** Computes the next tick of a plain walk, directly into a record, and does nothing else. */
  void Tick(const HapticModel& model, TickRecord& record);
  /** Returns the record of the last tick. Not for plain walks, which write into another record. */
  const TickRecord& GetRecord() const;
  /** Returns the forces of the modes in the last tick. `model` is the model of that tick. */
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
  /** Copies the orientation (turned to the device's axes) and the spin from a path to the state. */
  void CopyHand(const HapticModel& model);
  /**
   * Copies the spin from tick `i` of a recording to the state, and its request to the model's
   * removal.
   */
  void CopyRemoval(const HapticModel& model, std::size_t i);
  /** Sets the state's orientation, which is on the device's axes, or NoOrientation. */
  void SetOrientation(const Quaternion& orientation);
  void Step(const HapticModel& model, const Vector3& tip, const LocalSurfaceResult& result);

  std::optional<TipReader> Tips; ///< empty for a recording
  const ModelFinder* const Finder = nullptr;
  const RecordedPath* const Recording = nullptr;
  std::size_t Next = 0; ///< number of the next tick of a recording
  ServoState State;
  ResidentServo Servo;
  TickMemory Taps;                     ///< memory for the ticks of a plain walk
  std::shared_ptr<ToolMemory> Tool;    ///< null if the tool needs none
  const BakedVolume* ToolOf = nullptr; ///< the volume for which the tool's memory was made
  ForceGate Gate;                      ///< only its opening is used here
  TickRecord Whole;  ///< record of the last tick, before the residency scales its force
  TickRecord Scaled; ///< record with the felt force, while the gate is not open
};

/**
 * Walks all paths. Each path has a state of its own, and begins as if it were the only one. So on
 * the same model it gives the same numbers, to the bit, whatever the number of threads. This holds
 * for all methods, because models are immutable, and all that a tick changes is in the state. If
 * tissue may be removed, each path has its own copy of the remaining tissue.
 *
 * The paths advance in rounds, between which the caller can report progress or stop. In a round,
 * threads take stretches of the paths, one by one, until the round has had its ticks. If a model
 * has to be found for each tick, the paths advance one after another on the calling thread. A
 * single path also advances on the calling thread.
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
  /**
   * Advances the paths by a round. Throws std::bad_alloc, and the exceptions of the finder of
   * models.
   */
  void Advance();
  /** Returns the tick of a recording whose result was not finite; -1 if there is none. */
  vtkIdType GetFlaw() const { return this->Flaw; }

  /** Returns the tissue that is left at the end of the only path; null if no burr walked it. */
  const std::vector<BrickTissue>* GetFinalTissue() const
  {
    return this->FinalTissue ? &*this->FinalTissue : nullptr;
  }
  /** Returns the rows of the trace that were written, for each path. */
  const std::vector<HapticTrace::Rows>& GetRows() const { return this->Rows; }

private:
  struct Runner;
  vtkIdType GetTicksLeft(std::size_t path) const;
  ///@{
  /**
   * Fill() lets further paths begin. Claim() returns a path to advance, or null at the end of the
   * round. GiveBack() returns the path. Call them with the mutex locked.
   */
  void Fill();
  Runner* Claim(vtkIdType& stretch);
  void GiveBack(Runner* runner);
  ///@}
  /** Advances paths until the end of the round. Each thread calls this. */
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
  vtkIdType Flaw = -1; ///< the result of GetFlaw()

  // The mutex must be locked when these members are used.
  std::mutex Mutex;
  vtkIdType RoundTicksLeft = 0;
  std::int64_t RoundEnd = 0; ///< ServoClock: time after which no stretch begins in the round
  std::size_t NextPath = 0;
  std::vector<std::unique_ptr<Runner>> Running;
  bool HasFailed = false; ///< whether memory ran out
  std::optional<std::vector<BrickTissue>> FinalTissue;
};

} // namespace VolumeHaptics

#endif
