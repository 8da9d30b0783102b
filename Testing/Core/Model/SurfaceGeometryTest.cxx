// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares nearest points and swept spheres with slow searches.
 */

#include "Rigs/MeshScene.h"

#include <gtest/gtest.h>

using namespace coretest;

TEST(SurfaceGeometry, TheNearestPointOfATriangleHasItsWeights)
{
  Dice dice(2);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const Triangle triangle = dice.Any();
    const Vector3 x = dice.Point(4.0);
    const TrianglePoint nearest = NearestPoint(triangle, x);
    const auto& [a, b, c] = triangle.Corner;
    const auto& w = nearest.Weight;
    EXPECT_LE(Norm(w[0] * a + w[1] * b + w[2] * c - nearest.Position), 1e-12);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1.0, 1e-12);
    EXPECT_GE(std::min({ w[0], w[1], w[2] }), 0.0);
    for (int i = 0; i < 50; ++i)
    {
      const double u = dice(0.0, 1.0);
      const double v = dice(0.0, 1.0 - u);
      EXPECT_GE(Norm(x - (u * a + v * b + (1.0 - u - v) * c)), Distance(triangle, x) - 1e-12);
    }
  }
}

TEST(SurfaceGeometry, AMovingSphereMeetsATriangleWhereItIsARadiusAway)
{
  Dice dice(3);
  int met = 0;
  for (int trial = 0; trial < 5000; ++trial)
  {
    const Triangle triangle = dice.Any();
    const Vector3 start = dice.Point(4.0);
    const Vector3 way = dice.Point(6.0);
    const double radius = dice(0.05, 1.0);
    const double time = MeetingTime(triangle, start, way, radius);
    const double end = std::min(time, 1.0);
    if (Distance(triangle, start) <= radius)
    {
      continue;
    }
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_GE(Distance(triangle, start + (end * i / 100) * way), radius - 1e-9) << trial;
    }
    if (time <= 1.0)
    {
      EXPECT_NEAR(Distance(triangle, start + time * way), radius, 1e-9) << trial;
      ++met;
    }
  }
  EXPECT_GT(met, 200);
}

TEST(SurfaceGeometry, ALargeTriangleIsNotMissed)
{
  Dice dice(5);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Vector3 u = dice.Point(1e5);
    const Vector3 v = dice.Point(1e5);
    const Vector3 normal = (1.0 / Norm(Cross(u, v))) * Cross(u, v);
    const Triangle triangle{ { -0.3 * u - 0.3 * v, 0.7 * u - 0.3 * v, 0.7 * v - 0.3 * u } };
    const Vector3 start = 5.0 * normal + dice.Point(0.1);
    EXPECT_LE(MeetingTime(triangle, start, -10.0 * normal, 0.1), 1.0) << trial;
  }
}
