// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Computes values and gradients of a TestVolume directly from the formulas. Each tap is read by its
 * index; beyond the border, the sample at the border is used.
 */
#ifndef NaiveField_h
#define NaiveField_h

#include "Rigs/TestVolume.h"

#include <vector>

namespace coretest
{
/// One axis of a separable kernel: its first tap, and the weights of value and derivative.
struct AxisKernel
{
  std::int64_t First;
  std::vector<double> Smooth;
  std::vector<double> Slope;
};

inline double Clamp(double x, std::int64_t samples)
{
  return std::max(0.0, std::min(x, static_cast<double>(samples - 1)));
}

/// Returns the Gaussian kernel w(t) = G(t) - G(c), with G of scale s = 0.53 r and c = r + 1.
inline AxisKernel NaiveGaussian(int r, double x)
{
  AxisKernel kernel{ static_cast<std::int64_t>(std::floor(x)) - r, {}, {} };
  const double s = 0.53 * r;
  const double c = r + 1.0;
  const auto gauss = [&](double t) { return std::exp(-t * t / (2.0 * s * s)); };
  double sum = 0.0;
  double mean = 0.0;
  for (int i = 0; i < 2 * (r + 1); ++i)
  {
    const double t = static_cast<double>(kernel.First + i) - x;
    const double w = gauss(t) - gauss(c);
    kernel.Smooth.push_back(w);
    sum += w;
    mean += w * t;
  }
  mean /= sum;
  double variance = 0.0;
  for (int i = 0; i < 2 * (r + 1); ++i)
  {
    const double t = static_cast<double>(kernel.First + i) - x - mean;
    kernel.Slope.push_back(kernel.Smooth[i] * t);
    variance += kernel.Smooth[i] * t * t;
  }
  for (int i = 0; i < 2 * (r + 1); ++i)
  {
    kernel.Smooth[i] /= sum;
    kernel.Slope[i] /= variance;
  }
  return kernel;
}

/// Returns the uniform cubic B-spline and its derivative as functions of the distance.
inline AxisKernel NaiveSpline(double x)
{
  AxisKernel kernel{ static_cast<std::int64_t>(std::floor(x)) - 1, {}, {} };
  for (int i = 0; i < 4; ++i)
  {
    const double t = x - static_cast<double>(kernel.First + i);
    const double d = std::abs(t);
    const double outer = std::max(0.0, 2.0 - d);
    kernel.Smooth.push_back(
      d < 1.0 ? 2.0 / 3.0 - d * d + 0.5 * d * d * d : outer * outer * outer / 6.0);
    const double byDistance = d < 1.0 ? 1.5 * d * d - 2.0 * d : -0.5 * outer * outer;
    kernel.Slope.push_back(t < 0.0 ? -byDistance : byDistance);
  }
  return kernel;
}

/// Returns linear interpolation as a kernel. Its derivative is not used.
inline AxisKernel NaiveLinear(double x)
{
  const double cell = std::floor(x);
  return { static_cast<std::int64_t>(cell), { 1.0 - (x - cell), x - cell }, { -1.0, 1.0 } };
}

/// Returns the weighted sum over all taps. `derivative` is the axis to differentiate along, or -1
/// for the value.
inline double NaiveSum(const TestVolume& volume, const AxisKernel (&axes)[3], int derivative)
{
  double sum = 0.0;
  const auto weight = [&](int axis, std::size_t i)
  { return derivative == axis ? axes[axis].Slope[i] : axes[axis].Smooth[i]; };
  for (std::size_t k = 0; k < axes[2].Smooth.size(); ++k)
  {
    for (std::size_t j = 0; j < axes[1].Smooth.size(); ++j)
    {
      for (std::size_t i = 0; i < axes[0].Smooth.size(); ++i)
      {
        sum += weight(0, i) * weight(1, j) * weight(2, k) *
          volume(axes[0].First + static_cast<std::int64_t>(i),
            axes[1].First + static_cast<std::int64_t>(j),
            axes[2].First + static_cast<std::int64_t>(k));
      }
    }
  }
  return sum;
}

/// Clamps a position to the volume, and returns the weighted sum of the samples there. `along`
/// computes the kernel of an axis.
template <typename F>
double NaiveAt(const TestVolume& volume, const Vector3& p, int derivative, F&& along)
{
  const std::int64_t* const n = volume.View.Dimensions;
  const AxisKernel axes[3] = { along(Clamp(p.X, n[0])), along(Clamp(p.Y, n[1])),
    along(Clamp(p.Z, n[2])) };
  return NaiveSum(volume, axes, derivative);
}
} // namespace coretest

#endif
