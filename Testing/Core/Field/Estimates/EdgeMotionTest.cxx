// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the estimate of an edge's motion. The edges are blurred by a Gaussian, so their widths are
 * known, and they move by known distances.
 */

#include "Core/Field/Estimates/EdgeMotion.h"
#include "Rigs/TestVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace coretest;

namespace
{
using EdgeDistance = std::function<double(double x, double y, double z)>;

/// Makes a blurred edge with white noise. The value is 1000 on the inner side (negative distance).
TestVolume MakeEdge(const EdgeDistance& distance, double sigma, ScalarType type = ScalarType::Int16,
  double noise = 0.0, unsigned seed = 1)
{
  TestVolume volume(type, { 48, 40, 40 });
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> random(0.0, 1.0);
  const auto value = [&](std::int64_t i, std::int64_t j, std::int64_t k)
  {
    const double d = distance(double(i), double(j), double(k));
    return 500.0 * std::erfc(d / (sigma * std::sqrt(2.0))) + noise * random(engine);
  };
  if (type == ScalarType::Int16)
  {
    volume.Fill<std::int16_t>([&](auto i, auto j, auto k) { return std::lround(value(i, j, k)); });
  }
  else
  {
    volume.Fill<double>(value);
  }
  return volume;
}

/// Returns the signed distance (voxels) to a ball in the middle of the volume.
EdgeDistance BallOf(double radius)
{
  return [radius](double x, double y, double z)
  {
    const double dx = x - 23.5;
    const double dy = y - 19.7;
    const double dz = z - 19.2;
    return std::sqrt(dx * dx + dy * dy + dz * dz) - radius;
  };
}

/// Returns the signed distance to an oblique wall that begins at a distance from the first sample.
EdgeDistance WallAt(double at)
{
  return [at](double x, double y, double z) { return 0.8 * x + 0.6 * y + 0.0 * z - at; };
}
} // namespace

TEST(EdgeMotion, FindsMotionsOfMoreThanTwoWidths)
{
  struct Case
  {
    double Sigma;
    double Widths;
  };
  const Case cases[] = { { 1.5, 1.0 }, { 1.5, 1.8 }, { 1.5, 3.0 }, { 1.5, 6.0 }, { 0.8, 1.0 },
    { 0.8, 3.0 }, { 0.8, 6.0 } };
  for (const Case& c : cases)
  {
    for (const bool isBall : { false, true })
    {
      const double s = c.Sigma * c.Widths;
      const TestVolume before = MakeEdge(isBall ? BallOf(8.0) : WallAt(26.0), c.Sigma);
      const TestVolume after = MakeEdge(isBall ? BallOf(8.0 + s) : WallAt(26.0 + s), c.Sigma);
      SCOPED_TRACE(testing::Message() << c.Sigma << ", " << c.Widths << ", ball " << isBall);
      const EdgeMotion found = MeasureEdgeMotion(before.View, after.View, Matrix3{}, 0.0, 0.0);
      EXPECT_GT(found.Edges, 20);
      EXPECT_EQ(found.IsFast(), c.Widths > 2.0);
      if (c.Widths > 2.0)
      {
        // The estimate uses the steepest slope between samples, so the edge looks slightly wider.
        EXPECT_NEAR(found.Width, c.Sigma, 0.15 * c.Sigma);
        EXPECT_NEAR(found.Motion, s, isBall ? 0.15 * s : 0.03 * s);
      }
    }
  }
}

TEST(EdgeMotion, IsInWorldUnitsAcrossTheEdge)
{
  // The grid is rotated and has spacings of 2, 0.5 and 1. Along the first axis, the wall moves by 7
  // voxels of 2 world units each.
  const Matrix3 map{ { { 0.0, -0.5, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  const auto at = [](double x) { return [x](double i, double, double) { return i - x; }; };
  const EdgeMotion found = MeasureEdgeMotion(MakeEdge(at(18.0), 1.5, ScalarType::Float64).View,
    MakeEdge(at(25.0), 1.5, ScalarType::Float64).View, map, 0.0, 0.0);
  EXPECT_NEAR(found.Motion, 14.0, 0.05);
  EXPECT_NEAR(found.Width, 3.0, 0.3);
}

TEST(EdgeMotion, KernelsMakeEdgesWider)
{
  const TestVolume before = MakeEdge(WallAt(26.0), 1.0);
  const TestVolume after = MakeEdge(WallAt(29.0), 1.0);
  EXPECT_TRUE(MeasureEdgeMotion(before.View, after.View, Matrix3{}, 0.0, 0.0).IsFast());
  EXPECT_FALSE(MeasureEdgeMotion(before.View, after.View, Matrix3{}, 1.5, 0.0).IsFast());
}

TEST(EdgeMotion, NoiseDoesNotMove)
{
  const auto nothing = [](double, double, double) { return 1e9; };
  for (const double noise : { 5.0, 40.0 })
  {
    const TestVolume still = MakeEdge(BallOf(9.0), 1.5, ScalarType::Int16, noise, 1);
    const TestVolume again = MakeEdge(BallOf(9.0), 1.5, ScalarType::Int16, noise, 2);
    EXPECT_FALSE(MeasureEdgeMotion(still.View, again.View, Matrix3{}, 0.0, noise).IsFast());
    const TestVolume empty = MakeEdge(nothing, 1.5, ScalarType::Int16, noise, 3);
    const TestVolume other = MakeEdge(nothing, 1.5, ScalarType::Int16, noise, 4);
    EXPECT_FALSE(MeasureEdgeMotion(empty.View, other.View, Matrix3{}, 0.0, noise).IsFast());
    const TestVolume moved = MakeEdge(BallOf(15.0), 1.5, ScalarType::Int16, noise, 5);
    EXPECT_TRUE(MeasureEdgeMotion(still.View, moved.View, Matrix3{}, 0.0, noise).IsFast());
  }
}

TEST(EdgeMotion, ManagesWithoutEdgesOrNumbers)
{
  TestVolume flat(ScalarType::UInt8, { 4, 1, 3 });
  TestVolume nan(ScalarType::Float64, { 12, 12, 12 });
  nan.Fill<double>([](auto...) { return std::nan(""); });
  EXPECT_EQ(MeasureEdgeMotion(flat.View, flat.View, Matrix3{}, 1.0, 0.0).Edges, 0);
  EXPECT_EQ(MeasureEdgeMotion(nan.View, nan.View, Matrix3{}, 1.0, 0.0).Edges, 0);
}
