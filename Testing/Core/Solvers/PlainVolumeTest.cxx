// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the solvers' shorter code path for plain volumes, at rest and moving. The reference is the
 * same volume with a solid cut far outside it. The cut only selects the general code path.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <utility>
#include <vector>

using namespace coretest;

namespace
{
constexpr double PerMillimetre = 1e-3;

bool HaveSameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

bool HaveSameBits(const Vector3& a, const Vector3& b)
{
  return HaveSameBits(a.X, b.X) && HaveSameBits(a.Y, b.Y) && HaveSameBits(a.Z, b.Z);
}

void ExpectSame(const TickRecord& plain, const TickRecord& reference)
{
  ASSERT_TRUE(HaveSameBits(plain.Proxy, reference.Proxy));
  ASSERT_TRUE(HaveSameBits(plain.Force, reference.Force));
  ASSERT_TRUE(HaveSameBits(plain.Normal, reference.Normal));
  for (const auto member : { &TickRecord::NormalForce, &TickRecord::FrictionForce,
         &TickRecord::DragForce, &TickRecord::WallWork })
  {
    ASSERT_TRUE(HaveSameBits(plain.*member, reference.*member));
  }
  for (const auto member : { &MaterialPoint::GradientMagnitude, &MaterialPoint::SurfaceValue,
         &MaterialPoint::MediumValue, &MaterialPoint::Stiffness, &MaterialPoint::Friction,
         &MaterialPoint::Viscosity, &MaterialPoint::SurfaceStrength })
  {
    ASSERT_TRUE(HaveSameBits(plain.*member, reference.*member));
  }
  ASSERT_EQ(plain.Contact, reference.Contact);
}

/// Returns a soft ball with noise, in air without a gradient. One row of samples is NaN.
/// @param grown added to the values of the ball
TestVolume MakeBallInAir(float grown = 0.0F)
{
  TestVolume volume(ScalarType::Float32, { 32, 32, 32 });
  std::mt19937 random(23);
  std::uniform_real_distribution<float> noise(0.0F, 20.0F);
  volume.Fill<float>(
    [&](std::int64_t x, std::int64_t y, std::int64_t z)
    {
      const auto square =
        static_cast<float>((x - 16) * (x - 16) + (y - 16) * (y - 16) + (z - 16) * (z - 16));
      const float value = 1000.0F + grown - 10.0F * square;
      return x == 27 && y == 16 ? std::nanf("") : (value > 0.0F ? value + noise(random) : 0.0F);
    });
  return volume;
}

/// Returns a path (mm) that begins outside the volume, passes through it in curves, and ends
/// outside.
std::vector<Vector3> MakePath()
{
  std::vector<Vector3> path;
  for (int i = 0; i < 6000; ++i)
  {
    const double t = 1e-3 * i;
    const double radius = 12.0 * std::abs(std::sin(1.7 * t)) - 1.0;
    path.push_back(
      { 16.0 + radius * std::cos(5.0 * t), 16.0 + radius * std::sin(7.0 * t), -2.0 + 6.0 * t });
  }
  return path;
}

struct PlainCase
{
  HapticSolver Solver;
  SurfaceSide Side;
  bool IsPlacedAsThePaper;
};

} // namespace

class PlainVolume : public testing::TestWithParam<PlainCase>
{
};

namespace
{
HapticModelDescription DescribePlain(const TestVolume& volume, const PlainCase& plain)
{
  HapticModelDescription description = Describe(volume);
  if (plain.IsPlacedAsThePaper)
  {
    PlaceAsThePaper(description);
  }
  description.Settings.Solver = plain.Solver;
  description.Settings.Side = plain.Side;
  description.Material.Stiffness = { { 0.0, 50.0 }, { 200.0, 300.0 }, { 900.0, 600.0 } };
  description.Material.Friction = ConstantPolyline(0.3);
  description.Material.Viscosity = { { 300.0, 0.0 }, { 500.0, 0.1 } };
  return description;
}

/// Returns the data time at a tick.
using Clock = double (*)(int tick);

/// Runs each tick twice: with the code path of plain volumes, and with the general code path, which
/// a cut far outside the volume selects. Expects equal records.
void ExpectSameAsWithACutBeyond(HapticModelDescription description, Clock clock)
{
  const HapticModel plain(description);
  description.Cut = std::make_shared<CutAway>(std::vector<CutPlane>{ { { 1.0, 0.0, 0.0 }, -1e6 } },
    CutRegions{}, description.IndexToWorld, true);
  const HapticModel reference(description);
  ASSERT_TRUE(plain.Baked->IsPlain());
  ASSERT_FALSE(reference.Baked->IsPlain());

  ServoState states[2];
  TickMemory memories[2];
  TickRecord records[2];
  int felt = 0;
  int still = 0;
  int pushed = 0;
  int tick = 0;
  for (const Vector3& tip : MakePath())
  {
    const HapticModel* const models[2] = { &plain, &reference };
    for (int i = 0; i < 2; ++i)
    {
      states[i].DataTime = clock(tick);
      Tick(*models[i], states[i], PerMillimetre * tip, records[i], LocalSurfaceResult::Simulated(),
        &memories[i]);
    }
    ASSERT_NO_FATAL_FAILURE(ExpectSame(records[0], records[1])) << "tick " << tick;
    felt += Norm(records[0].Force) > 0.0 ? 1 : 0;
    still += records[0].GradientMagnitude == 0.0 ? 1 : 0;
    pushed += records[0].WallWork != 0.0 ? 1 : 0;
    ++tick;
  }
  // The path must contain all kinds of ticks.
  EXPECT_GT(felt, 300);
  EXPECT_GT(still, 300);
  EXPECT_EQ(pushed > 100, plain.Baked->IsMoving());
}
} // namespace

TEST_P(PlainVolume, IsFeltAsWithACutThatLiesBeyondIt)
{
  const TestVolume volume = MakeBallInAir();
  ExpectSameAsWithACutBeyond(DescribePlain(volume, this->GetParam()), [](int) { return 0.0; });
}

class PlainVolumeOfPaper : public testing::TestWithParam<SurfaceSide>
{
};

/// The data time advances slowly, rests, runs through the whole series and back, and jumps so that
/// the surface moves by more than a voxel.
TEST_P(PlainVolumeOfPaper, ThatMovesIsFeltSo)
{
  const TestVolume volumes[3] = { MakeBallInAir(), MakeBallInAir(40.0F), MakeBallInAir(-150.0F) };
  for (const auto& [estimator, radius] :
    { std::pair{ GradientEstimator::Gaussian, 1 }, std::pair{ GradientEstimator::Gaussian, 2 },
      std::pair{ GradientEstimator::Gaussian, 3 }, std::pair{ GradientEstimator::CubicBSpline, 2 },
      std::pair{ GradientEstimator::CentralDifference, 2 } })
  {
    SCOPED_TRACE(
      testing::Message() << "estimator " << static_cast<int>(estimator) << " radius " << radius);
    HapticModelDescription description =
      DescribePlain(volumes[0], { HapticSolver::Paper, this->GetParam(), true });
    description.Estimator = estimator;
    description.KernelRadius = radius;
    for (const TestVolume& volume : volumes)
    {
      description.TimeSteps.push_back(
        { static_cast<double>(description.TimeSteps.size()), volume.View, nullptr });
    }
    ExpectSameAsWithACutBeyond(description,
      [](int tick)
      {
        const double slow = 1.0 - std::cos(0.004 * tick);
        return tick % 100 < 10 ? std::floor(slow) : (tick % 37 == 0 ? 0.9 * slow : slow);
      });
  }
}

namespace
{
std::vector<PlainCase> AllPlainCases()
{
  std::vector<PlainCase> all;
  for (const SurfaceSide side : { SurfaceSide::Both, SurfaceSide::Lower, SurfaceSide::Higher })
  {
    all.push_back({ HapticSolver::Paper, side, true });
    all.push_back({ HapticSolver::Precise, side, true });
    all.push_back({ HapticSolver::Precise, side, false });
  }
  return all;
}
} // namespace

INSTANTIATE_TEST_SUITE_P(All, PlainVolume, testing::ValuesIn(AllPlainCases()));
INSTANTIATE_TEST_SUITE_P(All, PlainVolumeOfPaper,
  testing::Values(SurfaceSide::Both, SurfaceSide::Lower, SurfaceSide::Higher));
