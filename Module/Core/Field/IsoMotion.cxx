// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/IsoMotion.h"

#include "Core/Field/FieldAtTime.h"
#include "Core/Field/GradientKernel.h"

#include <cmath>
#include <optional>

namespace VolumeHaptics
{
namespace
{

/** The blends that a point is followed through, and the steps to its level in each. */
constexpr int Blends = 8;
constexpr int MostSteps = 4;
///@{
/** Voxels: the longest step, and one after which the level is found. */
constexpr double LongestStep = 0.5;
constexpr double ShortStep = 1e-4;
///@}

/** Moves an index to a level; no farther if there is no way to it. */
Vector3 GoToLevel(const FieldSampler& inside, const FieldAtTime& field, double value, Vector3 index)
{
  for (int step = 0; step < MostSteps; ++step)
  {
    index = inside.Nearest(index);
    const Vector3 slope = field.Gradient(index).Gradient;
    const Vector3 whole = ((value - field.Value(index)) / Dot(slope, slope)) * slope;
    const double length = Norm(whole);
    // Also false for NaN.
    if (!(length < 1e9))
    {
      return index;
    }
    index += std::fmin(1.0, LongestStep / length) * whole;
    if (length < ShortStep)
    {
      return index;
    }
  }
  return index;
}

} // namespace

std::vector<Vector3> FindIsoMotions(
  const std::vector<Vector3>& points, double value, const IsoFrames& frames)
{
  const GradientKernel kernel(GradientEstimator::CentralDifference, 1);
  const FieldSampler first(frames.First, kernel);
  const FieldSampler second(frames.Second, kernel);
  std::optional<DisplacementField> material;
  if (frames.Displacements.Data)
  {
    material.emplace(frames.Displacements, frames.First, frames.IndexToWorld.Linear);
  }
  const Affine3 worldToIndex = Inverse(frames.IndexToWorld);
  std::vector<Vector3> motions;
  motions.reserve(points.size());
  for (const Vector3& point : points)
  {
    const Vector3 begin = worldToIndex(point);
    Vector3 end = material ? material->Find(begin, 0.0).Second : begin;
    for (int blend = material ? Blends : 1; blend <= Blends; ++blend)
    {
      const double share = static_cast<double>(blend) / Blends;
      end = GoToLevel(first, FieldAtTime(first, second, share), value, end);
    }
    const Vector3 motion = frames.IndexToWorld.Linear * (end - begin);
    motions.push_back(IsFinite(motion) ? motion : Vector3{});
  }
  return motions;
}

} // namespace VolumeHaptics
