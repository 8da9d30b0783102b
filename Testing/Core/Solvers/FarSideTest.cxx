// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the walk to the plateaus on both sides of an edge. The expected values are those from which
 * the edges are made: V1 + (V2 - V1) Phi(z/s), where Phi is the normal distribution. Ramps are
 * linear functions of the position, or distances from a point.
 */

#include "Core/Solvers/Precise/FarSide.h"
#include "Rigs/TestVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace coretest;

namespace
{
constexpr double Middle = 31.3; // position of the edges (voxels)
constexpr double Radius = 2.0;  // voxels
constexpr double Tolerance = 0.01;

double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/// A volume that changes only along z: value(d) at the distance d (voxels) from the middle.
class Layers
{
public:
  explicit Layers(const std::function<double(double)>& value)
    : Volume(ScalarType::Float64, { 8, 8, 64 })
    , Kernel(GradientEstimator::Gaussian, static_cast<int>(Radius))
  {
    this->Volume.Fill<double>([&](std::int64_t, std::int64_t, std::int64_t k)
      { return value(static_cast<double>(k) - Middle); });
    this->Field = FieldSampler(this->Volume.View, this->Kernel);
  }

  FarValues Find(double distance, bool isDescending = false) const
  {
    const Vector3 reach = { 0.0, 0.0, isDescending ? -Radius : Radius };
    return MeasureFarSide(
      FieldAtTime(this->Field), { 3.2, 3.7, Middle + distance }, reach, Radius, 0.0, isDescending);
  }

  double Value(double distance) const { return this->Field.Value({ 3.2, 3.7, Middle + distance }); }

  TestVolume Volume;
  GradientKernel Kernel;
  FieldSampler Field;
};
} // namespace

TEST(FarSide, IsThePlateausOfABlurredEdge)
{
  for (const double blur : { 0.5, 0.75, 1.0, 1.5, 2.0 })
  {
    const Layers edge([&](double z) { return -1000.0 + 1060.0 * Phi(z / blur); });
    for (double at = -0.5; at <= 0.5; at += 0.1)
    {
      const FarValues far = edge.Find(at);
      EXPECT_NEAR(far.Ahead, 60.0, 1060.0 * Tolerance) << blur << " from " << at;
      EXPECT_NEAR(far.Behind, -1000.0, 1060.0 * Tolerance) << blur << " from " << at;
      EXPECT_LT(far.Evenness, FarSide::EdgeEvenness) << blur << " from " << at;
      // From the other side, the same edge must have its values ahead and behind exchanged.
      const FarValues lower = edge.Find(at, true);
      EXPECT_EQ(lower.Ahead, far.Behind);
      EXPECT_EQ(lower.Behind, far.Ahead);
    }
  }
}

TEST(FarSide, IsTheFirstPlateauNotTheSkullThroughTheScalp)
{
  for (const double blur : { 0.5, 0.7, 0.85 })
  {
    const double thickness = 4.0;
    const Layers head([&](double z)
      { return -1000.0 + 1050.0 * Phi(z / blur) + 1000.0 * Phi((z - thickness) / blur); });
    for (double at = -0.3; at <= 0.3; at += 0.1)
    {
      ASSERT_GT(head.Value(at + FarSide::FarthestRadii * Radius), 900.0) << "the skull is in reach";
      EXPECT_NEAR(head.Find(at).Ahead, 50.0, 80.0) << blur << " from " << at;
      EXPECT_NEAR(head.Find(at).Behind, -1000.0, 1050.0 * 0.04);
      // At the skull, the medium in front is the scalp.
      EXPECT_NEAR(head.Find(thickness + at).Behind, 50.0, 80.0) << blur << " from " << at;
      EXPECT_NEAR(head.Find(thickness + at).Ahead, 1050.0, 1000.0 * Tolerance);
    }
  }
}

// The skin is thinner than the kernel is wide, and the skull behind it is a steeper edge. The walk
// must find the skin's edge, on its own side of the dip between the two edges, and must not combine
// both to one edge.
TEST(FarSide, IsThatOfAThinLayerWhoseNextEdgeIsSteeper)
{
  for (const double blur : { 0.5, 0.6 })
  {
    for (const double thickness : { 2.6, 3.0 })
    {
      SCOPED_TRACE(testing::Message() << blur << ", " << thickness);
      const Layers head([&](double z)
        { return -1000.0 + 1000.0 * Phi(z / blur) + 1500.0 * Phi((z - thickness) / blur); });
      for (double at = -1.0; at <= 0.5 * thickness - 0.5; at += 0.1)
      {
        EXPECT_NEAR(head.Find(at).Ahead, 0.0, 300.0) << "from " << at;
        EXPECT_NEAR(head.Find(at).Behind, -1000.0, 40.0) << "from " << at;
        EXPECT_LT(head.Find(at).Evenness, FarSide::EdgeEvenness) << "from " << at;
      }
      EXPECT_NEAR(head.Find(thickness).Behind, 0.0, 300.0);
      EXPECT_NEAR(head.Find(thickness).Ahead, 1500.0, 1500.0 * Tolerance);
    }
  }
}

TEST(FarSide, IsThreeRadiiAwayOnAnEvenRamp)
{
  const Layers ramp([](double z) { return 100.0 * z; });
  const FarValues far = ramp.Find(0.4);
  EXPECT_NEAR(far.Ahead, 100.0 * (0.4 + 3.0 * Radius), 1e-9);
  EXPECT_NEAR(far.Behind, 100.0 * (0.4 - 3.0 * Radius), 1e-9);
  EXPECT_NEAR(far.Evenness, 1.0, 1e-12);
}

// The volume is the distance from a point, which rises evenly along each ray. Interpolation between
// voxels bends this ramp, so that the rises of the walk's steps differ by up to an eighth. Noise
// adds to this.
TEST(FarSide, IsThatOfTheKernelOnADistanceFieldOfCoarseVoxels)
{
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  const GradientKernel kernel(GradientEstimator::Gaussian, static_cast<int>(Radius));
  constexpr double slope = 100.0; // per voxel
  for (int i = 0; i < 2000; ++i)
  {
    const double distance = 8.0 + 32.0 * std::abs(uniform(engine));
    const double noise = i % 2 == 0 ? 0.0 : 0.05 * slope * Radius / FarSide::StepsPerRadius;
    Vector3 outward = { normal(engine), normal(engine), normal(engine) };
    outward = (1.0 / Norm(outward)) * outward;
    const Vector3 at = { 7.5 + uniform(engine), 7.5 + uniform(engine), 7.5 + uniform(engine) };
    const Vector3 center = at - distance * outward;
    TestVolume volume(ScalarType::Float64, { 16, 16, 16 });
    volume.Fill<double>(
      [&](std::int64_t x, std::int64_t y, std::int64_t z)
      {
        const Vector3 sample = { double(x), double(y), double(z) };
        return slope * Norm(sample - center) + noise * normal(engine);
      });
    const FieldSampler field(volume.View, kernel);
    const bool isBall = i % 4 < 2;
    const Vector3 reach = (isBall ? -Radius : Radius) * outward;
    const FarValues far =
      MeasureFarSide(FieldAtTime(field), at, reach, Radius, slope * Radius, isBall);
    ASSERT_GT(far.Evenness, 0.7) << distance << " voxels from the point, noise " << noise;
  }
}

// Beyond the border, there are no values. A ramp that is even up to the border counts as even.
TEST(FarSide, StopsAtTheBorder)
{
  const Layers ramp([](double z) { return 100.0 * z; });
  const double last = 63.0 - Middle;
  // The walk makes steps of half a voxel. Only two steps fit between the position and the border.
  const FarValues far = ramp.Find(last - 1.2);
  EXPECT_NEAR(far.Ahead, 100.0 * (last - 0.2), 1e-9);
  EXPECT_NEAR(far.Behind, 100.0 * (last - 1.2 - 3.0 * Radius), 1e-9);
  EXPECT_NEAR(far.Evenness, 1.0, 1e-12);
  EXPECT_NEAR(ramp.Find(1.2 - Middle).Behind, 100.0 * (0.2 - Middle), 1e-9);
  // An edge next to the border ends at the value of the border.
  const Layers edge([&](double z) { return 1000.0 * Phi(z - last + 1.0); });
  EXPECT_NEAR(edge.Find(last - 1.0).Behind, 0.0, 1000.0 * Tolerance);
  EXPECT_NEAR(edge.Find(last - 1.0).Ahead, edge.Value(last), 1e-9);
}

TEST(FarSide, IsFiniteWhateverTheSamplesAre)
{
  const double odd[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), 1.7e308, -1.7e308, 1e-310, 0.0 };
  std::mt19937_64 engine(5);
  TestVolume volume(ScalarType::Float64, { 8, 8, 64 });
  volume.Fill<double>(
    [&](std::int64_t, std::int64_t, std::int64_t k)
    {
      const auto dice = engine() % 12;
      return dice < 6 ? odd[dice] : static_cast<double>(k);
    });
  const GradientKernel kernel(GradientEstimator::Gaussian, 2);
  const FieldSampler field(volume.View, kernel);
  for (int i = 0; i < 20000; ++i)
  {
    const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
    const Vector3 index = { 9.0 * uniform() - 1.0, 9.0 * uniform() - 1.0, 66.0 * uniform() - 1.0 };
    const Vector3 reach = { uniform() - 0.5, uniform() - 0.5, uniform() - 0.5 };
    const FarValues far = MeasureFarSide(FieldAtTime(field), index, reach, Radius, 0.0, i % 2 == 0);
    ASSERT_TRUE(std::isfinite(far.Ahead) && std::isfinite(far.Behind));
    ASSERT_GE(far.Evenness, 0.0);
    ASSERT_LE(far.Evenness, 1.0 + 1e-12);
  }
}
