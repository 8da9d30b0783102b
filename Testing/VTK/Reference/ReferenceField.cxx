// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReferenceField.h"

#include <vtkMatrix3x3.h>

#include <algorithm>

namespace reference
{
ReferenceField::ReferenceField(
  vtkImageData* image, vtkDataArray* scalars, int component, Estimator estimator, int kernelRadius)
  : Scalars(scalars)
  , Component(component)
  , Kind(estimator)
  , Radius(kernelRadius)
{
  image->GetExtent(this->Extent);
  const double* spacing = image->GetSpacing();
  this->LargestSpacing = std::max({ spacing[0], spacing[1], spacing[2] });
  Mat3 worldFromIndex;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = image->GetOrigin()[axis];
    for (int row = 0; row < 3; ++row)
    {
      worldFromIndex.column[axis][row] =
        image->GetDirectionMatrix()->GetElement(row, axis) * spacing[axis];
    }
  }
  this->WorldFromIndexTransposedInverse = InverseTransposed(worldFromIndex);
}

Vec3 ReferenceField::Index(const Vec3& world) const
{
  return TransposedTimes(this->WorldFromIndexTransposedInverse, world - this->Origin);
}

Vec3 ReferenceField::Clamped(Vec3 index) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] =
      std::clamp(index[axis], double(this->Extent[2 * axis]), double(this->Extent[2 * axis + 1]));
  }
  return index;
}

bool ReferenceField::Inside(const Vec3& index) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] < this->Extent[2 * axis] || index[axis] > this->Extent[2 * axis + 1])
    {
      return false;
    }
  }
  return true;
}

double ReferenceField::Voxel(int i, int j, int k) const
{
  const int* e = this->Extent;
  const vtkIdType x = std::clamp(i, e[0], e[1]) - e[0];
  const vtkIdType y = std::clamp(j, e[2], e[3]) - e[2];
  const vtkIdType z = std::clamp(k, e[4], e[5]) - e[4];
  const vtkIdType nx = e[1] - e[0] + 1;
  const vtkIdType ny = e[3] - e[2] + 1;
  return this->Scalars->GetComponent(x + nx * (y + ny * z), this->Component);
}

double ReferenceField::Trilinear(const Vec3& index) const
{
  const Vec3 p = this->Clamped(index);
  int base[3];
  double f[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    base[axis] = int(std::floor(p[axis]));
    f[axis] = p[axis] - base[axis];
  }
  double sum = 0.0;
  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        const double weight =
          (i ? f[0] : 1.0 - f[0]) * (j ? f[1] : 1.0 - f[1]) * (k ? f[2] : 1.0 - f[2]);
        sum += weight * this->Voxel(base[0] + i, base[1] + j, base[2] + k);
      }
    }
  }
  return sum;
}

// Uniform cubic B-spline and its slope, at the distance t from a tap.
static double BSpline(double t)
{
  t = std::abs(t);
  return t < 1.0 ? 2.0 / 3.0 - t * t + t * t * t / 2.0
                 : (t < 2.0 ? (2.0 - t) * (2.0 - t) * (2.0 - t) / 6.0 : 0.0);
}

static double BSplineSlope(double t)
{
  const double a = std::abs(t);
  const double slope =
    a < 1.0 ? -2.0 * a + 1.5 * a * a : (a < 2.0 ? -(2.0 - a) * (2.0 - a) / 2.0 : 0.0);
  return t < 0.0 ? -slope : slope;
}

double ReferenceField::Spline(const Vec3& index, int derivativeAxis) const
{
  const Vec3 p = this->Clamped(index);
  int base[3];
  double weight[3][4];
  for (int axis = 0; axis < 3; ++axis)
  {
    base[axis] = int(std::floor(p[axis])) - 1;
    for (int i = 0; i < 4; ++i)
    {
      const double t = p[axis] - (base[axis] + i);
      weight[axis][i] = axis == derivativeAxis ? BSplineSlope(t) : BSpline(t);
    }
  }
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 4; ++i)
      {
        sum += weight[0][i] * weight[1][j] * weight[2][k] *
          this->Voxel(base[0] + i, base[1] + j, base[2] + k);
      }
    }
  }
  return sum;
}

void ReferenceField::GaussianWeights(
  int radius, double f, std::vector<double>& smoothing, std::vector<double>& derivative)
{
  const double s = 0.53 * radius;
  const double c = radius + 1.0;
  const double end = std::exp(-c * c / (2.0 * s * s));
  const int taps = 2 * (radius + 1);
  std::vector<double> t(taps);
  std::vector<double> w(taps);
  double sum = 0.0;
  double mean = 0.0;
  for (int i = 0; i < taps; ++i)
  {
    t[i] = i - radius - f;
    w[i] = std::exp(-t[i] * t[i] / (2.0 * s * s)) - end;
    sum += w[i];
    mean += w[i] * t[i];
  }
  mean /= sum;
  double variance = 0.0;
  for (int i = 0; i < taps; ++i)
  {
    variance += w[i] * (t[i] - mean) * (t[i] - mean);
  }
  smoothing.resize(taps);
  derivative.resize(taps);
  for (int i = 0; i < taps; ++i)
  {
    smoothing[i] = w[i] / sum;
    derivative[i] = w[i] * (t[i] - mean) / variance;
  }
}

double ReferenceField::GaussianDerivative(const Vec3& index, int axis) const
{
  int base[3];
  std::vector<double> weight[3];
  for (int a = 0; a < 3; ++a)
  {
    base[a] = int(std::floor(index[a])) - this->Radius;
    std::vector<double> smoothing;
    std::vector<double> derivative;
    GaussianWeights(this->Radius, index[a] - std::floor(index[a]), smoothing, derivative);
    weight[a] = a == axis ? derivative : smoothing;
  }
  const int taps = 2 * (this->Radius + 1);
  double sum = 0.0;
  for (int k = 0; k < taps; ++k)
  {
    for (int j = 0; j < taps; ++j)
    {
      for (int i = 0; i < taps; ++i)
      {
        sum += weight[0][i] * weight[1][j] * weight[2][k] *
          this->Voxel(base[0] + i, base[1] + j, base[2] + k);
      }
    }
  }
  return sum;
}

double ReferenceField::Value(const Vec3& world) const
{
  const Vec3 index = this->Index(world);
  return this->Kind == Estimator::CubicBSpline ? this->Spline(index, -1) : this->Trilinear(index);
}

Vec3 ReferenceField::Gradient(const Vec3& world) const
{
  const Vec3 index = this->Index(world);
  Vec3 g;
  if (!this->Inside(index))
  {
    return g;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->Kind == Estimator::CentralDifference)
    {
      Vec3 step;
      step[axis] = this->Radius;
      g[axis] =
        (this->Trilinear(index + step) - this->Trilinear(index - step)) / (2.0 * this->Radius);
    }
    else if (this->Kind == Estimator::Gaussian)
    {
      g[axis] = this->GaussianDerivative(index, axis);
    }
    else
    {
      g[axis] = this->Spline(index, axis);
    }
  }
  return IsFinite(g) ? this->WorldFromIndexTransposedInverse * g : Vec3();
}

double ReferenceField::GradientFloor(const Vec3& world) const
{
  const double value = this->Value(world);
  return std::isfinite(value) ? 1e-12 * std::abs(value) / this->LargestSpacing : 0.0;
}

double ReferenceField::BorderFade(const Vec3& world) const
{
  const Vec3 index = this->Index(world);
  double fade = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double distance =
      std::min(index[axis] - this->Extent[2 * axis], this->Extent[2 * axis + 1] - index[axis]);
    fade = std::min(fade, std::clamp(distance / this->Radius, 0.0, 1.0));
  }
  return fade;
}

double ReferenceField::KernelLength() const
{
  return this->Radius * this->LargestSpacing;
}
} // namespace reference
