// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Measures the Gaussian's weights with impulses. The interpolated weights of the table must equal
 * those of the documented formula.
 */

#include "NaiveField.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
class GradientKernelOf : public testing::TestWithParam<int>
{
protected:
  const int Radius = this->GetParam();
  const int Taps = 2 * (this->Radius + 1);
  const std::int64_t Size = 2 * this->Taps;
};

/// Returns fractions of a voxel: evenly spaced ones, the ends of the table's intervals, and values
/// just beside these ends.
std::vector<double> Fractions()
{
  std::vector<double> fractions;
  for (int i = 0; i <= 1000; ++i)
  {
    fractions.push_back(i / 1001.0);
  }
  for (int interval = 0; interval < GradientKernel::Intervals; ++interval)
  {
    const double edge = static_cast<double>(interval) / GradientKernel::Intervals;
    fractions.insert(fractions.end(), { edge, std::nextafter(edge, 1.0) });
  }
  return fractions;
}
} // namespace

TEST_P(GradientKernelOf, WeightsAreThoseOfTheFormula)
{
  const GradientKernel kernel(GradientEstimator::Gaussian, this->Radius);
  ASSERT_EQ(kernel.Taps, this->Taps);
  double worst = 0.0;
  for (const double fraction : Fractions())
  {
    const double middle = static_cast<double>(this->Size / 2) + fraction;
    const AxisKernel expected = NaiveGaussian(this->Radius, middle);
    std::vector<double> smooth(this->Taps);
    std::vector<double> slope(this->Taps);
    ComputeGaussianWeights(this->Radius, fraction, smooth.data(), slope.data());
    for (int i = 0; i < this->Taps; ++i)
    {
      EXPECT_NEAR(smooth[i], expected.Smooth[i], 1e-14);
      EXPECT_NEAR(slope[i], expected.Slope[i], 1e-13);
    }
  }
  // All samples of a plane are 1. The smoothing weights across the plane add up to 1, so the result
  // is the weight of a single tap.
  for (int tap = 0; tap < this->Taps; ++tap)
  {
    TestVolume volume(ScalarType::UInt8, { this->Size, this->Size, this->Size });
    const std::int64_t plane = this->Size / 2 - this->Radius + tap;
    const int axis = tap % 3;
    volume.Fill<std::uint8_t>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const std::int64_t at[3] = { i, j, k };
        return at[axis] == plane;
      });
    const FieldSampler sampler(volume.View, kernel);
    // Wide kernels read thousands of taps per sample, so test fewer fractions.
    const std::size_t stride = this->Radius > 6 ? 37 : 1;
    const std::vector<double> fractions = Fractions();
    for (std::size_t f = 0; f < fractions.size(); f += stride)
    {
      const double middle = static_cast<double>(this->Size / 2) + fractions[f];
      const AxisKernel expected = NaiveGaussian(this->Radius, middle);
      const FieldSample sample = sampler.Gradient({ middle, middle, middle });
      const double slopes[3] = { sample.Gradient.X, sample.Gradient.Y, sample.Gradient.Z };
      worst = std::max(worst, std::abs(sample.Value - expected.Smooth[tap]));
      worst = std::max(worst, std::abs(slopes[axis] - expected.Slope[tap]));
      // Along the plane, the slope is zero.
      EXPECT_NEAR(slopes[(axis + 1) % 3], 0.0, 1e-13);
    }
  }
  EXPECT_LT(worst, 1e-10);
}

TEST_P(GradientKernelOf, EveryCoefficientSumsUpSoThatLinearFieldsAreExact)
{
  const GradientKernel kernel(GradientEstimator::Gaussian, this->Radius);
  constexpr int order = GradientKernel::Coefficients;
  const int count = 2 * this->Taps;
  ASSERT_EQ(kernel.Table.size(), std::size_t(GradientKernel::Intervals * order * count));
  for (int row = 0; row < GradientKernel::Intervals * order; ++row)
  {
    const double* const weights = &kernel.Table[static_cast<std::size_t>(row) * count];
    double smoothing = 0.0;
    double derivative = 0.0;
    double moment = 0.0;
    for (int i = 0; i < this->Taps; ++i)
    {
      smoothing += weights[i];
      derivative += weights[this->Taps + i];
      moment += weights[this->Taps + i] * (i - this->Radius);
    }
    // The weights are polynomials of the fraction. Their sums must not depend on the fraction, so
    // only the constant coefficients may add up to a value other than 0.
    const bool constant = row % order == 0;
    const double tolerance = constant ? 1e-13 : 1e-11;
    EXPECT_NEAR(smoothing, constant ? 1.0 : 0.0, tolerance);
    EXPECT_NEAR(derivative, 0.0, tolerance);
    EXPECT_NEAR(moment, constant ? 1.0 : 0.0, tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Radius, GradientKernelOf, testing::Range(1, GradientKernel::MaximumRadius + 1));

TEST(GradientKernel, RadiusIsLimited)
{
  EXPECT_EQ(GradientKernel(GradientEstimator::Gaussian, 0).Radius, 1);
  EXPECT_EQ(GradientKernel(GradientEstimator::Gaussian, 99).Radius, GradientKernel::MaximumRadius);
  EXPECT_TRUE(GradientKernel(GradientEstimator::CentralDifference, 3).Table.empty());
}

// Checks the table in Documentation/method.md: the standard deviation of the kernel's weights. It
// follows from their first two moments, the values sampled in the fields x and x^2.
TEST(GradientKernel, BlursAsTheMethodSays)
{
  struct Row
  {
    int Radius;
    double Paper;
    double Precise;
  };
  for (const Row& row : { Row{ 1, 0.53, 0.54 }, Row{ 2, 1.00, 0.97 }, Row{ 3, 1.42, 1.34 },
         Row{ 4, 1.84, 1.71 }, Row{ 6, 2.65, 2.43 }, Row{ 8, 3.45, 3.14 } })
  {
    const std::int64_t size = 4 * (row.Radius + 1) + 1;
    const auto middle = static_cast<double>(size / 2);
    TestVolume first(ScalarType::Float64, { size, size, size });
    TestVolume second(ScalarType::Float64, { size, size, size });
    const auto along = [&](std::int64_t i) { return static_cast<double>(i) - middle; };
    first.Fill<double>([&](std::int64_t i, std::int64_t, std::int64_t) { return along(i); });
    second.Fill<double>(
      [&](std::int64_t i, std::int64_t, std::int64_t) { return along(i) * along(i); });
    for (const bool isOwn : { false, true })
    {
      const GradientKernel kernel(GradientEstimator::Gaussian, row.Radius,
        isOwn ? GaussianWeights::OwnDerivative : GaussianWeights::FittedLine);
      const FieldSampler mean(first.View, kernel);
      const FieldSampler square(second.View, kernel);
      double variance = 0.0;
      constexpr int places = 100;
      for (int i = 0; i < places; ++i)
      {
        const Vector3 at{ middle + (i + 0.5) / places, middle, middle };
        const double m = mean.Gradient(at).Value;
        variance += (square.Gradient(at).Value - m * m) / places;
      }
      EXPECT_NEAR(std::sqrt(variance), isOwn ? row.Precise : row.Paper, 0.0055) << row.Radius;
    }
  }
}
