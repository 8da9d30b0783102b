// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the synthetic scans and the strokes over them, for the presets "Micro-CT" and "Labels". The
 * expected forces follow from the triangle of tip, proxy and middle, which the test solves by its
 * own bisection, and from the flat case.
 */

#include "Parts.h"
#include "Feel.h"
#include "Shapes.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
/** Returns the side L of the triangle whose tip is on its circle; by bisection. */
double SolveTriangle(double radius, double depth, double friction)
{
  const double angle = std::atan(friction);
  double low = 0.0;
  double high = radius * std::cos(angle);
  for (int i = 0; i < 60; ++i)
  {
    const double length = 0.5 * (low + high);
    const double tip = std::hypot(radius - length * std::cos(angle), length * std::sin(angle));
    (tip > radius - depth ? low : high) = length;
  }
  return low;
}

TEST(Parts, ForceOfSlidingIsThatOfTheTriangle)
{
  for (const double friction : { 0.0, 0.1, 0.3, 0.6 })
  {
    for (const double depth : { 0.5, 2.0, 4.0 })
    {
      EXPECT_NEAR(SlidingForce(40.0, depth, 400.0, friction),
        0.4 * SolveTriangle(40.0, depth, friction), 1e-9);
    }
    EXPECT_NEAR(SlidingForce(1e6, 2.0, 400.0, friction), 0.8 * std::hypot(1.0, friction), 1e-4)
      << "on a plane";
  }
}

TEST(Parts, MetalIsHalfwayAtTheSurfaceAndDarkerInTheMiddle)
{
  const Vector3 out = OddNormal;
  EXPECT_NEAR(MetalValue(OddCentre + PartRadius * out), 4000.0 + 12000.0, 1e-6);
  EXPECT_NEAR(MetalValue(OddCentre + (PartRadius + 10.0) * out), 4000.0, 1e-6);
  EXPECT_NEAR(MetalValue(OddCentre), 4000.0 + 0.88 * 24000.0, 1e-6);
}

TEST(Parts, ForcesAndSurfacesAreThoseOfTheFormulas)
{
  const std::vector<FeltSurface> parts = MakePartSurfaces({});
  ASSERT_EQ(parts.size(), 2u);
  for (const FeltSurface& part : parts)
  {
    const PartFeel felt = FeelPart(part);
    EXPECT_GT(felt.Ticks, 3000u) << part.Scan;
    EXPECT_LT(felt.Distance, 0.2) << part.Scan;
    // The tolerance is the force of 0.15 voxel at 400 N/m: a kernel of 1.4 voxels moves the wall of
    // a ball inwards by 1.4^2/40 = 0.05 voxel, and the steps of a label image add more.
    EXPECT_NEAR(felt.Force, felt.Expected, 0.06) << part.Scan;
  }
}
} // namespace
