// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedVolume.h"

#include "Core/Math/PolylineMask.h"
#include "Core/Math/UniqueNumber.h"
#include "Core/Model/HapticModel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Chooses the weights of the Gaussian. The solver Precise holds its proxy on levels of the
 * estimator's own value, so its normals must be perpendicular to these levels. The method
 * LocalSurface and the ridges of Primitives also depend on how the normals change from place to
 * place.
 */
GaussianWeights ChooseWeights(const HapticSettings& settings)
{
  const bool isPrecise = settings.Method == HapticMethod::LocalSurface ||
    settings.Method == HapticMethod::Primitives ||
    (settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Precise);
  return isPrecise ? GaussianWeights::OwnDerivative : GaussianWeights::FittedLine;
}

/**
 * Returns the function of stiffness. With SameShape, all materials that have any stiffness get the
 * same stiffness.
 */
Polyline MakeStiffness(const HapticModelDescription& d)
{
  if (!d.Settings.SameShape)
  {
    return d.Material.Stiffness;
  }
  Polyline line = MaskAbove(d.Material.Stiffness, HapticModel::MinimumStiffness);
  for (Vertex& vertex : line)
  {
    vertex.Y *= d.Settings.CouplingStiffness;
  }
  return line;
}

std::shared_ptr<const BakedLabels> MakeLabels(const HapticModelDescription& d)
{
  if (!d.Settings.SameShape || !d.Labels)
  {
    return d.Labels;
  }
  const auto labels = std::make_shared<BakedLabels>(*d.Labels);
  labels->Table.SetOneStiffness(d.Settings.CouplingStiffness, HapticModel::MinimumStiffness);
  return labels;
}

std::shared_ptr<const LabelWalls> MakeWalls(
  const HapticModelDescription& d, const BakedLabels* labels)
{
  if (!labels || d.Settings.Geometry == SurfaceGeometry::Scalars)
  {
    return nullptr;
  }
  // With the default radius of 2, the kernel's standard deviation is 1.4 voxels.
  return std::make_shared<const LabelWalls>(labels->View, labels->Table, d.KernelRadius + 1,
    labels->Fine ? labels->Fine->GetFractions() : nullptr);
}

std::vector<BakedMode> MakeModes(const HapticModelDescription& d)
{
  std::vector<BakedMode> modes;
  if (d.Settings.Method == HapticMethod::Primitives)
  {
    modes.reserve(d.Modes.size());
    for (const ModeDescription& mode : d.Modes)
    {
      modes.emplace_back(mode, d.IndexToWorld);
    }
  }
  return modes;
}

/** A tick crosses at most this many time steps, because it has no time for more. */
constexpr int MostTimeStepsCrossed = 4;

TimeStepSeries MakeSeries(const HapticModelDescription& d)
{
  const std::vector<VolumeTimeStep>& timeSteps = d.TimeSteps;
  if (timeSteps.size() < 2 || d.Series.LoopInterval > 0.0)
  {
    return d.Series;
  }
  const bool isLoop = timeSteps.back().Time == timeSteps.front().Time;
  const std::size_t count = timeSteps.size() - (isLoop ? 1 : 0);
  const double first = timeSteps.front().Time;
  const double last = timeSteps[count - 1].Time;
  return { first, last, (last - first) / static_cast<double>(count - 1) };
}

std::vector<FieldTimeStep> MakeTimeSteps(const std::vector<VolumeTimeStep>& given,
  const TimeStepSeries& series, const Matrix3& indexToWorld, const GradientKernel& kernel)
{
  std::vector<FieldTimeStep> timeSteps;
  timeSteps.reserve(given.size());
  for (const VolumeTimeStep& timeStep : given)
  {
    if (!timeSteps.empty())
    {
      FieldTimeStep& last = timeSteps.back();
      // In a loop, the first time step follows the last one.
      last.Interval = timeStep.Time > last.Time ? timeStep.Time - last.Time : series.LoopInterval;
    }
    timeSteps.push_back({ timeStep.Time, 0.0, false, FieldSampler(timeStep.View, kernel),
      timeStep.Samples, {}, timeStep.DisplacementSamples, timeStep.Mesh });
    // The material's motion from the last time step back to the first is not known.
    if (timeStep.Displacements.Data && timeStep.Time < series.Last)
    {
      timeSteps.back().Motion.emplace(timeStep.Displacements, timeStep.View, indexToWorld);
    }
  }
  for (std::size_t i = 0; i + 1 < timeSteps.size(); ++i)
  {
    timeSteps[i].BlendsNext = timeSteps[i].Field.BlendsSamples(timeSteps[i + 1].Field);
  }
  return timeSteps;
}

/**
 * Bit that is flipped in a volume's number when it is felt with a point, so that the number differs
 * from the number of the same volume felt with a tool.
 */
constexpr std::uint64_t PointNumber = std::uint64_t{ 1 } << 63;

bool KnowMotion(const std::vector<FieldTimeStep>& timeSteps)
{
  return std::any_of(timeSteps.begin(), timeSteps.end(),
    [](const FieldTimeStep& timeStep) { return timeStep.Motion.has_value(); });
}

} // namespace

BakedVolume::BakedVolume(const HapticModelDescription& d)
  : Kernel(MakeKernel(d))
  , Removal(d.TimeSteps.empty() ? d.Removal : nullptr)
  , Field(d.View, this->Kernel,
      CarvedView{ this->Removal ? &this->Removal->Bricks : nullptr, d.AirValue })
  , Series(MakeSeries(d))
  , TimeSteps(MakeTimeSteps(d.TimeSteps, this->Series, d.IndexToWorld.Linear, this->Kernel))
  , HasMotion(KnowMotion(this->TimeSteps))
  , Materials({ MakeStiffness(d), d.Material.Friction, d.Material.SurfaceStrength,
      d.Material.Viscosity, d.Material.ScalarVisibility })
  , Distinctness({ d.Material.Distinctness, d.Material.GradientVisibility })
  , IsDistinctFromNoise(d.Material.IsDistinctFromNoise)
  , IsSeenByNearest(d.Material.IsSeenByNearest)
  , IndexToWorld(d.IndexToWorld)
  , LargestSpacing(LargestColumn(d.IndexToWorld.Linear))
  , Settings(d.Settings)
  , ResidentShare(d.ResidentShare)
  , Samples(d.Samples)
  , Mesh(d.Mesh)
  , Labels(MakeLabels(d))
  , Walls(MakeWalls(d, this->Labels.get()))
  , Cut(d.Cut)
  , HasOtherSurfaces(this->Cut || this->FeelsLabels())
  , Modes(MakeModes(d))
  , Tool(d.Tool)
  , IsForAPoint(false)
  , Number(d.Number > 0 ? d.Number : MakeUniqueNumber())
{
}

BakedVolume::BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal,
  double airValue, const VolumeTimeStep& shown, const std::vector<VolumeTimeStep>& timeSteps,
  const TimeStepSeries& series, bool isForAPoint)
  : Kernel(other.Kernel)
  , Removal(isForAPoint ? nullptr : removal)
  , Others(isForAPoint ? std::move(removal) : other.Others)
  , Field(shown.View, this->Kernel,
      CarvedView{ this->Removal ? &this->Removal->Bricks
          : this->Others        ? &this->Others->Bricks
                                : nullptr,
        airValue })
  , Series(series)
  , TimeSteps(MakeTimeSteps(timeSteps, this->Series, other.IndexToWorld.Linear, this->Kernel))
  , HasMotion(KnowMotion(this->TimeSteps))
  , Materials(other.Materials)
  , Distinctness(other.Distinctness)
  , IsDistinctFromNoise(other.IsDistinctFromNoise)
  , IsSeenByNearest(other.IsSeenByNearest)
  , IndexToWorld(other.IndexToWorld)
  , LargestSpacing(other.LargestSpacing)
  , Settings(other.Settings)
  , ResidentShare(other.ResidentShare)
  , Samples(shown.Samples)
  , Mesh(other.Mesh ? shown.Mesh : nullptr)
  , Labels(other.Labels)
  , Walls(other.Walls)
  , Cut(other.Cut)
  , HasOtherSurfaces(other.HasOtherSurfaces)
  , Modes(other.Modes)
  , Tool(isForAPoint ? nullptr : other.Tool)
  , IsForAPoint(isForAPoint || other.IsForAPoint)
  , Number(isForAPoint ? other.Number ^ PointNumber : other.Number)
{
}

BakedVolume::BakedVolume(const BakedVolume& other, const std::vector<VolumeTimeStep>& timeSteps,
  const TimeStepSeries& series)
  : BakedVolume(other, nullptr, 0.0, timeSteps.front(), timeSteps, series)
{
}

BakedVolume::BakedVolume(
  const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue)
  : BakedVolume(other, std::move(removal), airValue,
      VolumeTimeStep{ 0.0, other.Field.GetView(), other.Samples, {}, {}, other.Mesh }, {},
      other.Series)
{
}

BakedVolume::BakedVolume(const BakedVolume& other, ForAPoint)
  : BakedVolume(other, other.Removal, other.Field.GetCarved().Air,
      VolumeTimeStep{ 0.0, other.Field.GetView(), other.Samples, {}, {}, other.Mesh }, {},
      other.Series, true)
{
}

std::size_t BakedVolume::FindTimeStep(double time) const noexcept
{
  // If the time steps cross the end of a loop, data times before the first time step belong to
  // those after the loop's end.
  const double front = this->TimeSteps.front().Time;
  const double turn = front < this->TimeSteps.back().Time ? -HUGE_VAL : front;
  const auto isBefore = [turn, time](double other)
  { return (time < turn) == (other < turn) ? time < other : other < turn; };
  // The search never returns the last time step, because no time step follows it.
  std::size_t timeStep = 0;
  for (std::size_t above = this->TimeSteps.size() - 1; above - timeStep > 1;)
  {
    const std::size_t middle = (timeStep + above) / 2;
    (isBefore(this->TimeSteps[middle].Time) ? above : timeStep) = middle;
  }
  return timeStep;
}

double BakedVolume::ComputeFraction(std::size_t timeStep, double time) const noexcept
{
  const FieldTimeStep& before = this->TimeSteps[timeStep];
  if (timeStep + 1 == this->TimeSteps.size())
  {
    return 0.0; // there is only one time step
  }
  // The time may be after the end of a loop at which the time steps end.
  const bool isPast = time < before.Time && this->TimeSteps[timeStep + 1].Time < before.Time;
  return isPast ? 1.0 : std::clamp((time - before.Time) / before.Interval, 0.0, 1.0);
}

std::size_t BakedVolume::FindNearestTimeStep(double time) const noexcept
{
  const std::size_t timeStep = this->FindTimeStep(time);
  return this->ComputeFraction(timeStep, time) < 0.5 ? timeStep : timeStep + 1;
}

FieldAtTime BakedVolume::BlendTimeSteps(double time, TickMemory* memory) const noexcept
{
  const std::size_t timeStep = this->FindTimeStep(time);
  const FieldTimeStep& before = this->TimeSteps[timeStep];
  if (this->TimeSteps.size() == 1)
  {
    return FieldAtTime(before.Field, memory);
  }
  return { before.Field,
    { this->TimeSteps[timeStep + 1].Field, this->ComputeFraction(timeStep, time),
      before.BlendsNext },
    before.Motion ? &*before.Motion : nullptr, memory, timeStep };
}

std::optional<FieldStep> BakedVolume::ComputeStep(
  double before, double now, TickMemory& memory) const noexcept
{
  if (this->HasMotion || this->TimeSteps.size() < 2)
  {
    return {};
  }
  const std::size_t timeStep = this->FindTimeStep(now);
  const FieldTimeStep& first = this->TimeSteps[timeStep];
  const auto isBetween = [](double fraction) { return fraction > 0.0 && fraction < 1.0; };
  const double from = this->ComputeFraction(timeStep, before);
  const double to = this->ComputeFraction(timeStep, now);
  if (!first.BlendsNext || !isBetween(from) || !isBetween(to) ||
    this->FindTimeStep(before) != timeStep)
  {
    return {};
  }
  return FieldStep(first.Field, this->TimeSteps[timeStep + 1].Field, from, to, memory);
}

Vector3 BakedVolume::TrackMaterial(const Vector3& index, double from, double to) const noexcept
{
  if (!this->HasMotion)
  {
    return index;
  }
  const double front = this->TimeSteps.front().Time;
  const double back = this->TimeSteps.back().Time;
  const bool isSpanOfLoop = back <= front;
  const bool isOverEnd =
    std::fmax(from, to) > this->Series.Last && std::abs(to - from) > 0.5 * this->Series.GetPeriod();
  if (isSpanOfLoop && (isOverEnd || (from < front) != (to < front)))
  {
    // Both times belong to one tick that crosses the end of the loop, where no motion is known.
    return index;
  }
  const auto within = [&](double time)
  { return isSpanOfLoop ? time : std::clamp(time, front, back); };
  const double end = within(to);
  const double begin = within(from);
  Vector3 at = index;
  std::size_t timeStep = this->FindTimeStep(begin);
  // If time runs backwards from the beginning of this time step, the motion takes place in the
  // previous one.
  timeStep -= end < begin && begin == this->TimeSteps[timeStep].Time && timeStep > 0 ? 1 : 0;
  double time = begin;
  for (int i = 0; i < MostTimeStepsCrossed && time != end && timeStep + 1 < this->TimeSteps.size();
       ++i)
  {
    const FieldTimeStep& before = this->TimeSteps[timeStep];
    const FieldTimeStep& after = this->TimeSteps[timeStep + 1];
    const double length = before.Interval;
    const double stop = after.Time > before.Time ? after.Time : before.Time + length;
    const double next = std::clamp(end, before.Time, stop);
    if (before.Motion)
    {
      const MaterialPlace place = before.Motion->Compute(at, (time - before.Time) / length);
      at = this->Field.Nearest(at + ((next - time) / length) * (place.Second - place.First));
    }
    time = next;
    timeStep = end > time ? timeStep + 1 : (timeStep > 0 ? timeStep - 1 : 0);
  }
  return at;
}

int BakedVolume::CollectMeshWays(double from, double to, MeshWay ways[MostMeshWays]) const noexcept
{
  if (!this->IsMoving())
  {
    ways[0] = { this->Mesh.get(), 0.0, 0.0, false };
    return 1;
  }
  const std::size_t first = this->FindTimeStep(from);
  const std::size_t last = this->FindTimeStep(to);
  const double begin = this->ComputeFraction(first, from);
  const double end = this->ComputeFraction(last, to);
  const auto way = [this](std::size_t timeStep, double begin, double end)
  {
    const FieldTimeStep& of = this->TimeSteps[timeStep];
    return MeshWay{ of.Mesh.get(), begin, end, of.Motion.has_value() };
  };
  if (first == last)
  {
    ways[0] = way(first, begin, end);
    return 1;
  }
  // In a loop, the first time step may follow the last one.
  const bool isOverEnd = std::abs(to - from) > 0.5 * this->Series.GetPeriod();
  const bool isForward = (to > from) != isOverEnd;
  const std::size_t before = isForward ? first : last;
  const std::size_t after = isForward ? last : first;
  if (after == before + 1 || (isOverEnd && after == 0 && before + 2 == this->TimeSteps.size()))
  {
    ways[0] = way(first, begin, isForward ? 1.0 : 0.0);
    ways[1] = way(last, isForward ? 0.0 : 1.0, end);
    return 2;
  }
  ways[0] = way(last, end, end);
  return 1;
}

GradientKernel BakedVolume::MakeKernel(const HapticModelDescription& d)
{
  return { d.Estimator, d.KernelRadius, ChooseWeights(d.Settings) };
}

} // namespace VolumeHaptics
