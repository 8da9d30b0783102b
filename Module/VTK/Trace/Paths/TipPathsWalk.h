// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Walks the paths of a polydata, several at once.
 */
#ifndef TipPathsWalk_h
#define TipPathsWalk_h

#include "Core/Carving/ShareSnapshot.h"
#include "VTK/Trace/HapticTrace.h"
#include "VTK/Trace/Paths/TipPathWalk.h"
#include "VTK/Trace/Paths/TipPaths.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace VolumeHaptics
{

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
  /** From 0 to 1. */
  double GetProgress() const;
  /** A round. Throws std::bad_alloc, and what the finder of models throws. */
  void Advance();
  /** A tick of a recording that gave numbers that are not finite; -1 if there is none. */
  vtkIdType GetFlaw() const { return this->Flaw; }

  /** What is left of the tissue at the end of the only path, if that is of a burr; or null. */
  const std::vector<BrickShares>* GetFinalShares() const
  {
    return this->FinalShares ? &*this->FinalShares : nullptr;
  }
  /** The rows of the trace that are written, of each path. */
  const std::vector<HapticTrace::Rows>& GetRows() const { return this->Rows; }

private:
  struct Runner;
  vtkIdType GetTicksLeft(std::size_t path) const;
  ///@{
  /** Called with the mutex. Fill lets paths begin; Take returns null at the end of the round. */
  void Fill();
  Runner* Take(vtkIdType& stretch);
  void GiveBack(Runner* runner);
  ///@}
  /** Called by each thread: advances paths until the end of the round. */
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
  vtkIdType Flaw = -1; ///< of the one path of a recording

  // Changed with the mutex only.
  std::mutex Mutex;
  vtkIdType RoundTicksLeft = 0;
  std::int64_t RoundEnd = 0; ///< ServoClock
  std::size_t NextPath = 0;
  std::vector<std::unique_ptr<Runner>> Running;
  bool HasFailed = false; ///< for lack of memory
  std::optional<std::vector<BrickShares>> FinalShares;
};

} // namespace VolumeHaptics

#endif
