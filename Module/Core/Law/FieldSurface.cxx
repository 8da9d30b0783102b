// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Law/MaterialLaw.h"

namespace VolumeHaptics
{
namespace Law
{
namespace
{

/** Returns x_s - x_p (index steps) for a wall between labels with the given normal. */
Vector3 WallReach(const HapticModel& model, const Vector3& normal) noexcept
{
  return model.DeviceToIndex.Linear * (model.LabelReachAlong(normal) * normal);
}

/**
 * Computes the wall at its stand-off in front of forbidden labels. Returns false if the position is
 * not at the wall.
 */
bool ComputeForbidden(
  const HapticModel& model, const Vector3& labelIndex, Surface& surface) noexcept
{
  const ForbiddenZone& zone = *model.Baked->GetZone();
  const ForbiddenPlace place = model.Baked->Labels->ComputeForbidden(labelIndex);
  const double depth = zone.GetStandOff() - place.Distance;
  const Vector3 gradient = model.LabelGradientToDevice * place.Gradient;
  const double magnitude = Norm(gradient);
  if (!place.IsNear || !(depth > -zone.GetTolerance()) || !(magnitude > 0.0))
  {
    return false;
  }
  surface = Surface{};
  surface.Normal = (-1.0 / magnitude) * gradient;
  surface.Reach = WallReach(model, surface.Normal);
  surface.GradientMagnitude = magnitude;
  surface.Value = -place.Distance;
  surface.Fade = std::min(1.0, 1.0 + depth / zone.GetTolerance());
  surface.IsWall = surface.IsOneSided = surface.IsForbidden = true;
  return true;
}

/** Returns the nearest wall between labels, or the scalars' surface. */
Surface ComputeWall(const HapticModel& model, const FieldAtTime& field, const Vector3& index,
  const Vector3& labelIndex, LabelMemory& memory) noexcept
{
  const BakedVolume& baked = *model.Baked;
  Surface surface = MakeNoSurface(model);
  if (baked.Settings.Geometry == SurfaceGeometry::Both)
  {
    // A wall replaces the scalars' surface only where that surface has less than half of its
    // distinctness.
    constexpr double least = 0.5;
    surface = ComputeFieldSurface(model, field, index);
    if (model.DistinctnessOf(surface.GradientMagnitude, surface.Normal)[0] >= least &&
      surface.Fade > 0.0)
    {
      return surface;
    }
  }
  if (!field.IsInside(index))
  {
    return surface;
  }
  const LabelWall wall = baked.Walls->Compute(labelIndex, memory.Wall);
  const Vector3 gradient = model.LabelGradientToDevice * wall.Gradient;
  const double square = Dot(gradient, gradient);
  // A distant wall does not replace the scalars' surface.
  const bool isNear =
    std::abs(wall.Value) < WallEnds || baked.Settings.Geometry == SurfaceGeometry::Labels;
  constexpr double rounding = 1e-12;
  if (!wall.IsThere || !isNear || !(Dot(wall.Gradient, wall.Gradient) > rounding * rounding) ||
    !(square > SmallestSquare))
  {
    return surface;
  }
  // Root and reciprocal are independent, so that the processor can compute them in parallel.
  const double magnitude = std::sqrt(square);
  const double inverse = (1.0 / square) * magnitude;
  surface.Normal = inverse * gradient;
  surface.Reach = model.HasLabelLengthByDirection
    ? WallReach(model, surface.Normal)
    : inverse * (model.LabelGradientToReach * wall.Gradient);
  surface.GradientMagnitude = magnitude;
  surface.Value = wall.Value;
  surface.Fade = std::min(model.BorderFade(index), baked.Walls->BorderFade(labelIndex));
  surface.IsWall = true;
  surface.Depth = wall.Value;
  return surface;
}

/** Returns the surface of labels or scalars, ignoring the cut. */
Surface ComputeUncutSurface(const HapticModel& model, const FieldAtTime& field,
  const Vector3& index, LabelMemory& memory) noexcept
{
  return model.Baked->Walls ? ComputeWall(model, field, index, model.IndexToLabel(index), memory)
                            : ComputeFieldSurface(model, field, index);
}

/** Makes the surface of a cut's face. Its material is read one voxel behind the face. */
Surface MakeCutFace(const HapticModel& model, const Vector3& index, const CutPlace& place) noexcept
{
  Surface surface;
  surface.Normal = Transpose(model.DeviceToWorldRotation) * place.Normal;
  surface.CutFaces = place.Faces;
  surface.Reach =
    model.DeviceToIndex.Linear * ((place.Voxel / model.WorldUnitsPerMeter) * surface.Normal);
  surface.GradientMagnitude = 1.0 / place.Voxel;
  surface.Value = surface.Depth = place.Depth / place.Voxel;
  surface.Fade = model.BorderFade(index);
  surface.DragFraction = 0.0;
  surface.IsWall = surface.IsOneSided = true;
  return surface;
}

/** Returns the surface of a volume with a cut. */
Surface ComputeKeptSurface(const HapticModel& model, const FieldAtTime& field, const Vector3& index,
  LabelMemory& memory) noexcept
{
  const CutAway& cut = *model.Baked->Cut;
  const CutPlace place = cut.Compute(index);
  const double depth = place.Depth / place.Voxel;
  if (cut.IsSolid() && depth > -CutAway::TouchDistance && depth < WallEnds && field.IsInside(index))
  {
    return MakeCutFace(model, index, place);
  }
  Surface surface =
    depth > 0.0 ? ComputeUncutSurface(model, field, index, memory) : MakeNoSurface(model);
  surface.DragFraction = place.Fraction();
  surface.Fade *= cut.IsSolid() ? 1.0 : surface.DragFraction;
  return surface;
}

} // namespace

void TurnIntoCorner(const HapticModel& model, const Vector3& lag, Surface& surface) noexcept
{
  const Matrix3 worldToDevice = Transpose(model.DeviceToWorldRotation);
  Vector3 sum;
  for (int face = 0; face < 6; ++face)
  {
    if ((surface.CutFaces >> face & 1U) != 0)
    {
      const Vector3 normal = worldToDevice * model.Baked->Cut->GetNormal(face);
      sum += std::max(0.0, Dot(lag, normal)) * normal;
    }
  }
  const double length = Norm(sum);
  if (length > DistanceEpsilon)
  {
    const double reach = 1.0 / (surface.GradientMagnitude * model.WorldUnitsPerMeter);
    surface.Normal = (1.0 / length) * sum;
    surface.Reach = model.DeviceToIndex.Linear * (reach * surface.Normal);
  }
}

Vector3 StopAtFaces(const HapticModel& model, const Vector3& from, const Vector3& to) noexcept
{
  const Vector3 start = model.DeviceToIndex(from);
  const Vector3 end = model.DeviceToIndex(to);
  const Vector3 stopped = model.Baked->Cut->StopAtFaces(start, end);
  return IsIdentical(stopped, end) ? to
                                   : to + Inverse(model.DeviceToIndex.Linear) * (stopped - end);
}

Surface ComputeOtherSurface(const HapticModel& model, const FieldAtTime& field,
  const Vector3& index, LabelMemory& memory) noexcept
{
  Surface surface;
  // A forbidden label also counts where the volume is cut away, because no cut may give access to
  // it.
  if (model.Baked->GetZone() && ComputeForbidden(model, model.IndexToLabel(index), surface))
  {
    return surface;
  }
  return model.Baked->Cut ? ComputeKeptSurface(model, field, index, memory)
                          : ComputeUncutSurface(model, field, index, memory);
}

} // namespace Law
} // namespace VolumeHaptics
