// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Solver PAPER goes a shorter way where a volume is plain. The reference is the same volume with a
 * solid cut far beyond it, which takes the way of all others, and changes nothing.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <random>
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
  EXPECT_TRUE(HaveSameBits(plain.Proxy, reference.Proxy));
  EXPECT_TRUE(HaveSameBits(plain.Force, reference.Force));
  EXPECT_TRUE(HaveSameBits(plain.Normal, reference.Normal));
  for (const auto member :
    { &TickRecord::NormalForce, &TickRecord::FrictionForce, &TickRecord::DragForce })
  {
    EXPECT_TRUE(HaveSameBits(plain.*member, reference.*member));
  }
  for (const auto member : { &MaterialPoint::GradientMagnitude, &MaterialPoint::SurfaceValue,
         &MaterialPoint::MediumValue, &MaterialPoint::Stiffness, &MaterialPoint::Friction,
         &MaterialPoint::Viscosity, &MaterialPoint::SurfaceStrength })
  {
    EXPECT_TRUE(HaveSameBits(plain.*member, reference.*member));
  }
  EXPECT_EQ(plain.Contact, reference.Contact);
}

/// A soft ball in air without a gradient, with noise on the ball; and samples that are no numbers.
TestVolume MakeBallInAir()
{
  TestVolume volume(ScalarType::Float32, { 32, 32, 32 });
  std::mt19937 random(23);
  std::uniform_real_distribution<float> noise(0.0F, 20.0F);
  volume.Fill<float>(
    [&](std::int64_t x, std::int64_t y, std::int64_t z)
    {
      const auto square =
        static_cast<float>((x - 16) * (x - 16) + (y - 16) * (y - 16) + (z - 16) * (z - 16));
      const float value = 1000.0F - 10.0F * square;
      return x == 27 && y == 16 ? std::nanf("") : (value > 0.0F ? value + noise(random) : 0.0F);
    });
  return volume;
}

/// In mm: from outside of the volume, through it along curves, and out again.
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

} // namespace

class PlainVolume : public testing::TestWithParam<SurfaceSide>
{
};

TEST_P(PlainVolume, IsFeltAsWithACutThatLiesBeyondIt)
{
  const TestVolume volume = MakeBallInAir();
  HapticModelDescription description = Describe(volume);
  PlaceAsThePaper(description);
  description.Settings.Solver = HapticSolver::Paper;
  description.Settings.Side = this->GetParam();
  description.Material.Stiffness = { { 0.0, 50.0 }, { 200.0, 300.0 }, { 900.0, 600.0 } };
  description.Material.Friction = ConstantPolyline(0.3);
  description.Material.Viscosity = { { 300.0, 0.0 }, { 500.0, 0.1 } };
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
  for (const Vector3& tip : MakePath())
  {
    const HapticModel* const models[2] = { &plain, &reference };
    for (int i = 0; i < 2; ++i)
    {
      Tick(*models[i], states[i], PerMillimetre * tip, records[i], LocalSurfaceResult::Simulated(),
        &memories[i]);
    }
    ASSERT_NO_FATAL_FAILURE(ExpectSame(records[0], records[1]));
    ASSERT_FALSE(this->HasFailure());
    felt += Norm(records[0].Force) > 0.0 ? 1 : 0;
    still += records[0].GradientMagnitude == 0.0 ? 1 : 0;
  }
  // All ways were taken.
  EXPECT_GT(felt, 300);
  EXPECT_GT(still, 300);
}

INSTANTIATE_TEST_SUITE_P(
  All, PlainVolume, testing::Values(SurfaceSide::Both, SurfaceSide::Lower, SurfaceSide::Higher));
