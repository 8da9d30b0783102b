// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/GradientKernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace VolumeHaptics
{

namespace
{

/**
 * Computes tap weights for a line that is fitted by least squares with the weights `window`. The
 * sum with `smoothing` is the line's value at `mean`, the weighted mean of the taps' positions, and
 * the sum with `derivative` is its slope.
 */
void FitLine(int radius, double fraction, const std::function<double(double)>& window,
  double* smoothing, double* derivative, double& mean)
{
  const int taps = 2 * (radius + 1);
  double sum = 0.0;
  double first = 0.0;
  for (int i = 0; i < taps; ++i)
  {
    const double t = (i - radius) - fraction;
    const double w = window(t);
    smoothing[i] = w;
    sum += w;
    first += w * t;
  }
  mean = first / sum;
  double second = 0.0;
  for (int i = 0; i < taps; ++i)
  {
    const double t = (i - radius) - fraction - mean;
    derivative[i] = smoothing[i] * t;
    second += smoothing[i] * t * t;
  }
  for (int i = 0; i < taps; ++i)
  {
    smoothing[i] /= sum;
    derivative[i] /= second;
  }
}

} // namespace

void ComputeGaussianWeights(int radius, double fraction, double* smoothing, double* derivative)
{
  const double s = GradientKernel::ScalePerRadius * radius;
  const double cut = radius + 1.0;
  const double scale = 1.0 / (2.0 * s * s);
  const double end = std::exp(-cut * cut * scale);
  double mean;
  FitLine(
    radius, fraction, [=](double t) { return std::exp(-t * t * scale) - end; }, smoothing,
    derivative, mean);
}

namespace
{

/**
 * Computes the weights a_i of a value that is fitted by a line, for GaussianWeights::OwnDerivative.
 * `slope` receives the slope's weights, which Differentiate() later replaces by the derivative of
 * the a_i.
 */
void ComputeFittedValueWeights(int radius, double s, double fraction, double* value, double* slope)
{
  const double cut = radius + 1.0;
  const double scale = 1.0 / (2.0 * s * s);
  const double atCut = cut * cut * scale;
  const double end = std::exp(-atCut);
  double mean;
  FitLine(
    radius, fraction,
    [=](double t)
    {
      const double u = t * t * scale;
      return u < atCut ? std::exp(-u) - end * (1.0 + atCut - u) : 0.0;
    },
    value, slope, mean);
  for (int i = 0; i < 2 * (radius + 1); ++i)
  {
    value[i] -= mean * slope[i];
  }
}

/**
 * Computes the polynomials of the derivative weights, as derivatives of the smoothing weights'
 * polynomials with respect to the fraction.
 */
void Differentiate(const GradientKernel& kernel, double* coefficients)
{
  const int count = 2 * kernel.Taps;
  for (int p = 0; p < GradientKernel::Coefficients; ++p)
  {
    for (int i = 0; i < kernel.Taps; ++i)
    {
      coefficients[p * count + kernel.Taps + i] = p + 1 < GradientKernel::Coefficients
        ? GradientKernel::Intervals * (p + 1) * coefficients[(p + 1) * count + i]
        : 0.0;
    }
  }
}

/**
 * Computes the polynomials through the weights at equidistant fractions of an interval, by Newton's
 * divided differences. The polynomials depend linearly on the weights, as do the sums that make
 * linear fields exact.
 */
void Interpolate(const GradientKernel& kernel, int interval, double* coefficients)
{
  constexpr int order = GradientKernel::Coefficients;
  const int count = 2 * kernel.Taps;
  const auto node = [](int j) { return static_cast<double>(j) / (order - 1); };
  std::array<double, 2 * GradientKernel::MaximumTaps> weights[order];
  for (int j = 0; j < order; ++j)
  {
    const double fraction = (interval + node(j)) / GradientKernel::Intervals;
    double* const smoothing = weights[j].data();
    double* const derivative = smoothing + kernel.Taps;
    if (kernel.Weights == GaussianWeights::OwnDerivative)
    {
      ComputeFittedValueWeights(kernel.Radius, kernel.OwnScale, fraction, smoothing, derivative);
    }
    else
    {
      ComputeGaussianWeights(kernel.Radius, fraction, smoothing, derivative);
    }
  }
  for (int i = 0; i < count; ++i)
  {
    double difference[order];
    for (int j = 0; j < order; ++j)
    {
      difference[j] = weights[j][i];
    }
    for (int level = 1; level < order; ++level)
    {
      for (int j = order - 1; j >= level; --j)
      {
        difference[j] = (difference[j] - difference[j - 1]) / (node(j) - node(j - level));
      }
    }
    // Multiply out Newton's form, beginning with the innermost bracket.
    double power[order] = { difference[order - 1] };
    for (int j = order - 2; j >= 0; --j)
    {
      for (int p = order - 1; p > 0; --p)
      {
        power[p] = power[p - 1] - node(j) * power[p];
      }
      power[0] = difference[j] - node(j) * power[0];
    }
    for (int p = 0; p < order; ++p)
    {
      coefficients[p * count + i] = power[p];
    }
  }
}

} // namespace

GradientKernel::GradientKernel(
  GradientEstimator estimator, int radius, GaussianWeights weights, double ownScale)
  : Estimator(estimator)
  , Weights(weights)
  , Radius(std::clamp(radius, 1, MaximumRadius))
  , Taps(2 * (this->Radius + 1))
  , OwnScale(ownScale > 0.0 ? ownScale : OwnScalePerRadius * this->Radius)
{
  if (estimator != GradientEstimator::Gaussian)
  {
    return;
  }
  const int count = 2 * this->Taps;
  this->Table.resize(static_cast<std::size_t>(Intervals) * Coefficients * count);
  for (int interval = 0; interval < Intervals; ++interval)
  {
    double* const coefficients =
      &this->Table[static_cast<std::size_t>(interval) * Coefficients * count];
    Interpolate(*this, interval, coefficients);
    if (weights == GaussianWeights::OwnDerivative)
    {
      Differentiate(*this, coefficients);
    }
  }
}

} // namespace VolumeHaptics
