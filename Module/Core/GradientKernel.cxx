// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GradientKernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace VolumeHaptics
{

void ComputeGaussianWeights(int radius, double fraction, double* smoothing, double* derivative)
{
  const int taps = 2 * (radius + 1);
  const double s = GradientKernel::ScalePerRadius * radius;
  const double cut = radius + 1.0;
  const double scale = 1.0 / (2.0 * s * s);
  const double end = std::exp(-cut * cut * scale);

  double sum = 0.0;
  double first = 0.0;
  for (int i = 0; i < taps; ++i)
  {
    const double t = (i - radius) - fraction;
    const double w = std::exp(-t * t * scale) - end;
    smoothing[i] = w;
    sum += w;
    first += w * t;
  }
  const double mean = first / sum;
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

namespace
{

/**
 * Polynomials through the weights at equidistant fractions of an interval, by Newton's divided
 * differences. They are linear in the weights, as are the sums that make linear fields exact.
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
    ComputeGaussianWeights(
      kernel.Radius, fraction, weights[j].data(), weights[j].data() + kernel.Taps);
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
    // Multiplied out, from the innermost bracket of Newton's form.
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

GradientKernel::GradientKernel(GradientEstimator estimator, int radius)
  : Estimator(estimator)
  , Radius(std::clamp(radius, 1, MaximumRadius))
  , Taps(2 * (this->Radius + 1))
{
  if (estimator != GradientEstimator::Gaussian)
  {
    return;
  }
  const int count = 2 * this->Taps;
  this->Table.resize(static_cast<std::size_t>(Intervals) * Coefficients * count);
  this->Mean.resize(Intervals * Coefficients);
  for (int interval = 0; interval < Intervals; ++interval)
  {
    double* const weights =
      &this->Table[static_cast<std::size_t>(interval) * Coefficients * count];
    Interpolate(*this, interval, weights);
    double* const mean = &this->Mean[interval * Coefficients];
    for (int p = 0; p < Coefficients; ++p)
    {
      for (int i = 0; i < this->Taps; ++i)
      {
        mean[p] += (i - this->Radius) * weights[p * count + i];
      }
    }
    // Seen from the position: the fraction is taken off.
    mean[0] -= static_cast<double>(interval) / Intervals;
    mean[1] -= 1.0 / Intervals;
  }
}

} // namespace VolumeHaptics
