// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares all results of the sampler near the border and beyond it with naive code.
 */

#include "NaiveField.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
struct NaiveSample
{
  double Value;
  double Gradient[3];
};

/// Returns the expected result of FieldSampler at a position inside the volume.
NaiveSample Naive(const TestVolume& volume, GradientEstimator estimator, int r, const Vector3& p)
{
  const bool spline = estimator == GradientEstimator::CubicBSpline;
  NaiveSample sample{ NaiveAt(volume, p, -1, spline ? NaiveSpline : NaiveLinear), {} };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = r;
    const Vector3 e{ axis == 0 ? step : 0.0, axis == 1 ? step : 0.0, axis == 2 ? step : 0.0 };
    switch (estimator)
    {
      case GradientEstimator::CentralDifference:
        sample.Gradient[axis] =
          (NaiveAt(volume, p + e, -1, NaiveLinear) - NaiveAt(volume, p - e, -1, NaiveLinear)) /
          (2.0 * step);
        break;
      case GradientEstimator::Gaussian:
        sample.Gradient[axis] =
          NaiveAt(volume, p, axis, [r](double x) { return NaiveGaussian(r, x); });
        break;
      case GradientEstimator::CubicBSpline:
        sample.Gradient[axis] = NaiveAt(volume, p, axis, NaiveSpline);
        break;
    }
  }
  return sample;
}

class BorderSampling : public testing::TestWithParam<GradientEstimator>
{
};
} // namespace

TEST_P(BorderSampling, ValuesAndGradientsAreThoseOfNaiveCode)
{
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double scale = 1e6; // upper bound of FillRandom()'s samples
  for (const int radius : { 1, 2, 3, 5 })
  {
    for (const std::int64_t step : { 1, 3 })
    {
      // In this volume, each position is within 3 voxels of a border.
      TestVolume volume(ScalarType::Float64, { 5, 6, 7 }, step);
      volume.FillRandom(static_cast<unsigned>(radius));
      const GradientKernel kernel(this->GetParam(), radius);
      const FieldSampler sampler(volume.View, kernel);
      for (int n = 0; n < 300; ++n)
      {
        // Some positions are on voxels or exactly on the border.
        const auto along = [&](std::int64_t samples)
        {
          const double x = uniform(engine) * static_cast<double>(samples - 1);
          return uniform(engine) < 0.25 ? std::round(x) : x;
        };
        const Vector3 inside{ along(5), along(6), along(7) };
        SCOPED_TRACE(testing::Message() << "r " << radius << " step " << step << " at " << inside.X
                                        << " " << inside.Y << " " << inside.Z);
        const NaiveSample expected = Naive(volume, this->GetParam(), radius, inside);
        const FieldSample actual = sampler.Gradient(inside);
        EXPECT_NEAR(actual.Gradient.X, expected.Gradient[0], 1e-9 * scale);
        EXPECT_NEAR(actual.Gradient.Y, expected.Gradient[1], 1e-9 * scale);
        EXPECT_NEAR(actual.Gradient.Z, expected.Gradient[2], 1e-9 * scale);

        const Vector3 around{ 12.0 * uniform(engine) - 4.0, 12.0 * uniform(engine) - 4.0,
          12.0 * uniform(engine) - 4.0 };
        const double value = Naive(volume, this->GetParam(), radius, around).Value;
        EXPECT_NEAR(sampler.Value(around), value, 1e-13 * scale);
      }
    }
  }
}

TEST_P(BorderSampling, FarOutsideTheBorderValueHolds)
{
  TestVolume volume(ScalarType::Float32, { 4, 4, 4 });
  volume.FillRandom(3);
  const GradientKernel kernel(this->GetParam(), 1);
  const FieldSampler sampler(volume.View, kernel);
  const double far[] = { 1e3, 1e18, 1e300, std::numeric_limits<double>::infinity() };
  for (const double x : far)
  {
    EXPECT_EQ(sampler.Value({ x, 1.25, 2.5 }), sampler.Value({ 3.0, 1.25, 2.5 }));
    EXPECT_EQ(sampler.Value({ 0.5, -x, 2.5 }), sampler.Value({ 0.5, 0.0, 2.5 }));
    EXPECT_EQ(sampler.Value({ -x, x, -x }), sampler.Value({ 0.0, 3.0, 0.0 }));
    EXPECT_FALSE(sampler.IsInside({ x, 1.0, 1.0 }) || sampler.IsInside({ 1.0, 1.0, -x }));
  }
  EXPECT_TRUE(sampler.IsInside({ 0.0, 3.0, 1.5 }));
  EXPECT_FALSE(sampler.IsInside({ 0.0, std::nextafter(3.0, 4.0), 1.5 }));
  EXPECT_FALSE(sampler.IsInside({ -1e-300, 3.0, 1.5 }));
}

INSTANTIATE_TEST_SUITE_P(All, BorderSampling, testing::ValuesIn(AllEstimators));
