// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the lag between tip and proxy that a drag R causes with the solver Precise in a medium
 * without a surface. The lag is R/k (T6 in Documentation/evaluation.md), but at most R divided by
 * the coupling stiffness, or three voxels along the normal if that is longer
 * (Documentation/method.md). With the solver Paper, the lag is always R/k.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// A medium without a surface in a volume of 100 mm along each axis.
struct Medium
{
  double Stiffness = 500.0; // N/m
  double Drag = 0.5;        // N
  double Coupling = 500.0;  // N/m
  Vector3 Spacing{ 1.0, 1.0, 1.0 };
  Vector3 Slope{ 0.0, 0.0, 0.0 }; // gradient of V, per mm
  double Cap = 0.0;               // largest stiffness of the device (N/m); 0 for no limit
  HapticSolver Solver = HapticSolver::Precise;
};

/// Moves the tip 40 mm along the volume's diagonal. Returns the lag (m) at the end, and the force
/// (N) there.
std::pair<double, double> Drag(const Medium& medium)
{
  const auto samples = [](double spacing) { return std::int64_t(100.0 / spacing); };
  TestVolume volume(ScalarType::Float32,
    { samples(medium.Spacing.X), samples(medium.Spacing.Y), samples(medium.Spacing.Z) });
  volume.Fill<float>(
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      return Dot(medium.Slope,
        { medium.Spacing.X * double(i), medium.Spacing.Y * double(j),
          medium.Spacing.Z * double(k) });
    });
  HapticModelDescription d = Describe(volume);
  PlaceAsThePaper(d);
  d.IndexToWorld.Linear = { { { medium.Spacing.X, 0.0, 0.0 }, { 0.0, medium.Spacing.Y, 0.0 },
    { 0.0, 0.0, medium.Spacing.Z } } };
  d.Material.Stiffness = ConstantPolyline(medium.Stiffness);
  d.Material.Viscosity = ConstantPolyline(medium.Drag);
  d.Material.SurfaceStrength = ConstantPolyline(0.0);
  d.Settings.Solver = medium.Solver;
  d.Settings.CouplingStiffness = medium.Coupling;
  d.DeviceCaps.Stiffness = medium.Cap;
  const HapticModel model(d);
  ServoState state;
  TickRecord record;
  constexpr int ticks = 400;
  for (int i = 0; i <= ticks; ++i)
  {
    const double x = 0.03 + 0.04 / std::sqrt(3.0) * i / ticks;
    Tick(model, state, { x, x, x }, record);
  }
  return { Norm(record.Tip - record.Proxy), Norm(record.Force) };
}
} // namespace

TEST(DragLimit, LeavesTheClosedFormsAsTheyAre)
{
  for (const HapticSolver solver : { HapticSolver::Precise, HapticSolver::Paper })
  {
    Medium medium;
    medium.Solver = solver;
    for (const double k : { 200.0, 400.0, 500.0, 2000.0 }) // N/m; the limit is at least 3 mm
    {
      medium.Stiffness = k;
      const auto [lag, force] = Drag(medium);
      EXPECT_NEAR(lag, 0.5 / k, 1e-9) << k;
      EXPECT_NEAR(force, 0.5, 1e-6) << k;
    }
  }
}

TEST(DragLimit, HoldsNoFartherThanThreeVoxels)
{
  Medium medium;
  medium.Stiffness = 0.5;
  medium.Drag = 0.06;
  EXPECT_NEAR(Drag(medium).first, 3e-3, 1e-9);
  EXPECT_NEAR(Drag(medium).second, 0.5 * 3e-3, 1e-9);
  medium.Solver = HapticSolver::Paper;
  EXPECT_NEAR(Drag(medium).first, 0.04, 1e-9) << "R/k is 120 mm: the proxy stays where it was";
}

TEST(DragLimit, HoldsNoFartherThanTheCouplingStiffness)
{
  Medium medium;
  medium.Stiffness = 50.0;
  medium.Drag = 1.0;
  medium.Spacing = { 0.5, 0.5, 0.5 };
  EXPECT_NEAR(Drag(medium).first, 2e-3, 1e-9) << "1 N / 500 N/m, more than 1.5 mm";
  medium.Coupling = 200.0;
  EXPECT_NEAR(Drag(medium).first, 5e-3, 1e-9);
  medium.Coupling = 0.0;
  EXPECT_NEAR(Drag(medium).first, 1.5e-3, 1e-9) << "there is none";
  medium.Coupling = 500.0;
  medium.Cap = 100.0;
  EXPECT_NEAR(Drag(medium).first, 0.01, 1e-9) << "the device holds no more";
}

TEST(DragLimit, CountsVoxelsAlongTheNormal)
{
  Medium medium;
  medium.Stiffness = 0.5;
  medium.Drag = 0.06;
  medium.Spacing = { 1.0, 1.0, 4.0 };
  EXPECT_NEAR(Drag(medium).first, 3e-3, 1e-9) << "there is no normal: the smallest spacing";
  medium.Slope = { 50.0, 0.0, 0.0 };
  EXPECT_NEAR(Drag(medium).first, 3e-3, 1e-9);
  medium.Slope = { 0.0, 0.0, 50.0 };
  EXPECT_NEAR(Drag(medium).first, 12e-3, 1e-9);
  medium.Slope = { 30.0, 0.0, 40.0 };
  EXPECT_NEAR(Drag(medium).first, 3e-3 / std::hypot(0.6, 0.8 / 4.0), 1e-9);
}

TEST(DragLimit, HoldsInNoise)
{
  // The values are noise, so the proxy meets any stiffness and drag on their ramps, as with the
  // first transfer functions that a user tries.
  TestVolume volume(ScalarType::Float32, { 40, 40, 40 });
  std::mt19937_64 engine(5);
  std::normal_distribution<float> noise(0.0f, 60.0f);
  volume.Fill<float>([&](std::int64_t, std::int64_t, std::int64_t) { return noise(engine); });
  for (const MaterialPlacement placement :
    { MaterialPlacement::Kernel, MaterialPlacement::FarSide })
  {
    for (const double stiffness : { 1.0, 30.0, 400.0, 2000.0 })
    {
      HapticModelDescription d = Describe(volume);
      d.Settings.Placement = placement;
      d.Settings.ReleaseTime = 0.0; // another test has a release time
      d.Material.Stiffness = { { -20.0, 0.0 }, { 60.0, stiffness } };
      d.Material.Viscosity = { { -60.0, 0.0 }, { 20.0, 0.5 } };
      d.Material.SurfaceStrength = ConstantPolyline(0.0);
      const HapticModel model(d);
      ServoState state;
      TickRecord record;
      double longest = 0.0;
      for (int i = 0; i <= 3000; ++i)
      {
        const double x = 0.02 + 0.012 * std::sin(0.0031 * i);
        const double y = 0.02 + 0.012 * std::sin(0.0043 * i);
        const double z = 0.02 + 0.012 * std::sin(0.0057 * i);
        Tick(model, state, { x, y, z }, record);
        longest = std::max(longest, Norm(record.Tip - record.Proxy));
      }
      EXPECT_LT(longest, 3.1e-3) << stiffness;
    }
  }
}
