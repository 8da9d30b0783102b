// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/DisplacementField.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr int SplineTaps = 4;
constexpr int MostNewtonSteps = 3;
/** Voxels; no step follows one as short as this. */
constexpr double ShortNewtonStep = 0.01;
/** Below this determinant of the map from the first frame, the displacements fold the volume. */
constexpr double LeastVolume = 0.05;

/** The taps of a cubic B-spline along an axis, where the samples end at the border. */
struct SplineAxis
{
  std::int64_t Points[SplineTaps];
  double Weights[SplineTaps];
  double Slopes[SplineTaps];

  /** @param x an index that counts from the first point, also beyond the points */
  SplineAxis(double x, std::int64_t points) noexcept
  {
    const auto last = static_cast<double>(points - 1);
    // Also for NaN.
    const double inside = x > 0.0 ? std::min(x, last) : 0.0;
    const double base = std::min(std::floor(inside), std::max(last - 1.0, 0.0));
    const double t = inside - base;
    const double s = 1.0 - t;
    constexpr double sixth = 1.0 / 6.0;
    this->Weights[0] = sixth * s * s * s;
    this->Weights[1] = sixth * (4.0 - 3.0 * t * t * (1.0 + s));
    this->Weights[2] = sixth * (4.0 - 3.0 * s * s * (1.0 + t));
    this->Weights[3] = sixth * t * t * t;
    const bool isBeyond = inside != x;
    this->Slopes[0] = isBeyond ? 0.0 : -0.5 * s * s;
    this->Slopes[1] = isBeyond ? 0.0 : 0.5 * t * (3.0 * t - 4.0);
    this->Slopes[2] = isBeyond ? 0.0 : -0.5 * s * (3.0 * s - 4.0);
    this->Slopes[3] = isBeyond ? 0.0 : 0.5 * t * t;
    for (int tap = 0; tap < SplineTaps; ++tap)
    {
      this->Points[tap] =
        std::clamp(static_cast<std::int64_t>(base) - 1 + tap, std::int64_t{ 0 }, points - 1);
    }
  }
};

/** The three components at the taps of a row. */
constexpr int RowNumbers = 3 * SplineTaps;

Vector3 SumRow(const double (&weights)[SplineTaps], const double (&row)[RowNumbers]) noexcept
{
  Vector3 sum;
  for (int i = 0; i < SplineTaps; ++i)
  {
    sum += weights[i] * Vector3{ row[3 * i], row[3 * i + 1], row[3 * i + 2] };
  }
  return sum;
}

Matrix3 PlusIdentity(double share, const Matrix3& m) noexcept
{
  Matrix3 sum = share * m;
  sum.Row[0].X += 1.0;
  sum.Row[1].Y += 1.0;
  sum.Row[2].Z += 1.0;
  return sum;
}

} // namespace

DisplacementField::DisplacementField(
  const DisplacementView& displacements, const VolumeView& volume, const Matrix3& indexToWorld)
  : Displacements(displacements)
  , First{ volume.First[0], volume.First[1], volume.First[2] }
  , Dimensions{ volume.Dimensions[0], volume.Dimensions[1], volume.Dimensions[2] }
  , WorldToIndex(Inverse(indexToWorld))
{
}

template <typename T>
DisplacementField::Sample DisplacementField::ReadAs(const Vector3& index) const noexcept
{
  const SplineAxis x(index.X - static_cast<double>(this->First[0]), this->Dimensions[0]);
  const SplineAxis y(index.Y - static_cast<double>(this->First[1]), this->Dimensions[1]);
  const SplineAxis z(index.Z - static_cast<double>(this->First[2]), this->Dimensions[2]);
  const T* const data = static_cast<const T*>(this->Displacements.Data);
  // The rows along x, summed over y and z, and with the slopes of either instead of its weights.
  double rows[RowNumbers] = {};
  double alongY[RowNumbers] = {};
  double alongZ[RowNumbers] = {};
  for (int k = 0; k < SplineTaps; ++k)
  {
    for (int j = 0; j < SplineTaps; ++j)
    {
      const T* const from =
        data + 3 * this->Dimensions[0] * (y.Points[j] + this->Dimensions[1] * z.Points[k]);
      double row[RowNumbers];
      for (int i = 0; i < SplineTaps; ++i)
      {
        const T* const u = from + 3 * x.Points[i];
        row[3 * i] = static_cast<double>(u[0]);
        row[3 * i + 1] = static_cast<double>(u[1]);
        row[3 * i + 2] = static_cast<double>(u[2]);
      }
      const double both = y.Weights[j] * z.Weights[k];
      const double slopeY = y.Slopes[j] * z.Weights[k];
      const double slopeZ = y.Weights[j] * z.Slopes[k];
      for (int n = 0; n < RowNumbers; ++n)
      {
        rows[n] += both * row[n];
        alongY[n] += slopeY * row[n];
        alongZ[n] += slopeZ * row[n];
      }
    }
  }
  const Vector3 value = SumRow(x.Weights, rows);
  const Vector3 slopes[3] = { SumRow(x.Slopes, rows), SumRow(x.Weights, alongY),
    SumRow(x.Weights, alongZ) };
  return { this->WorldToIndex * value,
    this->WorldToIndex * Matrix3::FromColumns(slopes[0], slopes[1], slopes[2]) };
}

DisplacementField::Sample DisplacementField::Read(const Vector3& index) const noexcept
{
  return this->Displacements.Type == ScalarType::Float32 ? this->ReadAs<float>(index)
                                                         : this->ReadAs<double>(index);
}

MaterialPlace DisplacementField::Find(const Vector3& index, double share) const noexcept
{
  Vector3 first = index;
  Vector3 motion;
  MaterialPlace place;
  bool isThere = false;
  for (int i = 0; i < MostNewtonSteps && !isThere; ++i)
  {
    const Sample u = this->Read(first);
    const Matrix3 map = PlusIdentity(share, u.Slope);
    // Also false for NaN.
    if (!(Determinant(map) > LeastVolume))
    {
      motion = i > 0 ? this->Read(index).Value : u.Value;
      place.FirstSlope = place.SecondSlope = Matrix3{};
      break;
    }
    place.FirstSlope = Inverse(map);
    place.SecondSlope = PlusIdentity(1.0, u.Slope) * place.FirstSlope;
    const Vector3 step = place.FirstSlope * (index - first - share * u.Value);
    first += step;
    motion = u.Value + u.Slope * step;
    isThere = Dot(step, step) < ShortNewtonStep * ShortNewtonStep;
  }
  // By way of the motion: where there is none, this is the index itself, to the bit.
  place.First = index - share * motion;
  place.Second = index + (1.0 - share) * motion;
  return place;
}

} // namespace VolumeHaptics
