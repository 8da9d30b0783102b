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

GradientKernel::GradientKernel(GradientEstimator estimator, int radius)
  : Estimator(estimator)
  , Radius(std::clamp(radius, 1, MaximumRadius))
  , Taps(2 * (this->Radius + 1))
{
  if (estimator != GradientEstimator::Gaussian)
  {
    return;
  }
  // Slopes by a fourth-order central difference of the weights themselves: the combination of
  // weights that is exact on linear fields stays so, which an analytic slope would also give, but
  // with no second set of formulas to keep in step.
  constexpr double step = 1.0 / 2048.0;
  const int taps = this->Taps;
  this->Table.resize(static_cast<std::size_t>(Intervals + 1) * 4 * taps);
  std::array<double, 2 * MaximumTaps> far[2];
  std::array<double, 2 * MaximumTaps> near[2];
  for (int row = 0; row <= Intervals; ++row)
  {
    double* const weights = &this->Table[static_cast<std::size_t>(row) * 4 * taps];
    const double fraction = static_cast<double>(row) / Intervals;
    const auto evaluate = [&](double f, double* to)
    { ComputeGaussianWeights(this->Radius, f, to, to + taps); };
    evaluate(fraction, weights);
    for (int side = 0; side < 2; ++side)
    {
      const double sign = side == 0 ? -1.0 : 1.0;
      evaluate(fraction + sign * step, near[side].data());
      evaluate(fraction + 2.0 * sign * step, far[side].data());
    }
    for (int i = 0; i < 2 * taps; ++i)
    {
      const double slope =
        (8.0 * (near[1][i] - near[0][i]) - (far[1][i] - far[0][i])) / (12.0 * step);
      weights[2 * taps + i] = slope / Intervals;
    }
  }
}

} // namespace VolumeHaptics
