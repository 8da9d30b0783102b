// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the effect of white noise on a gradient against the kernel's actual weights, and against
 * the documented formula for the ideal Gaussian.
 */

#include "Random.h"
#include "ReferenceField.h"
#include "SampledImage.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace reference;

namespace
{
constexpr int Size = 72;

// Returns the RMS of a gradient component (1/voxel) for noise with a standard deviation of 1, at a
// `fraction` above the voxels. `tail` receives the fraction of magnitudes above 3.4 times the RMS.
double MeasuredNoise(Estimator estimator, int radius, double fraction, double* tail = nullptr)
{
  Random random(42);
  Geometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    geometry.extent[2 * axis + 1] = Size - 1;
  }
  Scene scene;
  scene.image = Sample(geometry, [&](const Vec3&) { return random.Normal(); });
  scene.estimator = estimator;
  scene.kernelRadius = radius;
  scene.method = Method::ForceField;
  scene.forceFieldGain = 1.0;
  scene.path.push_back({});
  for (int n = 0; n < 60000; ++n)
  {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = random.Integer(radius + 1, Size - radius - 3) + fraction;
    }
    scene.path.push_back(point);
  }
  const Trace trace = RunFilter(scene);
  double sum = 0.0;
  for (const TickRecord& tick : trace)
  {
    sum += Dot(tick.force, tick.force);
  }
  const double sigma = std::sqrt(sum / (3.0 * (trace.size() - 1)));
  double beyond = 0.0;
  for (const TickRecord& tick : trace)
  {
    beyond += Norm(tick.force) > 3.4 * sigma;
  }
  if (tail)
  {
    *tail = beyond / (trace.size() - 1);
  }
  return sigma;
}

double SumOfSquares(const std::vector<double>& weights)
{
  double sum = 0.0;
  for (double weight : weights)
  {
    sum += weight * weight;
  }
  return sum;
}

double IdealNoise(double s)
{
  const double pi = 3.141592653589793;
  return std::sqrt(1.0 / (2.0 * s * s) * std::pow(4.0 * pi * s * s, -1.5));
}
} // namespace

TEST(GradientNoise, GaussianIsAsQuietAsItsWeights)
{
  for (int radius : { 2, 4 })
  {
    for (double fraction : { 0.0, 0.5 })
    {
      std::vector<double> smoothing;
      std::vector<double> derivative;
      ReferenceField::GaussianWeights(radius, fraction, smoothing, derivative);
      const double expected = std::sqrt(SumOfSquares(derivative)) * SumOfSquares(smoothing);
      const double measured = MeasuredNoise(Estimator::Gaussian, radius, fraction);
      // The 180000 components are correlated within a kernel's reach, which causes an error of
      // about 1 %.
      EXPECT_NEAR(measured, expected, 0.02 * expected);
      std::cout << "GAUSSIAN r = " << radius << ", " << fraction << " off the voxels: sigma_g "
                << measured << ", its weights say " << expected
                << ", the ideal Gaussian of s = " << radius / 2.0 << " has "
                << IdealNoise(radius / 2.0) << " sigma_V/voxel" << std::endl;
    }
  }
}

TEST(GradientNoise, CentralDifferencesAreLoud)
{
  EXPECT_NEAR(MeasuredNoise(Estimator::CentralDifference, 1, 0.0), std::sqrt(0.5), 0.01);
}

TEST(GradientNoise, SpecifiedFormula)
{
  EXPECT_NEAR(IdealNoise(1.0), 0.106, 0.0005);
  EXPECT_NEAR(IdealNoise(2.0), 0.019, 0.0005);
}

TEST(GradientNoise, OnePercentPassesARampThatStartsAtItsTail)
{
  double tail = 0.0;
  MeasuredNoise(Estimator::Gaussian, 2, 0.25, &tail);
  EXPECT_NEAR(tail, 0.00905, 0.002) << "Maxwell: 0.9 % beyond 3.4 sigma";
}
