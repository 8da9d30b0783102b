// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TipPathsWalk.h"

#include "VTK/Trace/TracePart.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Long enough that handing a stretch to a thread costs nothing beside it. */
constexpr vtkIdType ShortestStretch = 1000;
/** So many rounds at most, if the paths are long. */
constexpr vtkIdType Rounds = 100;
/** So many stretches for each thread are in a round: all wait for the last one. */
constexpr std::size_t StretchesOfAThread = 16;

bool IsFiniteRecord(const TickRecord& record)
{
  return IsFinite(record.Proxy) && IsFinite(record.Force) && IsFinite(record.Normal) &&
    std::isfinite(record.NormalForce) && std::isfinite(record.FrictionForce) &&
    std::isfinite(record.DragForce);
}

} // namespace

/** A path on its way. */
struct TipPathsWalk::Runner
{
  Runner(const TipPaths& paths, std::size_t path, std::shared_ptr<const HapticModel> model,
    const ModelFinder& finder)
    : Path(path)
    , Walk(paths.GetRecording() ? TipPathWalk(*paths.GetRecording())
                                : TipPathWalk(TipReader(paths, path), finder ? &finder : nullptr))
    , Model(std::move(model))
  {
  }

  const std::size_t Path;
  TipPathWalk Walk;
  std::shared_ptr<const HapticModel> Model; ///< placed as a recording says
  WorkMeter Work;
};

TipPathsWalk::TipPathsWalk(const TipPaths& paths, std::shared_ptr<const HapticModel> model,
  const HapticTrace& trace, ModelFinder finder)
  : Paths(paths)
  , Model(std::move(model))
  , Trace(trace)
  , Finder(std::move(finder))
{
  const std::size_t count = paths.GetNumberOfPaths();
  const auto threads = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  const std::size_t most =
    this->Finder ? 1 : StretchesOfAThread * std::max<std::size_t>(1, threads);
  const auto stretches = static_cast<vtkIdType>(std::clamp<std::size_t>(count, 1, most));
  this->Stretch = std::max(ShortestStretch, paths.GetNumberOfTicks() / (Rounds * stretches));
  this->RoundTicks = stretches * this->Stretch;
  this->Rows.reserve(count);
  for (std::size_t path = 0; path < count; ++path)
  {
    this->Rows.push_back({ paths.GetFirstTick(path), 0 });
  }
}

TipPathsWalk::~TipPathsWalk() = default;

double TipPathsWalk::GetProgress() const
{
  return static_cast<double>(this->TicksDone) /
    static_cast<double>(std::max<vtkIdType>(1, this->Paths.GetNumberOfTicks()));
}

vtkIdType TipPathsWalk::GetNextStretch(std::size_t path) const
{
  return std::min(this->Stretch, this->Paths.GetNumberOfTicks(path) - this->Rows[path].Count);
}

void TipPathsWalk::Fill()
{
  vtkIdType ticks = 0;
  for (const std::unique_ptr<Runner>& runner : this->Running)
  {
    ticks += this->GetNextStretch(runner->Path);
  }
  for (; ticks < this->RoundTicks && this->NextPath < this->Rows.size(); ++this->NextPath)
  {
    if (const vtkIdType stretch = this->GetNextStretch(this->NextPath); stretch > 0)
    {
      this->Running.push_back(
        std::make_unique<Runner>(this->Paths, this->NextPath, this->Model, this->Finder));
      ticks += stretch;
    }
  }
}

void TipPathsWalk::Advance()
{
  this->Fill();
  // Threads take the stretches one by one; these two numbers also hand over what a stretch changes.
  this->Taken = 0;
  this->Finished = 0;
  const auto advance = [this](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      try
      {
        this->Advance(*this->Running[this->Taken++]);
        ++this->Finished;
      }
      catch (const std::bad_alloc&) // which no thread of VTK's may throw
      {
      }
    }
  };
  if (this->Running.size() == 1 || this->Finder)
  {
    // Here: a single path needs no thread, and a finder may throw what no thread of VTK's may.
    advance(0, static_cast<vtkIdType>(this->Running.size()));
  }
  else
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Running.size()), 1, advance);
  }
  if (this->Finished < this->Running.size())
  {
    throw std::bad_alloc();
  }
  const auto isThere = [this](const std::unique_ptr<Runner>& runner)
  { return this->GetNextStretch(runner->Path) == 0; };
  this->Running.erase(
    std::remove_if(this->Running.begin(), this->Running.end(), isThere), this->Running.end());
}

void TipPathsWalk::Advance(Runner& runner)
{
  const bool isRecording = this->Paths.GetRecording() != nullptr;
  const bool hasModes = !this->Trace.GetModeForces().empty();
  HapticTrace::Rows& rows = this->Rows[runner.Path];
  const vtkIdType ticks = this->GetNextStretch(runner.Path);
  TracePart part(this->Trace, rows.First + rows.Count, runner.Work);
  for (vtkIdType i = 0; i < ticks; ++i)
  {
    runner.Model = runner.Walk.Tick(std::move(runner.Model));
    const TickRecord& record = runner.Walk.GetRecord();
    if (isRecording && !IsFiniteRecord(record))
    {
      this->Flaw = rows.Count + i;
      return;
    }
    if (hasModes)
    {
      const ModeForces forces = runner.Walk.FindModeForces(*runner.Model);
      part.Append(*runner.Model, runner.Walk.GetTime(), record, &forces);
    }
    else
    {
      part.Append(*runner.Model, runner.Walk.GetTime(), record);
    }
  }
  part.Flush();
  rows.Count += ticks;
  this->TicksDone += ticks;
}

} // namespace VolumeHaptics
