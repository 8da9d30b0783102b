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
 * PRECISE holds its proxy on levels of the estimator's own value: the normals must be normal to
 * these levels. LOCAL_SURFACE and the ridges of PRIMITIVES depend on how the normals turn, too.
 */
GaussianWeights ChooseWeights(const HapticSettings& settings)
{
  const bool isPrecise = settings.Method == HapticMethod::LocalSurface ||
    settings.Method == HapticMethod::Primitives ||
    (settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Precise);
  return isPrecise ? GaussianWeights::OwnDerivative : GaussianWeights::FittedLine;
}

/** The stiffness of all materials that have one. */
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
  // The default radius of 2 gives a scale of 1.4 voxels.
  return std::make_shared<const LabelWalls>(labels->View, labels->Table, d.KernelRadius + 1,
    labels->Fine ? labels->Fine->GetShares() : nullptr);
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

/** In a tick; the servo has no time for more. */
constexpr int MostFramesFollowed = 4;

FrameSeries MakeSeries(const HapticModelDescription& d)
{
  const std::vector<VolumeFrame>& frames = d.Frames;
  if (frames.size() < 2 || d.Series.LoopInterval > 0.0)
  {
    return d.Series;
  }
  const bool isLoop = frames.back().Time == frames.front().Time;
  const std::size_t count = frames.size() - (isLoop ? 1 : 0);
  const double first = frames.front().Time;
  const double last = frames[count - 1].Time;
  return { first, last, (last - first) / static_cast<double>(count - 1) };
}

std::vector<FieldFrame> MakeFrames(const std::vector<VolumeFrame>& given, const FrameSeries& series,
  const Matrix3& indexToWorld, const GradientKernel& kernel)
{
  std::vector<FieldFrame> frames;
  frames.reserve(given.size());
  for (const VolumeFrame& frame : given)
  {
    if (!frames.empty())
    {
      FieldFrame& last = frames.back();
      // The first frame follows the last one.
      last.Interval = frame.Time > last.Time ? frame.Time - last.Time : series.LoopInterval;
    }
    frames.push_back({ frame.Time, 0.0, false, FieldSampler(frame.View, kernel), frame.Samples, {},
      frame.DisplacementSamples, frame.Mesh });
    // The motion of the material from the last frame back to the first one is not known.
    if (frame.Displacements.Data && frame.Time < series.Last)
    {
      frames.back().Motion.emplace(frame.Displacements, frame.View, indexToWorld);
    }
  }
  for (std::size_t i = 0; i + 1 < frames.size(); ++i)
  {
    frames[i].BlendsNext = frames[i].Field.BlendsSamples(frames[i + 1].Field);
  }
  return frames;
}

bool KnowMotion(const std::vector<FieldFrame>& frames)
{
  return std::any_of(
    frames.begin(), frames.end(), [](const FieldFrame& frame) { return frame.Motion.has_value(); });
}

} // namespace

BakedVolume::BakedVolume(const HapticModelDescription& d)
  : Kernel(MakeKernel(d))
  , Removal(d.Frames.empty() ? d.Removal : nullptr)
  , Field(d.View, this->Kernel,
      CarvedView{ this->Removal ? &this->Removal->Bricks : nullptr, d.AirValue })
  , Series(MakeSeries(d))
  , Frames(MakeFrames(d.Frames, this->Series, d.IndexToWorld.Linear, this->Kernel))
  , HasMotion(KnowMotion(this->Frames))
  , Materials({ MakeStiffness(d), d.Material.Friction, d.Material.SurfaceStrength,
      d.Material.Viscosity, d.Material.ScalarVisibility })
  , Distinctness({ d.Material.Distinctness, d.Material.GradientVisibility })
  , IsDistinctFromNoise(d.Material.IsDistinctFromNoise)
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
  , Number(d.Number > 0 ? d.Number : MakeUniqueNumber())
{
}

BakedVolume::BakedVolume(const BakedVolume& other, std::shared_ptr<TissueRemoval> removal,
  double airValue, const VolumeFrame& shown, const std::vector<VolumeFrame>& frames,
  const FrameSeries& series)
  : Kernel(other.Kernel)
  , Removal(std::move(removal))
  , Field(shown.View, this->Kernel,
      CarvedView{ this->Removal ? &this->Removal->Bricks : nullptr, airValue })
  , Series(series)
  , Frames(MakeFrames(frames, this->Series, other.IndexToWorld.Linear, this->Kernel))
  , HasMotion(KnowMotion(this->Frames))
  , Materials(other.Materials)
  , Distinctness(other.Distinctness)
  , IsDistinctFromNoise(other.IsDistinctFromNoise)
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
  , Tool(other.Tool)
  , Number(other.Number)
{
}

BakedVolume::BakedVolume(
  const BakedVolume& other, const std::vector<VolumeFrame>& frames, const FrameSeries& series)
  : BakedVolume(other, nullptr, 0.0, frames.front(), frames, series)
{
}

BakedVolume::BakedVolume(
  const BakedVolume& other, std::shared_ptr<TissueRemoval> removal, double airValue)
  : BakedVolume(other, std::move(removal), airValue,
      VolumeFrame{ 0.0, other.Field.GetView(), other.Samples, {}, {}, other.Mesh }, {},
      other.Series)
{
}

std::size_t BakedVolume::FindFrame(double time) const noexcept
{
  // Earlier times belong to the frames that follow the last one of the series.
  const double front = this->Frames.front().Time;
  const double turn = front < this->Frames.back().Time ? -HUGE_VAL : front;
  const auto isBefore = [turn, time](double other)
  { return (time < turn) == (other < turn) ? time < other : other < turn; };
  // Not the last frame: it has no next one.
  std::size_t frame = 0;
  for (std::size_t above = this->Frames.size() - 1; above - frame > 1;)
  {
    const std::size_t middle = (frame + above) / 2;
    (isBefore(this->Frames[middle].Time) ? above : frame) = middle;
  }
  return frame;
}

double BakedVolume::FindShare(std::size_t frame, double time) const noexcept
{
  const FieldFrame& before = this->Frames[frame];
  if (frame + 1 == this->Frames.size())
  {
    return 0.0; // the only one
  }
  // A time span may end where the series begins again.
  const bool isPast = time < before.Time && this->Frames[frame + 1].Time < before.Time;
  return isPast ? 1.0 : std::clamp((time - before.Time) / before.Interval, 0.0, 1.0);
}

std::size_t BakedVolume::FindNearestFrame(double time) const noexcept
{
  const std::size_t frame = this->FindFrame(time);
  return this->FindShare(frame, time) < 0.5 ? frame : frame + 1;
}

FieldAtTime BakedVolume::BlendFrames(double time, TickMemory* memory) const noexcept
{
  const std::size_t frame = this->FindFrame(time);
  const FieldFrame& before = this->Frames[frame];
  if (this->Frames.size() == 1)
  {
    return FieldAtTime(before.Field, memory);
  }
  return { before.Field,
    { this->Frames[frame + 1].Field, this->FindShare(frame, time), before.BlendsNext },
    before.Motion ? &*before.Motion : nullptr, memory, frame };
}

std::optional<FieldStep> BakedVolume::FindStep(
  double before, double now, TickMemory& memory) const noexcept
{
  if (this->HasMotion || this->Frames.size() < 2)
  {
    return {};
  }
  const std::size_t frame = this->FindFrame(now);
  const FieldFrame& first = this->Frames[frame];
  const auto isBetween = [](double share) { return share > 0.0 && share < 1.0; };
  const double from = this->FindShare(frame, before);
  const double to = this->FindShare(frame, now);
  if (!first.BlendsNext || !isBetween(from) || !isBetween(to) || this->FindFrame(before) != frame)
  {
    return {};
  }
  return FieldStep(first.Field, this->Frames[frame + 1].Field, from, to, memory);
}

Vector3 BakedVolume::FollowMaterial(const Vector3& index, double from, double to) const noexcept
{
  if (!this->HasMotion)
  {
    return index;
  }
  const double front = this->Frames.front().Time;
  const double back = this->Frames.back().Time;
  const bool isWindowOfLoop = back <= front;
  const bool isOverEnd =
    std::fmax(from, to) > this->Series.Last && std::abs(to - from) > 0.5 * this->Series.GetPeriod();
  if (isWindowOfLoop && (isOverEnd || (from < front) != (to < front)))
  {
    // Both times are in one tick over the end of the loop.
    return index;
  }
  const auto within = [&](double time)
  { return isWindowOfLoop ? time : std::clamp(time, front, back); };
  const double end = within(to);
  const double begin = within(from);
  Vector3 at = index;
  std::size_t frame = this->FindFrame(begin);
  // Time leaves this frame backwards.
  frame -= end < begin && begin == this->Frames[frame].Time && frame > 0 ? 1 : 0;
  double time = begin;
  for (int i = 0; i < MostFramesFollowed && time != end && frame + 1 < this->Frames.size(); ++i)
  {
    const FieldFrame& before = this->Frames[frame];
    const FieldFrame& after = this->Frames[frame + 1];
    const double length = before.Interval;
    const double stop = after.Time > before.Time ? after.Time : before.Time + length;
    const double next = std::clamp(end, before.Time, stop);
    if (before.Motion)
    {
      const MaterialPlace place = before.Motion->Find(at, (time - before.Time) / length);
      at = this->Field.Nearest(at + ((next - time) / length) * (place.Second - place.First));
    }
    time = next;
    frame = end > time ? frame + 1 : (frame > 0 ? frame - 1 : 0);
  }
  return at;
}

int BakedVolume::FindMeshWays(double from, double to, MeshWay ways[MostMeshWays]) const noexcept
{
  if (!this->IsMoving())
  {
    ways[0] = { this->Mesh.get(), 0.0, 0.0, false };
    return 1;
  }
  const std::size_t first = this->FindFrame(from);
  const std::size_t last = this->FindFrame(to);
  const double begin = this->FindShare(first, from);
  const double end = this->FindShare(last, to);
  const auto way = [this](std::size_t frame, double begin, double end)
  {
    const FieldFrame& of = this->Frames[frame];
    return MeshWay{ of.Mesh.get(), begin, end, of.Motion.has_value() };
  };
  if (first == last)
  {
    ways[0] = way(first, begin, end);
    return 1;
  }
  // The first frame may follow the last one.
  const bool isOverEnd = std::abs(to - from) > 0.5 * this->Series.GetPeriod();
  const bool isForward = (to > from) != isOverEnd;
  const std::size_t before = isForward ? first : last;
  const std::size_t after = isForward ? last : first;
  if (after == before + 1 || (isOverEnd && after == 0 && before + 2 == this->Frames.size()))
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
