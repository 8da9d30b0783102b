// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Checks the true surface of the bumpy ball by a brute-force search. The measurement must report a
 * distance of zero for a method with a known surface, and the default settings must place the
 * surface where it is seen.
 */

#include "BumpyBall.h"

#include "Shapes.h"

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
TEST(BumpyBall, SurfaceHasTheMiddleValue)
{
  std::mt19937 random(5);
  Uniform uniform(random);
  for (int i = 0; i < 50; ++i)
  {
    const Vector3 x = { uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0) };
    const Vector3 at = (uniform(88.0, 93.0) / Norm(x)) * x;
    const SurfacePoint found = NearestOnBumpyBall(at);
    EXPECT_NEAR(BumpyBallValue(found.Position), 100.0, 1e-6);
    EXPECT_NEAR(Norm(found.Outward), 1.0, 1e-12);
    // The vector to the nearest point is parallel to the normal.
    EXPECT_LT(Norm(Cross(at - found.Position, found.Outward)), 1e-6);
    // The value falls outwards with the slope of tanh: half the height divided by the scale of 2
    // mm.
    const double h = 1e-4;
    EXPECT_LT(BumpyBallValue(found.Position + h * found.Outward), 100.0);
    // No other surface point nearby is closer.
    const double distance = Norm(at - found.Position);
    const Vector3 out = (1.0 / Norm(at)) * at;
    const Vector3 side = (1.0 / Norm(Cross(out, OddUp))) * Cross(out, OddUp);
    const Vector3 up = Cross(out, side);
    for (int j = -20; j <= 20; ++j)
    {
      for (int k = -20; k <= 20; ++k)
      {
        const Vector3 way = at + 0.2 * j * side + 0.2 * k * up;
        double low = -8.0;
        double high = 8.0;
        for (int step = 0; step < 60; ++step)
        {
          const double middle = 0.5 * (low + high);
          (BumpyBallValue(way + middle * out) > 100.0 ? low : high) = middle;
        }
        EXPECT_GT(Norm(way + low * out - at), distance - 1e-6);
      }
    }
  }
}

TEST(BumpyBall, MeshOfTheLevelLiesOnIt)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetMethodToSurfaceProxy();
  filter->SetProxyRadius(ProbeRadius);
  filter->SetIsoValue(100.0);
  const BumpyBallFeel felt = FeelBumpyBall(filter, {});
  EXPECT_GT(felt.Ticks, 1000u);
  EXPECT_LT(felt.Distance, 0.1);
  EXPECT_LT(felt.Angle, 4.0);
}

TEST(BumpyBall, IsFeltWhereItIsSeenByDefault)
{
  for (const Figure& figure : MeasureBumpyBall({}))
  {
    EXPECT_TRUE(figure.IsReached()) << figure.Name << ": " << figure.Value << " " << figure.Unit;
  }
  vtkNew<vtkVolumeHapticsFilter> paper;
  paper->SetContactAlignmentToDistinctness();
  paper->SetMaterialPlacementToKernel();
  EXPECT_GT(FeelBumpyBall(paper, {}).Distance, 1.0) << "the figure can tell";
}
} // namespace
