// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/MaterialLaw.h"

namespace VolumeHaptics
{
namespace Law
{
namespace
{

/** The wall at the stand-off from forbidden labels. False if the position is not at it. */
bool FindForbidden(const HapticModel& model, const Vector3& labelIndex, Surface& surface) noexcept
{
  const ForbiddenZone& zone = *model.Baked->GetZone();
  const ForbiddenPlace place = zone.Find(labelIndex);
  const double depth = zone.GetStandOff() - place.Distance;
  const Vector3 gradient = model.LabelGradientToDevice * place.Gradient;
  const double magnitude = Norm(gradient);
  if (!place.IsNear || !(depth > -zone.GetTolerance()) || !(magnitude > 0.0))
  {
    return false;
  }
  surface = Surface{};
  surface.Normal = (-1.0 / magnitude) * gradient;
  surface.Reach = model.DeviceToIndex.Linear * (model.LabelReach * surface.Normal);
  surface.GradientMagnitude = magnitude;
  surface.Value = -place.Distance;
  surface.Fade = std::min(1.0, 1.0 + depth / zone.GetTolerance());
  surface.IsWall = surface.IsForbidden = true;
  return true;
}

/** The nearest wall between labels, or the scalars' surface. */
Surface FindWall(const HapticModel& model, const FieldAtTime& field, const Vector3& index,
  const Vector3& labelIndex, LabelMemory& memory) noexcept
{
  const BakedVolume& baked = *model.Baked;
  Surface surface = MakeNoSurface(model);
  if (baked.Settings.Geometry == SurfaceGeometry::Both)
  {
    // A wall stands in where the scalars have less than half a surface.
    constexpr double least = 0.5;
    surface = FindFieldSurface(model, field, index);
    if (baked.Distinctness(surface.GradientMagnitude)[0] >= least && surface.Fade > 0.0)
    {
      return surface;
    }
  }
  if (!field.IsInside(index))
  {
    return surface;
  }
  const LabelWall wall = baked.Walls->Find(labelIndex, memory.Wall);
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
  // Root and reciprocal do not wait for each other.
  const double magnitude = std::sqrt(square);
  const double inverse = (1.0 / square) * magnitude;
  surface.Normal = inverse * gradient;
  surface.Reach = inverse * (model.LabelGradientToReach * wall.Gradient);
  surface.GradientMagnitude = magnitude;
  surface.Value = wall.Value;
  surface.Fade = std::min(model.BorderFade(index), baked.Walls->BorderFade(labelIndex));
  surface.IsWall = true;
  surface.Depth = wall.Value;
  return surface;
}

} // namespace

Surface FindSurfaceOfLabels(const HapticModel& model, const FieldAtTime& field,
  const Vector3& index, LabelMemory& memory) noexcept
{
  const Vector3 labelIndex = model.IndexToLabel(index);
  Surface surface;
  if (model.Baked->GetZone() && FindForbidden(model, labelIndex, surface))
  {
    return surface;
  }
  return model.Baked->Walls ? FindWall(model, field, index, labelIndex, memory)
                            : FindFieldSurface(model, field, index);
}

} // namespace Law
} // namespace VolumeHaptics
