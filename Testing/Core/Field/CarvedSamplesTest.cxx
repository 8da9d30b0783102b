// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that reading a volume with removed tissue returns the same bits as reading a volume of
 * the remaining samples. Where nothing was removed, it must return the same bits as reading without
 * bricks.
 */

#include "Core/Field/FieldSampler.h"
#include "Rigs/CarvingRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
bool AreSame(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0 || (std::isnan(a) && std::isnan(b));
}

bool AreSame(const FieldSample& a, const FieldSample& b)
{
  return AreSame(a.Value, b.Value) && AreSame(a.Gradient.X, b.Gradient.X) &&
    AreSame(a.Gradient.Y, b.Gradient.Y) && AreSame(a.Gradient.Z, b.Gradient.Z);
}

bool AreSame(const ValuePair& a, const ValuePair& b)
{
  return AreSame(a.Ahead, b.Ahead) && AreSame(a.Behind, b.Behind);
}

class CarvedSamples : public testing::TestWithParam<GradientEstimator>
{
protected:
  /// Removes random fractions from random samples in a part of a volume.
  static void Remove(const TestVolume& volume, CarvedBricks& bricks, std::uint64_t samples)
  {
    std::mt19937_64 engine(17);
    const std::int64_t* const n = volume.View.Dimensions;
    const std::int64_t* const first = volume.View.First;
    for (std::uint64_t s = 0; s < samples; ++s)
    {
      const auto along = [&](int a)
      { return first[a] + static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(n[a])); };
      const std::int64_t i = along(0);
      const std::int64_t j = along(1);
      SetFraction(bricks, i, j, along(2), static_cast<std::uint8_t>(engine()));
    }
  }

  /// Compares samples of the carved volume with samples of a copy without the tissue, at random
  /// positions, including positions outside the volume and on samples.
  void Compare(const TestVolume& volume, const CarvedBricks& bricks, int radius)
  {
    const double air = -250.0;
    const GradientKernel kernel(this->GetParam(), radius);
    const TestVolume left = MakeLeft(volume, bricks, air);
    const FieldSampler expected(left.View, kernel);
    const FieldSampler plain(volume.View, kernel);
    const FieldSampler carved(volume.View, kernel, CarvedView{ &bricks, air });
    const FieldSampler baseline(
      volume.View, kernel, CarvedView{ &bricks, air }, InstructionSet::Baseline);
    TapMemory memory;
    std::mt19937_64 engine(23);
    const std::int64_t* const n = volume.View.Dimensions;
    int touched = 0;
    for (int s = 0; s < 300; ++s)
    {
      const auto along = [&](int a)
      {
        const double fraction = static_cast<double>(engine() >> 11) * 0x1p-53;
        const double x = static_cast<double>(volume.View.First[a]) +
          (1.2 * fraction - 0.1) * static_cast<double>(n[a] - 1);
        return engine() % 5 == 0 ? std::round(x) : x;
      };
      const Vector3 at{ along(0), along(1), along(2) };
      const Vector3 inside{ std::clamp(
                              at.X, double(volume.View.First[0]), double(volume.View.Last(0))),
        std::clamp(at.Y, double(volume.View.First[1]), double(volume.View.Last(1))),
        std::clamp(at.Z, double(volume.View.First[2]), double(volume.View.Last(2))) };
      const Vector3 offset{ 0.7, -0.3, 1.1 };
      ASSERT_TRUE(AreSame(carved.Value(at), expected.Value(at)));
      ASSERT_TRUE(AreSame(carved.Values(at, offset), expected.Values(at, offset)));
      ASSERT_TRUE(AreSame(carved.Gradient(inside), expected.Gradient(inside)));
      ASSERT_TRUE(AreSame(carved.Gradient(inside, &memory), expected.Gradient(inside)));
      ASSERT_TRUE(AreSame(baseline.Value(at), expected.Value(at)));
      ASSERT_TRUE(AreSame(baseline.Gradient(inside), expected.Gradient(inside)));
      const FieldSample whole = plain.Gradient(inside);
      touched += AreSame(carved.Gradient(inside), whole) ? 0 : 1;
    }
    EXPECT_GT(touched, 30);
  }
};
} // namespace

TEST_P(CarvedSamples, AreThoseThatAreLeft)
{
  for (const ScalarType type : AllScalarTypes)
  {
    for (const int radius : { 1, 2, 3, 4, 16 })
    {
      SCOPED_TRACE(testing::Message() << "type " << static_cast<int>(type) << " radius " << radius);
      TestVolume volume(type, { 20, 21, 19 }, radius == 2 ? 3 : 1);
      volume.FillRandom(static_cast<unsigned>(radius));
      CarvedBricks bricks(64);
      Remove(volume, bricks, 3000);
      this->Compare(volume, bricks, radius);
    }
  }
}

TEST_P(CarvedSamples, OfARegionAreThoseOfTheVolume)
{
  TestVolume volume(ScalarType::Int16, { 20, 21, 19 });
  volume.FillRandom(5);
  volume.View.First[0] = 40;
  volume.View.First[1] = 3;
  volume.View.First[2] = 1000;
  volume.View.Whole[0] = 2048;
  volume.View.Whole[1] = 2048;
  volume.View.Whole[2] = 2048;
  CarvedBricks bricks(128);
  Remove(volume, bricks, 3000);
  this->Compare(volume, bricks, 2);
}

/// Where nothing was removed, samples equal those of the plain volume. This also holds after a
/// removal elsewhere, and with a memory of a place that is carved later.
TEST_P(CarvedSamples, ArePlainWhereNothingWasRemoved)
{
  TestVolume volume(ScalarType::UInt16, { 40, 12, 12 });
  volume.FillRandom(6);
  for (const int radius : { 1, 2, 4 })
  {
    const GradientKernel kernel(this->GetParam(), radius);
    CarvedBricks bricks(16);
    const FieldSampler plain(volume.View, kernel);
    const FieldSampler carved(volume.View, kernel, CarvedView{ &bricks, 0.0 });
    TapMemory memory;
    const Vector3 far{ 33.2, 6.4, 5.7 };
    const Vector3 near{ 4.2, 6.4, 5.7 };
    ASSERT_TRUE(AreSame(carved.Gradient(near, &memory), plain.Gradient(near)));
    const auto set = [&bricks](std::uint8_t fraction)
    {
      for (std::int64_t at = 0; at < 8 * 12 * 12; ++at)
      {
        SetFraction(bricks, at % 8, at / 8 % 12, at / 96, fraction);
      }
    };
    set(40);
    EXPECT_FALSE(AreSame(carved.Gradient(near, &memory), plain.Gradient(near)));
    EXPECT_FALSE(AreSame(carved.Value(near), plain.Value(near)));
    ASSERT_TRUE(AreSame(carved.Gradient(far), plain.Gradient(far)));
    ASSERT_TRUE(AreSame(carved.Value(far), plain.Value(far)));
    set(255);
    ASSERT_TRUE(AreSame(carved.Gradient(near, &memory), plain.Gradient(near)));
  }
}

INSTANTIATE_TEST_SUITE_P(Estimators, CarvedSamples,
  testing::Values(GradientEstimator::CentralDifference, GradientEstimator::Gaussian,
    GradientEstimator::CubicBSpline));
