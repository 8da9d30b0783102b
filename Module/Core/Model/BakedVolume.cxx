// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedVolume.h"

#include "Core/Math/PolylineMask.h"
#include "Core/Model/HapticModel.h"
#include "Core/Model/UniqueNumber.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * PRECISE holds its proxy on levels of the estimator's own value: the normals must be normal to
 * them. LOCAL_SURFACE looks for levels of V, but depends on how the normals turn, too.
 */
GaussianWeights ChooseWeights(const HapticSettings& settings)
{
  const bool isPrecise = settings.Method == HapticMethod::LocalSurface ||
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

std::unique_ptr<const LabelWalls> MakeWalls(
  const HapticModelDescription& d, const BakedLabels* labels)
{
  if (!labels || d.Settings.Geometry == SurfaceGeometry::Scalars)
  {
    return nullptr;
  }
  // The default radius of 2 makes a scale of 1.4 voxels.
  return std::make_unique<const LabelWalls>(labels->View, labels->Table, d.KernelRadius + 1);
}

/** In a tick; the servo has time for no more. */
constexpr int MostFramesFollowed = 4;

std::vector<FieldFrame> MakeFrames(const HapticModelDescription& d, const GradientKernel& kernel)
{
  std::vector<FieldFrame> frames;
  frames.reserve(d.Frames.size());
  for (const VolumeFrame& frame : d.Frames)
  {
    frames.push_back({ frame.Time, FieldSampler(frame.View, kernel), frame.Samples, {},
      frame.DisplacementSamples });
    if (frame.Displacements.Data)
    {
      frames.back().Motion.emplace(frame.Displacements, frame.View, d.IndexToWorld.Linear);
    }
  }
  return frames;
}

} // namespace

BakedVolume::BakedVolume(const HapticModelDescription& d)
  : Kernel(MakeKernel(d))
  , Field(d.View, this->Kernel)
  , Frames(MakeFrames(d, this->Kernel))
  , Materials({ MakeStiffness(d), d.Material.Friction, d.Material.SurfaceStrength,
      d.Material.Viscosity, d.Material.ScalarVisibility })
  , Distinctness({ d.Material.Distinctness, d.Material.GradientVisibility })
  , IndexToWorld(d.IndexToWorld)
  , LargestSpacing(LargestColumn(d.IndexToWorld.Linear))
  , Settings(d.Settings)
  , Samples(d.Samples)
  , Mesh(d.Mesh)
  , Labels(MakeLabels(d))
  , Walls(MakeWalls(d, this->Labels.get()))
  , Number(d.Number > 0 ? d.Number : MakeUniqueNumber())
{
}

std::size_t BakedVolume::FindFrame(double time) const noexcept
{
  // Not the last one: it has no next one.
  std::size_t frame = 0;
  for (std::size_t above = this->Frames.size() - 1; above - frame > 1;)
  {
    const std::size_t middle = (frame + above) / 2;
    (time < this->Frames[middle].Time ? above : frame) = middle;
  }
  return frame;
}

FieldAtTime BakedVolume::BlendFrames(double time) const noexcept
{
  const std::size_t frame = this->FindFrame(time);
  const FieldFrame& before = this->Frames[frame];
  const FieldFrame& after = this->Frames[frame + 1];
  const double share = (time - before.Time) / (after.Time - before.Time);
  return { before.Field, after.Field, std::clamp(share, 0.0, 1.0),
    before.Motion ? &*before.Motion : nullptr };
}

Vector3 BakedVolume::FollowMaterial(const Vector3& index, double from, double to) const noexcept
{
  const auto within = [this](double time)
  { return std::clamp(time, this->Frames.front().Time, this->Frames.back().Time); };
  const double end = within(to);
  const double begin = within(from);
  Vector3 at = index;
  std::size_t frame = this->FindFrame(begin);
  // At a frame that time leaves backwards.
  frame -= end < begin && begin == this->Frames[frame].Time && frame > 0 ? 1 : 0;
  double time = begin;
  for (int i = 0; i < MostFramesFollowed && time != end; ++i)
  {
    const FieldFrame& before = this->Frames[frame];
    const FieldFrame& after = this->Frames[frame + 1];
    const double next = std::clamp(end, before.Time, after.Time);
    const double length = after.Time - before.Time;
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

GradientKernel BakedVolume::MakeKernel(const HapticModelDescription& d)
{
  return { d.Estimator, d.KernelRadius, ChooseWeights(d.Settings) };
}

} // namespace VolumeHaptics
