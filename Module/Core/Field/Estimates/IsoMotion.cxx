// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/Estimates/IsoMotion.h"

#include "Core/Field/FieldAtTime.h"
#include "Core/Field/GradientKernel.h"

#include <cmath>
#include <optional>

namespace VolumeHaptics
{
namespace
{

/**
 * Number of blends of both time steps through which a point is followed, and the limit of Newton
 * steps in each blend.
 */
constexpr int Blends = 8;
constexpr int MostSteps = 4;
///@{
/**
 * Lengths in voxels: the longest step; the step after which the level counts as reached; and the
 * step after which it counts as lost.
 */
constexpr double LongestStep = 0.5;
constexpr double ShortStep = 1e-4;
constexpr double LostStep = 0.1;
///@}

/** Returns one Newton step to a level, along the gradient (index steps). */
Vector3 ComputeStep(const FieldAtTime& field, double value, const Vector3& index)
{
  const Vector3 slope = field.Gradient(index).Gradient;
  return ((value - field.Value(index)) / Dot(slope, slope)) * slope;
}

/** Returns an index moved to a level, or `start` if the level can't be reached. */
Vector3 GoToLevel(
  const FieldSampler& inside, const FieldAtTime& field, double value, const Vector3& start)
{
  Vector3 index = inside.Nearest(start);
  double length = 0.0;
  for (int step = 0; step < MostSteps; ++step)
  {
    const Vector3 whole = ComputeStep(field, value, index);
    length = Norm(whole);
    // The condition is false for NaN, too.
    if (!(length < 1e9))
    {
      return start;
    }
    index = inside.Nearest(index + std::fmin(1.0, LongestStep / length) * whole);
    if (length < ShortStep)
    {
      return index;
    }
  }
  return length < LostStep ? index : start;
}

} // namespace

std::vector<Vector3> MeasureIsoMotions(
  const std::vector<Vector3>& points, double value, const IsoTimeSteps& timeSteps)
{
  const GradientKernel kernel(GradientEstimator::CentralDifference, 1);
  const FieldSampler first(timeSteps.First, kernel);
  const FieldSampler second(timeSteps.Second, kernel);
  std::optional<DisplacementField> material;
  if (timeSteps.Displacements.Data)
  {
    material.emplace(timeSteps.Displacements, timeSteps.First, timeSteps.IndexToWorld.Linear);
  }
  const Affine3 worldToIndex = Inverse(timeSteps.IndexToWorld);
  std::vector<Vector3> motions;
  motions.reserve(points.size());
  for (const Vector3& point : points)
  {
    const Vector3 begin = worldToIndex(point);
    Vector3 end = material ? material->Compute(begin, 0.0).Second : begin;
    // If the level is near already, the blends between the time steps are not needed.
    const bool isNear =
      material || Norm(ComputeStep(FieldAtTime(second), value, first.Nearest(begin))) < LongestStep;
    for (int blend = isNear ? Blends : 1; blend <= Blends; ++blend)
    {
      const double fraction = static_cast<double>(blend) / Blends;
      end = GoToLevel(first, FieldAtTime(first, second, fraction), value, end);
    }
    const Vector3 motion = timeSteps.IndexToWorld.Linear * (end - begin);
    motions.push_back(IsFinite(motion) ? motion : Vector3{});
  }
  return motions;
}

} // namespace VolumeHaptics
