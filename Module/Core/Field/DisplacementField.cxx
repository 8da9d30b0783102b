// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/DisplacementField.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int MostNewtonSteps = 3;
/** A step that is shorter than this length (voxels) is the last one. */
constexpr double ShortNewtonStep = 0.01;
/**
 * The volume counts as folded where the determinant of the map from the first time step is below
 * this limit.
 */
constexpr double LeastVolume = 0.05;

VectorView MakeVectorView(const DisplacementView& displacements, const VolumeView& volume)
{
  VectorView view;
  view.Volume = volume;
  view.Volume.Data = displacements.Data;
  view.Volume.Type = displacements.Type;
  view.Volume.Stride[0] = view.Components;
  view.Volume.Stride[1] = view.Volume.Stride[0] * volume.Dimensions[0];
  view.Volume.Stride[2] = view.Volume.Stride[1] * volume.Dimensions[1];
  return view;
}

Matrix3 PlusIdentity(double fraction, const Matrix3& m) noexcept
{
  Matrix3 sum = fraction * m;
  sum.Row[0].X += 1.0;
  sum.Row[1].Y += 1.0;
  sum.Row[2].Z += 1.0;
  return sum;
}

} // namespace

DisplacementField::DisplacementField(
  const DisplacementView& displacements, const VolumeView& volume, const Matrix3& indexToWorld)
  : Given(displacements)
  , Displacements(MakeVectorView(displacements, volume))
  , Low{ static_cast<double>(volume.First[0]), static_cast<double>(volume.First[1]),
    static_cast<double>(volume.First[2]) }
  , High{ static_cast<double>(volume.Last(0)), static_cast<double>(volume.Last(1)),
    static_cast<double>(volume.Last(2)) }
  , WorldToIndex(Inverse(indexToWorld))
{
}

DisplacementField::Sample DisplacementField::Read(const Vector3& index) const noexcept
{
  // With the arguments in this order, NaN is clamped, too.
  const Vector3 inside = Least(Most(index, this->Low), this->High);
  VectorSample found;
  if (!this->Displacements.Sample(inside, found))
  {
    return {};
  }
  Matrix3 slope{ { found.Gradient[0], found.Gradient[1], found.Gradient[2] } };
  for (Vector3& row : slope.Row)
  {
    // Outside the points, the displacement is constant.
    row.X = inside.X == index.X ? row.X : 0.0;
    row.Y = inside.Y == index.Y ? row.Y : 0.0;
    row.Z = inside.Z == index.Z ? row.Z : 0.0;
  }
  return { this->WorldToIndex * Vector3{ found.Value[0], found.Value[1], found.Value[2] },
    this->WorldToIndex * slope };
}

MaterialPlace DisplacementField::Compute(const Vector3& index, double fraction) const noexcept
{
  Vector3 first = index;
  Vector3 motion;
  MaterialPlace place;
  bool isThere = false;
  for (int i = 0; i < MostNewtonSteps && !isThere; ++i)
  {
    const Sample u = this->Read(first);
    const Matrix3 map = PlusIdentity(fraction, u.Slope);
    // The comparison is false for NaN, too.
    if (!(Determinant(map) > LeastVolume))
    {
      motion = i > 0 ? this->Read(index).Value : u.Value;
      place.FirstSlope = place.SecondSlope = Matrix3{};
      break;
    }
    place.FirstSlope = Inverse(map);
    place.SecondSlope = PlusIdentity(1.0, u.Slope) * place.FirstSlope;
    const Vector3 step = place.FirstSlope * (index - first - fraction * u.Value);
    first += step;
    motion = u.Value + u.Slope * step;
    isThere = Dot(step, step) < ShortNewtonStep * ShortNewtonStep;
  }
  // Add multiples of the motion, so that without a motion both places equal the index, to the bit.
  place.First = index - fraction * motion;
  place.Second = index + (1.0 - fraction) * motion;
  return place;
}

} // namespace VolumeHaptics
