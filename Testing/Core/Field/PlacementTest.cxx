// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests devices that are placed anywhere in the world, rotated and at any scale. (The offline
 * filter supports only an upright device.)
 */

#include "Rigs/CoreScene.h"
#include "Rigs/Slanted.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
HapticModelDescription Rich(const TestVolume& volume)
{
  HapticModelDescription description = Describe(volume);
  description.Material.Friction = ConstantPolyline(0.3);
  description.Material.Viscosity = ConstantPolyline(0.2);
  description.Material.Stiffness = { { 0.0, 200.0 }, { 2300.0, 800.0 } };
  description.Material.Distinctness = { { 0.0, 0.0 }, { 150.0, 1.0 } };
  return description;
}

void ExpectNear(const Vector3& a, const Vector3& b, double tolerance)
{
  EXPECT_LE(Norm(a - b), tolerance)
    << a.X << " " << a.Y << " " << a.Z << " / " << b.X << " " << b.Y << " " << b.Z;
}
} // namespace

TEST(Placement, TurnedDeviceFeelsTheSameWorld)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Rich(volume);
  description.Settings.Solver = HapticSolver::Paper;
  const HapticModel upright(description);
  description.DeviceToWorld = { 1000.0 * Slanted(), { 7.0, -30.0, 11.0 } };
  const HapticModel turned(description);
  ServoState states[2];
  TickRecord a;
  TickRecord b;
  Wanderer wanderer(24.0);
  double most = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const Vector3 world = upright.DeviceToWorld(wanderer.Next());
    Tick(upright, states[0], upright.WorldToDevice(world), a);
    Tick(turned, states[1], turned.WorldToDevice(world), b);
    ExpectNear(
      upright.DeviceToWorldRotation * a.Force, turned.DeviceToWorldRotation * b.Force, 1e-8);
    ExpectNear(upright.DeviceToWorld(a.Proxy), turned.DeviceToWorld(b.Proxy), 1e-8);
    EXPECT_NEAR(a.GradientMagnitude, b.GradientMagnitude, 1e-9);
    EXPECT_NEAR(a.SurfaceValue, b.SurfaceValue, 1e-6);
    most = std::max(most, Norm(a.Force));
  }
  EXPECT_GT(most, 0.5);
}

TEST(Placement, LargerOnTheScreenIsNotStiffer)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Rich(volume);
  const HapticModel life(description);
  description.DeviceToWorld.Linear = 500.0 * Matrix3{};
  const HapticModel twice(description);
  EXPECT_DOUBLE_EQ(twice.KernelLength, 2.0 * life.KernelLength);
  ServoState states[2];
  TickRecord a;
  TickRecord b;
  for (int i = 0; i <= 10; ++i)
  {
    // In the world of `twice`, lengths are doubled, so the hand moves half as far for the same
    // depth.
    const double depth = 1e-4 * i;
    Tick(life, states[0], { 0.012, 0.012, 0.012 + depth }, a);
    Tick(twice, states[1], { 0.024, 0.024, 0.024 + depth }, b);
  }
  EXPECT_GT(a.Stiffness, 400.0);
  EXPECT_NEAR(b.Stiffness, a.Stiffness, 1e-9);
  EXPECT_NEAR(b.GradientMagnitude, a.GradientMagnitude, 1e-9);
  EXPECT_NEAR(b.GradientMagnitude, 100.0, 1e-9);
  ExpectNear(a.Force, b.Force, 1e-9);
}

TEST(Placement, MovedModelIsTheModelBakedThere)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Rich(volume);
  auto origin = std::make_unique<const HapticModel>(description);
  description.DeviceToWorld = { 700.0 * Slanted(), { 7.0, -30.0, 11.0 } };
  const HapticModel baked(description);
  const HapticModel moved(*origin, description.DeviceToWorld, {});
  EXPECT_EQ(moved.KernelLength, baked.KernelLength);
  EXPECT_EQ(&moved.Baked->Materials, &origin->Baked->Materials) << "nothing is baked anew";
  origin.reset();
  ServoState states[2];
  TickRecord a;
  TickRecord b;
  Wanderer wanderer(24.0);
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 tip = baked.WorldToDevice(1000.0 * wanderer.Next());
    Tick(baked, states[0], tip, a);
    Tick(moved, states[1], tip, b);
    ASSERT_EQ(Norm(a.Force - b.Force), 0.0);
    ASSERT_EQ(Norm(a.Proxy - b.Proxy), 0.0);
  }
}

TEST(Placement, TheProxyStaysWhereItIsInTheWorld)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Rich(volume);
  const HapticModel before(description);
  const HapticModel after(before, { 500.0 * Slanted(), { 1.0, 2.0, 3.0 } }, {});
  ServoState state;
  state.Proxy = { 0.01, 0.012, 0.013 };
  state.Enabled = true;
  CarryState(before, after, state);
  ExpectNear(after.DeviceToWorld(state.Proxy), { 10.0, 12.0, 13.0 }, 1e-9);
  EXPECT_TRUE(state.Enabled);
}
