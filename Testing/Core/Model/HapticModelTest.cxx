// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the lengths that a model computes from its volume.
 */

#include "Rigs/CoreScene.h"
#include "Rigs/Slanted.h"

#include <gtest/gtest.h>

using namespace coretest;

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

// Surfaces must not fade over a longer distance in thick slices than in thin ones: a radius of 3 is
// 3 x 0.5 mm here, which is 0.3 of a slice of 5 mm. The solver Paper fades over 3 voxels of each
// axis.
TEST(HapticModel, SurfacesFadeOverTheSmallestSpacing)
{
  const TestVolume volume = MakeRamp(16);
  HapticModelDescription description = Describe(volume);
  description.KernelRadius = 3;
  description.IndexToWorld.Linear = { { { 0.5, 0, 0 }, { 0, 1.0, 0 }, { 0, 0, 5.0 } } };
  const HapticModel model(description);
  EXPECT_DOUBLE_EQ(model.BorderFade({ 1.5, 7.0, 7.0 }), 0.5);
  EXPECT_DOUBLE_EQ(model.BorderFade({ 7.0, 14.25, 7.0 }), 0.5);
  EXPECT_DOUBLE_EQ(model.BorderFade({ 7.0, 7.0, 0.15 }), 0.5);
  EXPECT_DOUBLE_EQ(model.BorderFade({ 7.0, 7.0, 14.7 }), 1.0);
  description.Settings.Solver = HapticSolver::Paper;
  EXPECT_DOUBLE_EQ(HapticModel(description).BorderFade({ 7.0, 7.0, 1.5 }), 0.5);
}
