// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * S6: expects that the hand never gets more energy than it has put in, on a path from free space to
 * free space.
 */

#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// Returns a bumpy ball of 16-bit values with noise. The inside is solid.
TestVolume MakeBumpyBall(double noise)
{
  TestVolume volume(ScalarType::Int16, { 64, 64, 64 });
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  volume.Fill<std::int16_t>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const Vector3 at{ i - 31.5, j - 31.5, k - 31.5 };
      const double surface = 18.0 + 1.5 * std::sin(0.4 * at.X) * std::cos(0.5 * at.Y);
      return static_cast<std::int16_t>(
        1000.0 * (1.0 + std::tanh(0.5 * (surface - Norm(at)))) + uniform(engine));
    });
  return volume;
}

/// Returns a material whose stiffness and strength change with the value.
HapticMaterial MakeUneven()
{
  HapticMaterial material;
  material.Stiffness = { { 900.0, 100.0 }, { 1700.0, 600.0 }, { 1950.0, 150.0 },
    { 2000.0, 900.0 } };
  material.SurfaceStrength = { { 1000.0, 0.1 }, { 1900.0, 2.0 }, { 2000.0, 0.3 } };
  material.Distinctness = { { 20.0, 0.0 }, { 300.0, 1.0 } };
  return material;
}

/// Returns the hand's pose at time t from 0 to 1 on a smooth random path that begins and ends
/// outside the ball.
ShellPose ComputePose(double t, const Vector3* waves)
{
  const double press = std::sin(Pi * t); // 0 at both ends
  const Vector3 away{ 1.0, 0.3 * std::sin(2.0 * Pi * t), 0.2 };
  const Vector3 way = (26.0 - 7.0 * press) * away + (6.0 * std::sin(4.0 * Pi * t)) * waves[0] +
    (4.0 * std::sin(6.0 * Pi * t)) * waves[1];
  return { 0.001 * (Vector3{ 31.5, 31.5, 31.5 } + way),
    TurnAbout(waves[2], 2.0 * std::sin(Pi * t)) };
}
} // namespace

class ShellPassivity : public testing::TestWithParam<double>
{
};

TEST_P(ShellPassivity, NoCycleCreatesEnergy)
{
  const double noise = this->GetParam();
  const TestVolume volume = MakeBumpyBall(noise);
  HapticModelDescription scene = Describe(volume);
  scene.Material = MakeUneven();
  ShellSettings settings;
  settings.Level = 1000.0;
  std::mt19937_64 engine(21);
  int touched = 0;
  for (int cycle = 0; cycle < 30; ++cycle)
  {
    std::vector<ShellPoint> points = MakeSphere(3.0, 300);
    for (ShellPoint& point : points)
    {
      point.Position.X *= 2.0;
    }
    ShellHand hand(scene, points, settings);
    const Vector3 waves[3] = { RandomIn(engine, 1.0), RandomIn(engine, 1.0),
      RandomIn(engine, 1.0) };
    const int ticks = cycle % 3 == 0 ? 200 : 2000; // 1 ms each: fast (up to 0.5 m/s) and slow
    double most = 0.0;
    double least = 0.0;
    for (int i = 0; i <= ticks; ++i)
    {
      hand.TickAt(ComputePose(static_cast<double>(i) / ticks, waves));
      const double stored = hand.EnergyOfSprings(hand.Record.Tool, hand.Record.Hand);
      most = std::max(most, stored);
      least = std::min(least, hand.Work - stored);
    }
    touched += most > 1e-5 ? 1 : 0;
    hand.Rest();
    // At the end of a cycle, no contact and no stored energy may remain.
    EXPECT_EQ(hand.Record.Contacts, 0u);
    EXPECT_GE(hand.Work, -1e-15) << "J, cycle " << cycle;
    EXPECT_GE(least, -1e-15) << "J: the springs hold more than the hand has put in";
  }
  EXPECT_GE(touched, 25);
}

INSTANTIATE_TEST_SUITE_P(Noise, ShellPassivity, testing::Values(0.0, 60.0));

/// The tool moves slowly around a smooth ball and stays in contact. A cycle must neither gain nor
/// lose energy.
TEST(ShellPassivitySlow, ACycleInContactIsDriftFree)
{
  TestVolume volume(ScalarType::Float64, { 64, 64, 64 });
  volume.Fill<double>(
    [](std::int64_t i, std::int64_t j, std::int64_t k) {
      return 100.0 * (20.0 - Norm(Vector3{ i - 31.5, j - 31.5, k - 31.5 }));
    });
  HapticModelDescription scene = Describe(volume);
  ShellSettings settings;
  ShellHand hand(scene, MakeSphere(4.0, 2000), settings);
  const auto at = [](double angle)
  {
    const double r = 22.5 + 0.5 * std::sin(3.0 * angle);
    return Vector3{ 31.5 + r * std::cos(angle), 31.5 + r * std::sin(angle), 31.5 };
  };
  hand.Tick(Vector3{ 31.5 + 25.0, 31.5, 31.5 });
  hand.Lead(at(0.0), 0.02);
  const ShellRecord first = hand.Rest(200);
  const double stored = hand.EnergyOfSprings(first.Tool, first.Hand) + first.Energy;
  const double before = hand.ForceWork;
  constexpr int ticks = 4000; // 36 mm/s
  for (int turn = 0; turn < 3; ++turn)
  {
    for (int i = 1; i <= ticks; ++i)
    {
      hand.Tick(at(2.0 * Pi * i / ticks));
    }
  }
  const ShellRecord last = hand.Rest(200);
  EXPECT_LE(Norm(last.Force - first.Force), 1e-4 * Norm(first.Force));
  EXPECT_LE(Norm(last.Tool.Position - first.Tool.Position), 1e-7);
  const double lost = hand.ForceWork - before;
  EXPECT_GE(lost, -0.01 * stored);
  const double way = 3.0 * 2.0 * Pi * 22.5e-3;
  EXPECT_LE(lost, 0.003 * Norm(first.Force) * way) << "what a friction of 0.003 would take";
}

/// When the tool slides from soft to hard tissue at the same depth, no energy may be created. The
/// stiffness of the hard tissue is felt only if the hand presses on.
TEST(ShellPassivitySlow, AStifferPlaceIsFeltByPressingOn)
{
  // A ramp that is twice as steep for x > 16. At the level, its surface has no step.
  TestVolume volume(ScalarType::Float64, { 32, 24, 24 });
  volume.Fill<double>([](std::int64_t i, std::int64_t, std::int64_t k)
    { return (i > 16 ? 200.0 : 100.0) * (k - 10); });
  HapticModelDescription scene = Describe(volume);
  scene.KernelRadius = 2;
  scene.Material.Stiffness = { { 250.0, 100.0 }, { 350.0, 400.0 } };
  scene.Material.SurfaceStrength = ConstantPolyline(50.0);
  ShellSettings settings;
  settings.CouplingStiffness = 2000.0;
  const auto press = [&](ShellHand& hand, double x, double z)
  {
    hand.Lead({ x, 12.0, z }, 0.02);
    return -hand.Rest(100).Force.Z;
  };
  ShellHand hand(scene, MakeSquare(3.0, 20), settings);
  hand.Tick(Vector3{ 8.0, 12.0, 9.5 });
  const double soft = press(hand, 8.0, 10.8);
  const double energy = hand.Record.Energy;
  const double slid = press(hand, 24.0, 10.8);
  EXPECT_LE(hand.Record.Energy, 1.05 * energy);
  EXPECT_GT(slid, soft) << "the same energy in a stiffer spring";
  const double pressed = press(hand, 24.0, 10.9);
  // In N/m: the tissue's 4e6 N/m^3 times 9 mm^2 is 36, and 144 in the hard part. The hand's spring
  // of 2000 N/m is in series.
  const double stiff = 144.0 * 2000.0 / 2144.0;
  EXPECT_NEAR((pressed - slid) / 1e-4, stiff, 0.05 * stiff);
}
