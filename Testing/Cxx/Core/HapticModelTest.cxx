// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Spaces and lengths of the model, which the offline filter shows for an upright device only.
 */

#include "CoreScene.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
/// A rotation about a slanted axis.
Matrix3 Slanted()
{
  const double c = 0.36;
  const double s = std::sqrt(1.0 - c * c);
  const Matrix3 aboutX{ { { 1, 0, 0 }, { 0, c, -s }, { 0, s, c } } };
  const Matrix3 aboutZ{ { { s, -c, 0 }, { c, s, 0 }, { 0, 0, 1 } } };
  return aboutZ * aboutX;
}

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

TEST(HapticModel, TurnedDeviceFeelsTheSameWorld)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Rich(volume);
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

TEST(HapticModel, LargerOnTheScreenIsNotStiffer)
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
    // The same motion of the hand, over half the way in the world.
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

TEST(HapticModel, KernelLengthIsOfTheLargestSpacing)
{
  const TestVolume volume = MakeRamp(8);
  HapticModelDescription description = Describe(volume);
  description.KernelRadius = 3;
  description.IndexToWorld.Linear =
    Slanted() * Matrix3{ { { 0.5, 0, 0 }, { 0, 2.5, 0 }, { 0, 0, 1.25 } } };
  const HapticModel model(description);
  EXPECT_NEAR(model.KernelLength, 0.0075, 1e-15);
  EXPECT_NEAR(Norm(model.FallbackNormal), 1.0, 1e-14);
}

TEST(HapticModel, SurfacesFadeOverOneKernelRadius)
{
  const TestVolume volume = MakeRamp(16);
  HapticModelDescription description = Describe(volume);
  description.KernelRadius = 3;
  const HapticModel model(description);
  for (const double x : { -4.0, 0.0, 0.75, 1.5, 2.9, 3.0, 7.5 })
  {
    const double expected = std::min(1.0, std::max(0.0, x / 3.0));
    for (const Vector3& at : { Vector3{ x, 7.0, 7.0 }, Vector3{ 15.0 - x, 7.0, 7.0 },
           Vector3{ 7.0, x, 7.5 }, Vector3{ 7.0, 15.0 - x, 7.0 }, Vector3{ 7.0, 7.0, 15.0 - x } })
    {
      EXPECT_DOUBLE_EQ(model.BorderFade(at), expected);
    }
  }
  EXPECT_DOUBLE_EQ(model.BorderFade({ 1.0, 14.0, 2.0 }), 1.0 / 3.0);
}
