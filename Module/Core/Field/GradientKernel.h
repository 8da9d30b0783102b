// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gradient estimators and their weights.
 *
 * | estimator         | gradient from                                     | V(x) is       |
 * | ----------------- | ------------------------------------------------- | ------------- |
 * | CentralDifference | 6 trilinear samples, Radius voxels away           | trilinear     |
 * | Gaussian          | (2 Radius + 2)^3 taps, derivative of a Gaussian   | trilinear     |
 * | CubicBSpline      | 64 taps, analytic derivative of the spline        | cubic B-spline|
 *
 * All of them work at continuous positions and reproduce a linear field exactly.
 *
 * The Gaussian has the scale s = 0.53 Radius voxels and is cut at c = Radius + 1 voxels. w(t) =
 * exp(-t^2 / (2 s^2)) - exp(-c^2 / (2 s^2)) is zero there: no tap enters or leaves with a step. The
 * factor 0.53 compensates for the cut: at the default radius of 2 white noise of one unit gives a
 * gradient with a standard deviation of 0.106 units per voxel, as an uncut Gaussian of scale Radius
 * / 2 does. With m the mean of the tap offsets t_i under w, the weights along an axis are
 *   smoothing   w_i / sum w,
 *   derivative  w_i (t_i - m) / sum w (t - m)^2,
 * that is, the least-squares fit of a line. They are tabulated over the sub-voxel fraction and
 * interpolated by quintic polynomials, which keeps the sums that make linear fields exact.
 *
 * These gradients are not quite normal to the levels of any function. If that matters (a surface
 * with them as its normals would give a sliding hand energy), GaussianWeights::OwnDerivative takes
 * the fit's value,
 *   smoothing   a_i = w_i / sum w - m (the derivative weights above),
 *   derivative  d a_i / d fraction,
 * so that the gradient is the derivative of the smoothed value, to rounding. To avoid a step, w and
 * its slope go to zero at c, w(t) = exp(-u) - exp(-u_c) (1 + u_c - u), u = t^2 / (2 s^2), and s =
 * 0.56 Radius lets as much noise through.
 */
#ifndef GradientKernel_h
#define GradientKernel_h

#include "Core/Math/CacheLines.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

enum class GradientEstimator : std::uint8_t
{
  CentralDifference,
  Gaussian,
  CubicBSpline
};

enum class GaussianWeights : std::uint8_t
{
  FittedLine,
  OwnDerivative
};

/** The part of a kernel that a tick needs. Does not own the table. */
struct KernelView
{
  const double* Table = nullptr;
  int Radius = 2;
  int Taps = 6;
};

struct GradientKernel
{
  static constexpr int MaximumRadius = 16;
  /** Standard deviation of the Gaussian divided by the radius. */
  static constexpr double ScalePerRadius = 0.53;
  static constexpr double OwnScalePerRadius = 0.56;
  static constexpr int MaximumTaps = 2 * (MaximumRadius + 1);
  /**
   * Number of intervals of the sub-voxel fraction. With 32, the error of a weight is at most about
   * 1e-10.
   */
  static constexpr int Intervals = 32;
  /** Number of coefficients in each interval. */
  static constexpr int Coefficients = 6;

  GradientEstimator Estimator = GradientEstimator::Gaussian;
  GaussianWeights Weights = GaussianWeights::FittedLine;
  /** Radius in voxels, 1 to MaximumRadius. */
  int Radius = 2;
  /**
   * Number of taps of the Gaussian along an axis, from floor(x) - Radius to floor(x) + Radius + 1.
   */
  int Taps = 6;
  /** Standard deviation (voxels) of the Gaussian of GaussianWeights::OwnDerivative. */
  double OwnScale = 0.0;
  /**
   * Weights of the Gaussian: for each interval, the constant coefficients of all weights, then the
   * linear coefficients, and so on. The weights are Taps for smoothing, then Taps for the
   * derivative.
   */
  std::vector<double, CacheLines<double>> Table;

  GradientKernel() = default;
  /**
   * Computes the weights. `ownScale` is the standard deviation (voxels) for OwnDerivative; 0 for
   * its default.
   */
  GradientKernel(GradientEstimator estimator, int radius,
    GaussianWeights weights = GaussianWeights::FittedLine, double ownScale = 0.0);

  KernelView GetView() const { return { this->Table.data(), this->Radius, this->Taps }; }
};

/**
 * Computes the weights of the Gaussian for smoothing and for the derivative, at a fraction in [0,
 * 1], by the formulas above.
 */
void ComputeGaussianWeights(int radius, double fraction, double* smoothing, double* derivative);

} // namespace VolumeHaptics

#endif
