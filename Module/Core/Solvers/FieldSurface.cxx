// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/MaterialLaw.h"

namespace VolumeHaptics
{
namespace Law
{

Surface FindWall(const HapticModel& model, const Vector3& index) noexcept
{
  const BakedVolume& baked = *model.Baked;
  Surface surface;
  surface.Normal = model.FallbackNormal;
  surface.Reach = model.FallbackReach;
  if (baked.Settings.Geometry == SurfaceGeometry::Both)
  {
    // A wall stands in where the scalars have less than half a surface.
    constexpr double least = 0.5;
    surface = FindFieldSurface(model, index);
    if (baked.Distinctness(surface.GradientMagnitude)[0] >= least && surface.Fade > 0.0)
    {
      return surface;
    }
  }
  const Vector3 labelIndex = model.IndexToLabel(index);
  if (!baked.Field.IsInside(index))
  {
    return surface;
  }
  const LabelWall wall = baked.Walls->Find(labelIndex);
  const Vector3 gradient = model.LabelGradientToDevice * wall.Gradient;
  const double square = Dot(gradient, gradient);
  // A wall far away leaves the scalars' surface alone.
  const bool isNear =
    std::abs(wall.Value) < WallEnds || baked.Settings.Geometry == SurfaceGeometry::Labels;
  constexpr double rounding = 1e-12;
  if (!wall.IsThere || !isNear || !(Dot(wall.Gradient, wall.Gradient) > rounding * rounding) ||
    !(square > SmallestSquare))
  {
    return surface;
  }
  const double magnitude = std::sqrt(square);
  surface.Normal = (1.0 / magnitude) * gradient;
  surface.Reach = model.DeviceToIndex.Linear * (model.LabelReach * surface.Normal);
  surface.GradientMagnitude = magnitude;
  surface.Value = wall.Value;
  surface.Fade = std::min(model.BorderFade(index), baked.Walls->BorderFade(labelIndex));
  surface.IsWall = true;
  surface.Depth = wall.Value;
  return surface;
}

} // namespace Law
} // namespace VolumeHaptics
