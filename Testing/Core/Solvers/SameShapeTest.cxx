// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Strokes over a flat slab of two materials, with a hand that presses with a constant force f. If
 * each material has its own stiffness, the tip rises or sinks by f (1/k1 - 1/k2) at the border,
 * which is the closed form for two springs, k1 and k2. With one stiffness for both, the tip must
 * continue straight on.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
constexpr double Soft = 150.0;       // N/m
constexpr double Stiff = 350.0;      // N/m
constexpr double Press = 1.0;        // N
constexpr double Surface = 8.0;      // z (mm) where the proxy begins to be held
constexpr double Begin = 10.0;       // x of the beginning (mm)
constexpr double End = 70.0;         // x of the end (mm)
constexpr double Border = 40.0;      // x of the border between the two materials (mm)
constexpr int Radius = 6;            // distance from the proxy to x_s (voxels)
constexpr double SoftValue = 1400.0; // value at x_s
constexpr double StiffValue = 2000.0;

/// Returns a volume with V = 100 z down to z = 11 mm. Deeper, V rises faster where the slab is
/// stiff: for x below Border if `beginsStiff`, otherwise for x above it. A kernel of two voxels at
/// z = 8 mm reads only the plain ramp.
TestVolume MakeSlab(bool beginsStiff)
{
  TestVolume volume(ScalarType::Float64, { 81, 17, 32 });
  volume.Fill<double>(
    [=](std::int64_t i, std::int64_t, std::int64_t k)
    {
      const double fraction = std::clamp((double(i) - Border) / 8.0 + 0.5, 0.0, 1.0);
      const double stiff = beginsStiff ? 1.0 - fraction : fraction;
      const double z = double(k);
      const double deep = std::max(0.0, z - 11.0);
      return 100.0 * z + stiff * deep * (StiffValue - SoftValue) / 3.0;
    });
  return volume;
}

HapticModelDescription DescribeSlab(const TestVolume& volume, HapticSolver solver)
{
  HapticModelDescription d = Describe(volume);
  PlaceAsThePaper(d);
  d.Estimator = GradientEstimator::CubicBSpline;
  d.KernelRadius = Radius;
  d.Settings.Solver = solver;
  d.Material.Stiffness = { { SoftValue + 50.0, Soft }, { StiffValue - 50.0, Stiff } };
  d.Material.SurfaceStrength = ConstantPolyline(1e6);
  return d;
}

/// Strokes with a massless hand that presses with 1 N. Returns how much deeper (mm) the tip is at
/// the end than at the beginning.
double ComputeStep(const HapticModel& model)
{
  ServoState state;
  TickRecord record;
  Vector3 tip = { 0.001 * Begin, 0.008, 0.001 * Surface };
  const auto tick = [&]()
  {
    Tick(model, state, tip, record);
    tip.Z += 1e-3 * (Press + record.Force.Z);
  };
  for (int i = 0; i < 400; ++i)
  {
    tick();
  }
  EXPECT_NEAR(record.Force.Z, -Press, 1e-6);
  EXPECT_NEAR(1000.0 * record.Proxy.Z, Surface, 1e-6) << "the slab is flat";
  const double before = record.Tip.Z;
  while (tip.X < 0.001 * End)
  {
    tip.X += 5e-5;
    tick();
  }
  for (int i = 0; i < 400; ++i)
  {
    tick();
  }
  EXPECT_NEAR(record.Force.Z, -Press, 1e-6);
  EXPECT_NEAR(1000.0 * record.Proxy.Z, Surface, 1e-6) << "the slab is flat";
  return 1000.0 * (record.Tip.Z - before);
}
} // namespace

TEST(SameShape, AChangeOfStiffnessIsFeltAsRelief)
{
  const double relief = 1000.0 * Press * (1.0 / Soft - 1.0 / Stiff);
  EXPECT_NEAR(relief, 3.81, 0.01);
  const TestVolume softens = MakeSlab(true);
  const TestVolume stiffens = MakeSlab(false);
  EXPECT_NEAR(ComputeStep(HapticModel(DescribeSlab(softens, HapticSolver::Paper))), relief, 0.001);
  EXPECT_NEAR(
    ComputeStep(HapticModel(DescribeSlab(softens, HapticSolver::Precise))), relief, 0.001);
  EXPECT_NEAR(
    ComputeStep(HapticModel(DescribeSlab(stiffens, HapticSolver::Paper))), -relief, 0.001);
}

TEST(SameShape, OneStiffnessIsFlat)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    for (const bool beginsStiff : { false, true })
    {
      const TestVolume volume = MakeSlab(beginsStiff);
      HapticModelDescription d = DescribeSlab(volume, solver);
      d.Settings.SameShape = true;
      d.Settings.CouplingStiffness = 300.0;
      EXPECT_LT(std::abs(ComputeStep(HapticModel(d))), 0.01);
    }
  }
}

TEST(SameShape, CapsHoldForTheCouplingStiffness)
{
  const TestVolume volume = MakeSlab(true);
  HapticModelDescription d = DescribeSlab(volume, HapticSolver::Precise);
  d.Settings.SameShape = true;
  d.Settings.CouplingStiffness = 3000.0;
  for (const double cap : { 0.0, 200.0 })
  {
    d.DeviceCaps.Stiffness = cap;
    const HapticModel model(d);
    ServoState state;
    TickRecord record;
    Tick(model, state, { 0.01, 0.008, 0.008 }, record);
    Tick(model, state, { 0.01, 0.008, 0.009 }, record);
    const double stiffness = cap > 0.0 ? cap : 3000.0;
    EXPECT_EQ(record.Stiffness, stiffness);
    EXPECT_NEAR(record.Force.Z, -0.001 * stiffness, 1e-9);
  }
}

TEST(SameShape, WhatHasNoStiffnessIsNotFelt)
{
  // Where the value at x_s is at most 1500, the stiffness is zero, while strength, friction and
  // drag are not.
  const TestVolume volume = MakeRamp();
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    HapticModelDescription d = Describe(volume);
    d.Settings.Solver = solver;
    d.Settings.SameShape = true;
    d.Material.Stiffness = { { 1500.0, 0.0 }, { 1500.0, 80.0 } };
    d.Material.Friction = ConstantPolyline(0.5);
    d.Material.Viscosity = ConstantPolyline(0.4);
    const HapticModel model(d);
    ServoState state;
    TickRecord record;
    Tick(model, state, { 0.012, 0.012, 0.005 }, record);
    int felt = 0;
    for (int i = 1; i <= 150; ++i)
    {
      Tick(model, state, { 0.012, 0.012, 0.005 + 1e-4 * i }, record);
      const bool isFelt = record.SurfaceValue > 1500.0;
      felt += isFelt;
      if (isFelt && Norm(record.Force) > 0.0)
      {
        EXPECT_NEAR(record.Stiffness, 500.0, 1e-9);
      }
      if (!isFelt)
      {
        EXPECT_EQ(record.Stiffness, 0.0) << record.SurfaceValue;
        EXPECT_EQ(Norm(record.Force), 0.0) << record.SurfaceValue;
      }
    }
    EXPECT_GT(felt, 40);
    EXPECT_GT(Norm(record.Force), 1.0);
  }
}

TEST(SameShape, LabelsHaveTheSameStiffness)
{
  LabelledMaterial soft;
  soft.Label = 1;
  soft.Material.Value[0] = 100.0;
  soft.Material.IsSet[0] = true;
  LabelledMaterial none = soft;
  none.Label = 2;
  none.Material.Value[0] = 0.0;
  LabelledMaterial slippery;
  slippery.Label = 3;
  slippery.Material.Value[1] = 0.05;
  slippery.Material.IsSet[1] = true;
  LabelTable table({ soft, none, slippery });
  table.SetOneStiffness(500.0, HapticModel::MinimumStiffness);
  EXPECT_EQ(table.Find(1)->Value[0], 500.0);
  EXPECT_EQ(table.Find(2)->Value[0], 0.0) << "not felt, as ever";
  EXPECT_FALSE(table.Find(3)->IsSet[0]);
  EXPECT_EQ(table.Find(3)->Value[1], 0.05);

  // A label image with one label, whose stiffness is 100 N/m.
  const TestVolume volume = MakeRamp();
  TestVolume labels(ScalarType::UInt8, { 24, 24, 24 });
  labels.Fill<std::uint8_t>([](std::int64_t, std::int64_t, std::int64_t) { return 1; });
  auto baked = std::make_shared<BakedLabels>();
  baked->View = LabelView(labels.View);
  baked->Table = LabelTable({ soft });
  HapticModelDescription d = Describe(volume);
  d.Labels = baked;
  for (const bool same : { false, true })
  {
    d.Settings.SameShape = same;
    const HapticModel model(d);
    ServoState state;
    TickRecord record;
    Tick(model, state, { 0.012, 0.012, 0.010 }, record);
    Tick(model, state, { 0.012, 0.012, 0.011 }, record);
    EXPECT_NEAR(record.Force.Z, same ? -0.5 : -0.1, 1e-9);
  }
  EXPECT_EQ(baked->Table.Find(1)->Value[0], 100.0) << "the labels may be used by other models";
}
