// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/TipPathsWalk.h"

#include "Core/Realtime/ServoClock.h"
#include "Core/Servo/ServoTick.h"
#include "Core/Tools/PointShell/BakedShell.h"
#include "VTK/Base/HapticTuples.h"
#include "VTK/Trace/HapticTrace.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Computes the data time. At the hand's time 0, it is the time of the first step. It is clamped to
 * the range from the first to the last step.
 */
double ComputeDataTime(const HapticModel& model, double time)
{
  const std::vector<FieldTimeStep>& timeSteps = model.Baked->TimeSteps;
  return timeSteps.empty()
    ? 0.0
    : std::clamp(timeSteps.front().Time + model.Baked->Settings.TimeUnitsPerSecond * time,
        timeSteps.front().Time, timeSteps.back().Time);
}

/**
 * Largest number of ticks in a stretch; large enough that passing a stretch to a thread takes
 * negligible time.
 */
constexpr vtkIdType LongestStretch = 1000;
/**
 * Smallest number of ticks in a stretch. Stretches become shorter towards the end of a round,
 * because all threads wait for the last one.
 */
constexpr vtkIdType ShortestStretch = 64;
/**
 * On a single thread, a round has at least 1 / WalkRounds of all ticks, unless RoundTime ends it
 * earlier.
 */
constexpr vtkIdType WalkRounds = 100;
/**
 * On several threads, a round has at most 1 / LeastRounds of all ticks, if the paths are long
 * enough.
 */
constexpr vtkIdType LeastRounds = 8;
/** Number of paths that are in progress at a time, per thread. */
constexpr std::size_t RunnersOfAThread = 16;
/**
 * Number of ticks per thread in a round; large enough that starting and ending a round takes
 * negligible time.
 */
constexpr vtkIdType TicksOfAThread = 65536;
/**
 * Time (ns) in a round after which no further stretch begins, so that the caller can also stop slow
 * methods.
 */
constexpr std::int64_t RoundTime = 50 * ServoClock::Millisecond;

/**
 * Makes a path's own copy of the removed tissue at its beginning: that of the recording, if there
 * is one, otherwise that of the model. Returns null if there is none.
 */
std::shared_ptr<TissueRemoval> MakeOwnRemoval(
  const BakedVolume& baked, const RecordedPath* recording)
{
  const bool isRecorded = recording && std::isfinite(recording->AirValue) && !baked.IsMoving();
  if (!baked.Removal && !isRecorded)
  {
    return nullptr;
  }
  const std::vector<BrickTissue> fractions =
    recording ? recording->InitialTissue : CopyBricks(baked.Removal->Bricks);
  const bool isChanged =
    (baked.Tool && baked.Tool->RemovesTissue()) || (recording && !recording->Requests.empty());
  // If the tool removes no tissue, allocate no memory for more removed tissue.
  const auto bricks = static_cast<std::uint32_t>(std::max<std::size_t>(fractions.size(), 1));
  auto removal = isChanged
    ? std::make_shared<TissueRemoval>(std::max(bricks, CarvedBricks::DefaultMost))
    : std::make_shared<TissueRemoval>(bricks, 1);
  WriteBricks(fractions, removal->Bricks);
  return removal;
}

std::shared_ptr<const HapticModel> WithRemoval(std::shared_ptr<const HapticModel> model,
  const std::shared_ptr<TissueRemoval>& removal, const RecordedPath* recording)
{
  const BakedVolume& baked = *model->Baked;
  if (!removal || baked.Removal == removal)
  {
    return model;
  }
  const double air = recording && std::isfinite(recording->AirValue) ? recording->AirValue
                                                                     : baked.Field.GetCarved().Air;
  return std::make_shared<const HapticModel>(
    std::make_shared<const BakedVolume>(baked, removal, air), model->DeviceToWorld, model->Caps);
}

bool IsFiniteRecord(const TickRecord& record)
{
  return IsFinite(record.Proxy) && IsFinite(record.Force) && IsFinite(record.Normal) &&
    std::isfinite(record.NormalForce) && std::isfinite(record.FrictionForce) &&
    std::isfinite(record.DragForce);
}

} // namespace

TipReader::TipReader(const TipPaths& paths, std::size_t path)
  : Paths(paths)
  , Members(paths, path)
{
  if (paths.HaveTimes() && this->Members.GetSize() > 0)
  {
    this->Start = this->TimeAt(0);
  }
}

Vector3 TipReader::FindPoint()
{
  const vtkIdType last = this->Members.GetSize() - 1;
  const double snap = TipPaths::SnapFraction * this->Paths.GetPeriod();
  const double time = this->GetTime();
  while (this->Before < last && this->TimeAt(this->Before + 1) <= time + snap)
  {
    ++this->Before;
  }
  const Vector3 a = this->PointAt(this->Before);
  const double fraction = this->ComputeFraction();
  return fraction == 0.0 ? a : a + fraction * (this->PointAt(this->Before + 1) - a);
}

double TipReader::ComputeFraction() const
{
  const vtkIdType before = this->Before;
  const double since = this->GetTime() - this->TimeAt(before);
  const double snap = TipPaths::SnapFraction * this->Paths.GetPeriod();
  return before == this->Members.GetSize() - 1 || std::abs(since) <= snap
    ? 0.0
    : since / (this->TimeAt(before + 1) - this->TimeAt(before));
}

Quaternion TipReader::ComputeOrientation() const
{
  const auto at = [this](vtkIdType i) -> const Quaternion&
  { return this->Paths.GetOrientation(this->Members.At(i)); };
  if (!this->Paths.HaveTimes())
  {
    return at(this->Tick);
  }
  const Quaternion& a = at(this->Before);
  const double fraction = this->ComputeFraction();
  if (fraction == 0.0)
  {
    return a;
  }
  const Quaternion& b = at(this->Before + 1);
  if (IsIdentical(a, NoOrientation) || IsIdentical(b, NoOrientation))
  {
    return NoOrientation;
  }
  // Interpolate along the shorter arc, since q and -q are the same orientation.
  const double side = a.W * b.W + a.X * b.X + a.Y * b.Y + a.Z * b.Z < 0.0 ? -fraction : fraction;
  const double rest = 1.0 - fraction;
  const Quaternion mixed{ rest * a.W + side * b.W, rest * a.X + side * b.X, rest * a.Y + side * b.Y,
    rest * a.Z + side * b.Z };
  return (1.0 / std::sqrt(SquaredNorm(mixed))) * mixed;
}

TipPathWalk::TipPathWalk(const TipReader& tips, const ModelFinder* finder)
  : Tips(tips)
  , Finder(finder)
{
}

TipPathWalk::TipPathWalk(const RecordedPath& recording)
  : Recording(&recording)
  , State(recording.InitialState)
{
}

void TipPathWalk::Tick(const HapticModel& model, TickRecord& record)
{
  // Same computation as in ResidentServo when all samples are in memory.
  const Vector3 tip = model.WorldToDevice(this->Tips->Next());
  this->State.DataTime = ComputeDataTime(model, this->Tips->GetTime());
  this->CopyHand(model);
  this->ProvideTool(model);
  TickAndServe(model, this->State, tip, record, LocalSurfaceResult::Simulated(), &this->Taps,
    this->Tool.get());
}

void TipPathWalk::ProvideTool(const HapticModel& model)
{
  if (this->ToolOf != model.Baked.get())
  {
    this->ToolOf = model.Baked.get();
    this->Tool = ToolMemory::Provide(*model.Baked, this->Tool);
  }
}

std::shared_ptr<const HapticModel> TipPathWalk::Tick(std::shared_ptr<const HapticModel> model)
{
  if (this->Tips)
  {
    const Vector3 tip = model->WorldToDevice(this->Tips->Next());
    this->State.DataTime = ComputeDataTime(*model, this->Tips->GetTime());
    this->CopyHand(*model);
    if (this->Finder)
    {
      model = (*this->Finder)(std::move(model), this->State, tip);
    }
    this->Step(*model, tip, LocalSurfaceResult::Simulated());
    return model;
  }
  const RecordedPath& recording = *this->Recording;
  const std::size_t i = this->Next++;
  // Keep the servo's order: first the model, then enabling, then the tick.
  const int placement = recording.PlacementOf[i];
  if (i == 0 || placement != recording.PlacementOf[i - 1])
  {
    auto moved = std::make_shared<const HapticModel>(
      *model, recording.Placements[placement], recording.Caps[placement]);
    this->ProvideTool(*moved);
    if (i > 0)
    {
      CarryState(*model, *moved, this->State, this->Tool.get());
    }
    else if (this->Tool &&
      !RestoreContacts(
        *this->Tool, *moved->Baked, recording.InitialContacts, recording.ContactFraction))
    {
      // The recorded state belongs to another tool, so start with a new state for the tool in the
      // hand.
      this->State.Shell = ShellState{};
    }
    model = std::move(moved);
  }
  if (recording.Enabled[i])
  {
    this->State.Enabled = false;
  }
  if (!recording.DataTimes.empty())
  {
    this->State.DataTime = recording.DataTimes[i];
  }
  if (!recording.Orientations.empty())
  {
    this->SetOrientation(recording.Orientations[i]);
  }
  this->CopyRemoval(*model, i);
  // Use a new surface from the tick on in which the slow loop's result arrived.
  LocalSurface surface;
  LocalSurfaceResult result;
  if (recording.Renewed[i])
  {
    surface = FitLocalSurface(*model, this->State.Local.Request);
    result.Surface = &surface;
  }
  this->Step(*model, recording.Tips[i], result);
  return model;
}

void TipPathWalk::CopyRemoval(const HapticModel& model, std::size_t i)
{
  const RecordedPath& recording = *this->Recording;
  this->State.IsSpinning = !recording.Spinning.empty() && recording.Spinning[i];
  const RemovalRequest request =
    recording.Requests.empty() ? RemovalRequest::None : recording.Requests[i];
  if (request != RemovalRequest::None && model.Baked->Removal)
  {
    model.Baked->Removal->Request(request);
  }
}

void TipPathWalk::CopyHand(const HapticModel& model)
{
  if (model.Baked->Tool)
  {
    this->State.IsSpinning = this->Tips->IsSpinning();
    const Quaternion world = this->Tips->GetOrientation();
    this->SetOrientation(IsIdentical(world, NoOrientation)
        ? world
        : Conjugate(ToQuaternion(model.DeviceToWorldRotation)) * world);
  }
}

void TipPathWalk::SetOrientation(const Quaternion& orientation)
{
  this->State.HasOrientation = !IsIdentical(orientation, NoOrientation);
  this->State.Orientation = this->State.HasOrientation ? orientation : Quaternion{};
}

Quaternion TipPathWalk::GetOrientation(const HapticModel& model) const
{
  return TurnedBy(model.DeviceToWorldRotation, this->State.Orientation, this->State.HasOrientation);
}

void TipPathWalk::Step(
  const HapticModel& model, const Vector3& tip, const LocalSurfaceResult& result)
{
  this->ProvideTool(model);
  this->Servo.Tick(model, this->State, tip, model.Baked->Settings.TickPeriod, this->Whole, result,
    this->Gate, this->Tool.get());
  if (this->Gate.GetOpening() < 1.0)
  {
    this->Scaled = this->Whole;
    this->Scaled.Force = this->Gate.GetOpening() * this->Whole.Force;
    this->Scaled.Torque = this->Gate.GetOpening() * this->Whole.Torque;
  }
}

const TickRecord& TipPathWalk::GetRecord() const
{
  return this->Gate.GetOpening() < 1.0 ? this->Scaled : this->Whole;
}

ModeForces TipPathWalk::ComputeModeForces(const HapticModel& model) const
{
  ModeForces forces = VolumeHaptics::ComputeModeForces(model, this->State);
  for (Vector3& force : forces)
  {
    force = this->Gate.GetOpening() * force;
  }
  return forces;
}

double TipPathWalk::GetTime() const
{
  return this->Tips ? this->Tips->GetTime() : this->Recording->Times[this->Next - 1];
}

/** A path in progress, with its state. */
struct TipPathsWalk::Runner
{
  Runner(const TipPaths& paths, std::size_t path, std::shared_ptr<const HapticModel> model,
    const ModelFinder& finder)
    : Path(path)
    , Removal(MakeOwnRemoval(*model->Baked, paths.GetRecording()))
    , Finder(finder ? [this, &finder](std::shared_ptr<const HapticModel> felt,
                        const ServoState& state, const Vector3& tip)
          { return WithRemoval(finder(std::move(felt), state, tip), this->Removal, nullptr); }
                    : ModelFinder())
    , Walk(paths.GetRecording()
          ? TipPathWalk(*paths.GetRecording())
          : TipPathWalk(TipReader(paths, path), this->Finder ? &this->Finder : nullptr))
    , Model(WithRemoval(std::move(model), this->Removal, paths.GetRecording()))
  {
  }

  const std::size_t Path;
  /** Removal of this path alone; null if nothing is removed. */
  const std::shared_ptr<TissueRemoval> Removal;
  const ModelFinder Finder;
  TipPathWalk Walk;
  std::shared_ptr<const HapticModel> Model; ///< the model, placed as a recording requires
  WorkMeter Work;
  bool IsTaken = false; ///< whether a thread is advancing it
};

TipPathsWalk::TipPathsWalk(const TipPaths& paths, std::shared_ptr<const HapticModel> model,
  const HapticTrace& trace, ModelFinder finder)
  : Paths(paths)
  , Model(std::move(model))
  , Trace(trace)
  , Finder(std::move(finder))
{
  const std::size_t count = paths.GetNumberOfPaths();
  const vtkIdType ticks = paths.GetNumberOfTicks();
  this->Threads = this->Finder || count == 1
    ? 1
    : std::max<vtkIdType>(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  // Let only one runner per thread run if each has its own removal, which takes several megabytes.
  const std::size_t runners = this->Model->Baked->Removal ? 1 : RunnersOfAThread;
  this->MostRunning = this->Finder ? 1 : runners * static_cast<std::size_t>(this->Threads);
  const auto running = static_cast<vtkIdType>(std::clamp<std::size_t>(count, 1, this->MostRunning));
  this->RoundTicks = this->Threads == 1
    ? std::max(running * LongestStretch, ticks / WalkRounds)
    : std::clamp(ticks / LeastRounds, running * LongestStretch,
        std::max(running * LongestStretch, this->Threads * TicksOfAThread));
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

vtkIdType TipPathsWalk::GetTicksLeft(std::size_t path) const
{
  return this->Paths.GetNumberOfTicks(path) - this->Rows[path].Count;
}

void TipPathsWalk::Fill()
{
  for (; this->Running.size() < this->MostRunning && this->NextPath < this->Rows.size();
       ++this->NextPath)
  {
    if (this->GetTicksLeft(this->NextPath) > 0)
    {
      this->Running.push_back(
        std::make_unique<Runner>(this->Paths, this->NextPath, this->Model, this->Finder));
    }
  }
}

TipPathsWalk::Runner* TipPathsWalk::Claim(vtkIdType& stretch)
{
  if (this->RoundTicksLeft <= 0 || this->HasFailed || this->Flaw >= 0 ||
    ServoClock::Now() > this->RoundEnd)
  {
    return nullptr;
  }
  this->Fill();
  // Prefer the path with the most ticks left: otherwise it would be the last one, with only one
  // thread at work.
  Runner* longest = nullptr;
  vtkIdType left = 0;
  for (const std::unique_ptr<Runner>& runner : this->Running)
  {
    const vtkIdType ticks = runner->IsTaken ? 0 : this->GetTicksLeft(runner->Path);
    if (ticks > left)
    {
      longest = runner.get();
      left = ticks;
    }
  }
  if (longest)
  {
    const vtkIdType fraction =
      this->Threads == 1 ? LongestStretch : this->RoundTicksLeft / (2 * this->Threads);
    stretch = std::min(left, std::clamp(fraction, ShortestStretch, LongestStretch));
    this->RoundTicksLeft -= stretch;
    longest->IsTaken = true;
  }
  return longest;
}

void TipPathsWalk::GiveBack(Runner* runner)
{
  runner->IsTaken = false;
  if (this->GetTicksLeft(runner->Path) == 0)
  {
    const BakedTool* const tool = runner->Model->Baked->Tool.get();
    if (runner->Removal && tool && tool->RemovesTissue() && this->Rows.size() == 1)
    {
      this->FinalTissue = CopyBricks(runner->Removal->Bricks);
    }
    const auto isIt = [runner](const std::unique_ptr<Runner>& other)
    { return other.get() == runner; };
    this->Running.erase(std::find_if(this->Running.begin(), this->Running.end(), isIt));
  }
}

void TipPathsWalk::AdvanceStretches()
{
  // Locking the mutex also makes the changes of a stretch visible to the thread that continues it.
  std::unique_lock<std::mutex> lock(this->Mutex);
  vtkIdType stretch = 0;
  while (Runner* const runner = this->Claim(stretch))
  {
    lock.unlock();
    this->Advance(*runner, stretch);
    lock.lock();
    this->GiveBack(runner);
  }
}

void TipPathsWalk::Advance()
{
  this->RoundTicksLeft = this->RoundTicks;
  this->RoundEnd = ServoClock::Now() + RoundTime;
  if (this->Threads == 1)
  {
    // Use this thread alone: a single path needs no other, and a finder may throw exceptions, which
    // VTK's threads must not.
    this->AdvanceStretches();
    return;
  }
  const auto advance = [this](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType thread = begin; thread < end; ++thread)
    {
      try
      {
        this->AdvanceStretches();
      }
      catch (const std::bad_alloc&) // VTK's threads must not throw, so it is rethrown below
      {
        const std::lock_guard<std::mutex> lock(this->Mutex);
        this->HasFailed = true;
      }
    }
  };
  vtkSMPTools::For(0, this->Threads, 1, advance);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->HasFailed)
  {
    throw std::bad_alloc();
  }
}

void TipPathsWalk::Advance(Runner& runner, vtkIdType ticks)
{
  HapticTrace::Rows& rows = this->Rows[runner.Path];
  const bool isRecording = this->Paths.GetRecording() != nullptr;
  const bool hasModes = !this->Trace.GetModeForces().empty();
  TracePart part(this->Trace, rows.First + rows.Count, runner.Work);
  const bool isPlain = runner.Walk.IsPlain(*runner.Model);
  for (vtkIdType i = 0; i < ticks; ++i)
  {
    if (isPlain)
    {
      runner.Walk.Tick(*runner.Model, part.GetNext());
    }
    else
    {
      runner.Model = runner.Walk.Tick(std::move(runner.Model));
      part.GetNext() = runner.Walk.GetRecord();
    }
    if (isRecording && !IsFiniteRecord(part.GetNext()))
    {
      this->Flaw = rows.Count + i;
      return;
    }
    if (double* const orientations = this->Trace.GetOrientations())
    {
      ToArray(runner.Walk.GetOrientation(*runner.Model),
        orientations + 4 * (rows.First + rows.Count + i));
    }
    if (hasModes)
    {
      const ModeForces forces = runner.Walk.ComputeModeForces(*runner.Model);
      part.Append(runner.Model, runner.Walk.GetTime(), &forces);
    }
    else
    {
      part.Append(runner.Model, runner.Walk.GetTime());
    }
  }
  part.Flush();
  rows.Count += ticks;
  this->TicksDone += ticks;
}

} // namespace VolumeHaptics
