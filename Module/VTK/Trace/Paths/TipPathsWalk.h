// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the ticks along the paths of a polydata, several paths in parallel.
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

/** Reads a path tick by tick. `paths` must outlive the reader. A path may have several readers. */
class TipReader
{
public:
  TipReader(const TipPaths& paths, std::size_t path);

  /** Returns the tip at the next tick (world). Call this at most once per tick of the path. */
  Vector3 Next()
  {
    ++this->Tick;
    return this->Paths.HaveTimes() ? this->FindPoint() : this->PointAt(this->Tick);
  }
  /** Returns the orientation of the stylus (world) at the last tick, or NoOrientation. */
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
  /** Interpolates the tip's position at the time of the tick. */
  Vector3 FindPoint();
  /**
   * Returns the fraction, 0 to 1, of the way from the point before the tick to the point after it.
   */
  double ComputeFraction() const;
  /** Interpolates the orientation at the time of the tick. */
  Quaternion ComputeOrientation() const;
  double TimeAt(vtkIdType i) const { return this->Paths.GetTime(this->Members.At(i)); }
  Vector3 PointAt(vtkIdType i) const { return this->Paths.GetPoint(this->Members.At(i)); }

  const TipPaths& Paths;
  const TipPaths::Members Members;
  double Start = 0.0;   ///< time of the first tick (s)
  vtkIdType Tick = -1;  ///< index of the last tick
  vtkIdType Before = 0; ///< index of the last point that is not after the tick
};

/**
 * Function that returns the model for the next tick, given the model of the last tick, the state,
 * and the tip (device).
 */
using ModelFinder = std::function<std::shared_ptr<const HapticModel>(
  std::shared_ptr<const HapticModel>, const ServoState&, const Vector3&)>;

/** Computes the ticks along a tip path one by one, like the servo. */
class TipPathWalk
{
public:
  /** With a finder, each tick uses the model that it returns. The finder must outlive the walk. */
  explicit TipPathWalk(const TipReader& tips, const ModelFinder* finder = nullptr);
  explicit TipPathWalk(const RecordedPath& recording);

  /**
   * Computes the next tick and returns the model that it used: the given model, placed as the
   * recording requires, or the model from the finder. Passes on exceptions of the finder.
   */
  std::shared_ptr<const HapticModel> Tick(std::shared_ptr<const HapticModel> model);
  /**
   * Returns whether the walk is plain: all ticks use one model of a whole volume, and read their
   * tips from a path.
   */
  bool IsPlain(const HapticModel& model) const
  {
    return this->Tips && !this->Finder && model.Resident.IsWhole();
  }
  /** Computes the next tick of a plain walk directly into a record, and does nothing else. */
  void Tick(const HapticModel& model, TickRecord& record);
  /**
   * Returns the record of the last tick. Not for plain walks, which write to the caller's record.
   */
  const TickRecord& GetRecord() const;
  /** Returns the forces of the modes in the last tick, which used `model`. */
  ModeForces ComputeModeForces(const HapticModel& model) const;
  /** Returns the orientation of the stylus (world) in the last tick, or NoOrientation. */
  Quaternion GetOrientation(const HapticModel& model) const;
  /** Returns the time of the last tick (s). */
  double GetTime() const;

private:
  /** Allocates the memory that a model's tool needs. */
  void ProvideTool(const HapticModel& model);
  /**
   * Copies the orientation, rotated to the device's axes, and the spin from a path to the state.
   */
  void CopyHand(const HapticModel& model);
  /**
   * Copies the spin in tick `i` of a recording to the state, and passes the tick's request to the
   * model's removal.
   */
  void CopyRemoval(const HapticModel& model, std::size_t i);
  /** Sets the state's orientation (device axes, or NoOrientation). */
  void SetOrientation(const Quaternion& orientation);
  void Step(const HapticModel& model, const Vector3& tip, const LocalSurfaceResult& result);

  std::optional<TipReader> Tips; ///< empty for a recording
  const ModelFinder* const Finder = nullptr;
  const RecordedPath* const Recording = nullptr;
  std::size_t Next = 0; ///< index of a recording's next tick
  ServoState State;
  ResidentServo Servo;
  TickMemory Taps;                     ///< memory for the samples that ticks of a plain walk read
  std::shared_ptr<ToolMemory> Tool;    ///< null if the tool needs none
  const BakedVolume* ToolOf = nullptr; ///< volume that the tool's memory was made for
  ForceGate Gate;                      ///< used only for its opening
  TickRecord Whole;  ///< record of the last tick, before its force is scaled by the residency
  TickRecord Scaled; ///< record with the felt force, used while the gate is not fully open
};

/**
 * Walks all paths. Each path has its own state, and begins as if it were the only one. With the
 * same model, it therefore gives bit-identical numbers on any number of threads. This holds for all
 * methods, because models are immutable, and everything that a tick changes is in the state. If
 * tissue may be removed, each path has its own copy of the remaining tissue.
 *
 * The paths advance in rounds, between which the caller can report progress or stop. In a round,
 * threads process stretches of the paths, one by one, until the round's number of ticks is reached.
 * If a model has to be found for each tick, the paths advance one after another on the calling
 * thread. A single path also advances on the calling thread.
 */
class TipPathsWalk
{
public:
  TipPathsWalk(const TipPaths& paths, std::shared_ptr<const HapticModel> model,
    const HapticTrace& trace, ModelFinder finder = {});
  ~TipPathsWalk();

  bool IsDone() const { return this->TicksDone == this->Paths.GetNumberOfTicks(); }
  /** Returns the completed fraction of all ticks, 0 to 1. */
  double GetProgress() const;
  /**
   * Advances the paths by a round. Throws std::bad_alloc, and passes on exceptions of the finder of
   * models.
   */
  void Advance();
  /** Returns the tick of a recording with a result that is not finite; -1 if there is none. */
  vtkIdType GetFlaw() const { return this->Flaw; }

  /** Returns the remaining tissue at the end of the only path; null if it had no burr. */
  const std::vector<BrickTissue>* GetFinalTissue() const
  {
    return this->FinalTissue ? &*this->FinalTissue : nullptr;
  }
  /** Returns the rows of the trace that were written for each path. */
  const std::vector<HapticTrace::Rows>& GetRows() const { return this->Rows; }

private:
  struct Runner;
  vtkIdType GetTicksLeft(std::size_t path) const;
  ///@{
  /**
   * Fill() starts further paths. Claim() returns a path to advance, or null at the end of the
   * round. GiveBack() returns a claimed path. Call them with the mutex locked.
   */
  void Fill();
  Runner* Claim(vtkIdType& stretch);
  void GiveBack(Runner* runner);
  ///@}
  /** Advances paths until the end of the round, on each thread. */
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
  vtkIdType Flaw = -1; ///< result of GetFlaw()

  // Guarded by the mutex.
  std::mutex Mutex;
  vtkIdType RoundTicksLeft = 0;
  std::int64_t RoundEnd = 0; ///< time (ServoClock) after which no stretch of this round begins
  std::size_t NextPath = 0;
  std::vector<std::unique_ptr<Runner>> Running;
  bool HasFailed = false; ///< whether memory ran out
  std::optional<std::vector<BrickTissue>> FinalTissue;
};

} // namespace VolumeHaptics

#endif
