// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticNoise.h"

#include "vtkDataArray.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{
constexpr int Reach = 2;
constexpr int Side = 2 * Reach + 1;
constexpr int Samples = Side * Side * Side;
constexpr int Quadratic = 10; // coefficients
constexpr int MostBlocksAlongAnAxis = 16;
/** Of the blocks, in ascending order of what is left of them. */
constexpr double Flattest = 0.1;
/** The tenth part of estimates from 115 degrees of freedom lies below this share of what they estimate. */
constexpr double ShareAtFlattest = 0.916;
/** Noise below this share of the largest value is rounding. */
constexpr double Rounding = 1e-9;
constexpr double NoiseThreshold = 3.4;

/** Orthogonal on -2 ... 2: constant, line and parabola, with the sums of their squares. */
constexpr double Basis[3][Side] = { { 1, 1, 1, 1, 1 }, { -2, -1, 0, 1, 2 }, { 2, -1, -2, -1, 2 } };
constexpr double Squares[3] = { 5, 10, 14 };
/** The products of degree 2 at most. */
constexpr int Terms[Quadratic][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } };

/** The sum of squares that is left of a block when the best quadratic is taken off. */
double Remainder(const double* block)
{
  // Around the middle, so that no digits are lost.
  const double middle = block[Samples / 2];
  double left = 0.0;
  for (int i = 0; i < Samples; ++i)
  {
    left += (block[i] - middle) * (block[i] - middle);
  }
  for (const int* term : Terms)
  {
    double sum = 0.0;
    for (int i = 0; i < Samples; ++i)
    {
      sum += (block[i] - middle) * Basis[term[0]][i % Side] * Basis[term[1]][i / Side % Side] *
        Basis[term[2]][i / (Side * Side)];
    }
    left -= sum * sum / (Squares[term[0]] * Squares[term[1]] * Squares[term[2]]);
  }
  return std::max(0.0, left);
}

/** Standard deviation of an estimated gradient component per voxel, of noise of one unit. */
double NoiseGain(const GradientKernel& kernel)
{
  // White noise through a kernel: the root of the sum of the squared weights, averaged over positions.
  constexpr int positions = 32;
  double smoothing = 0.0;
  double slope = 0.0;
  for (int p = 0; p < positions; ++p)
  {
    const double t = (p + 0.5) / positions;
    double s = 0.0;
    double d = 0.0;
    if (kernel.Estimator == GradientEstimator::CentralDifference)
    {
      s = (1.0 - t) * (1.0 - t) + t * t;
      d = 2.0 * s / (4.0 * kernel.Radius * kernel.Radius);
    }
    else if (kernel.Estimator == GradientEstimator::CubicBSpline)
    {
      const double w[4] = { std::pow(1.0 - t, 3) / 6.0, 2.0 / 3.0 - t * t * (2.0 - t) / 2.0,
        2.0 / 3.0 - (1.0 - t) * (1.0 - t) * (1.0 + t) / 2.0, t * t * t / 6.0 };
      const double v[4] = { -0.5 * (1.0 - t) * (1.0 - t), -2.0 * t + 1.5 * t * t,
        2.0 * (1.0 - t) - 1.5 * (1.0 - t) * (1.0 - t), 0.5 * t * t };
      for (int i = 0; i < 4; ++i)
      {
        s += w[i] * w[i];
        d += v[i] * v[i];
      }
    }
    else
    {
      // At the middle of an interval of the table, where its polynomials are read at 1/2.
      const int count = 2 * kernel.Taps;
      const double* const c =
        &kernel.Table[static_cast<std::size_t>(p) * GradientKernel::Coefficients * count];
      for (int i = 0; i < count; ++i)
      {
        double weight = 0.0;
        for (int power = GradientKernel::Coefficients - 1; power >= 0; --power)
        {
          weight = 0.5 * weight + c[power * count + i];
        }
        (i < kernel.Taps ? s : d) += weight * weight;
      }
    }
    smoothing += s / positions;
    slope += d / positions;
  }
  return smoothing * std::sqrt(slope);
}
static_assert(GradientKernel::Intervals == 32, "NoiseGain reads one position per interval");

} // namespace

double EstimateNoise(vtkDataArray* scalars, const VolumeView& view, int component)
{
  const std::int64_t* const n = view.Dimensions;
  std::int64_t step[3];
  for (int a = 0; a < 3; ++a)
  {
    if (n[a] < Side)
    {
      return 0.0;
    }
    step[a] = std::max<std::int64_t>(Side, n[a] / MostBlocksAlongAnAxis);
  }
  double range[2];
  scalars->GetRange(range, component);
  std::vector<double> left;
  double block[Samples];
  for (std::int64_t z = 0; z + Side <= n[2]; z += step[2])
  {
    for (std::int64_t y = 0; y + Side <= n[1]; y += step[1])
    {
      for (std::int64_t x = 0; x + Side <= n[0]; x += step[0])
      {
        bool isFlat = true;
        bool isFinite = true;
        for (int i = 0; i < Samples; ++i)
        {
          const std::int64_t tuple =
            (x + i % Side) + n[0] * ((y + i / Side % Side) + n[1] * (z + i / (Side * Side)));
          block[i] = scalars->GetComponent(tuple, component);
          isFlat = isFlat && block[i] == block[0];
          isFinite = isFinite && std::isfinite(block[i]);
        }
        if (isFinite && !(isFlat && (block[0] == range[0] || block[0] == range[1])))
        {
          left.push_back(isFlat ? 0.0 : Remainder(block));
        }
      }
    }
  }
  if (left.empty())
  {
    return 0.0;
  }
  const auto tenth = left.begin() + static_cast<std::ptrdiff_t>(Flattest * (left.size() - 1));
  std::nth_element(left.begin(), tenth, left.end());
  const double noise = std::sqrt(*tenth / (Samples - Quadratic)) / ShareAtFlattest;
  return noise > Rounding * std::max(std::abs(range[0]), std::abs(range[1])) ? noise : 0.0;
}

Polyline MakeNoiseRamp(double noise, const GradientKernel& kernel, const Affine3& indexToWorld)
{
  if (!(noise > 0.0))
  {
    return {};
  }
  const Matrix3 columns = Transpose(indexToWorld.Linear);
  const double finest =
    std::min({ Norm(columns.Row[0]), Norm(columns.Row[1]), Norm(columns.Row[2]) });
  const double start = NoiseThreshold * noise * NoiseGain(kernel) / finest;
  return { { start, 0.0 }, { 2.0 * start, 1.0 } };
}

} // namespace VolumeHaptics
