// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the tree of boxes with a slow search, and tests its limit of work per tick.
 */

#include "Core/Solvers/SurfaceProxy/SurfaceProxy.h"
#include "Rigs/SurfaceRig.h"

#include <set>

using namespace coretest;

TEST(SurfaceTree, TheTreeFindsWhatIsNearAndWhatIsMetFirst)
{
  const auto ball = MakeBall(20.0, 24, false);
  const auto count = static_cast<std::int32_t>(ball->GetNumberOfTriangles());
  EXPECT_EQ(count, 2 * 2 * 24 * 24 - 2 * 2 * 24) << "the poles' have no area";
  Dice dice(4);
  for (int trial = 0; trial < 500; ++trial)
  {
    const Vector3 start = dice.Point(30.0);
    const Vector3 way = dice.Point(40.0);
    const double radius = dice(0.1, 3.0);
    std::set<std::int32_t> near;
    int budget = 100000;
    EXPECT_TRUE(ball->VisitNear(
      start, radius, budget, [&](std::int32_t i) { EXPECT_TRUE(near.insert(i).second); }));
    double first = Never;
    double foundFirst = Never;
    for (std::int32_t i = 0; i < count; ++i)
    {
      const Triangle triangle = ball->GetTriangle(i);
      EXPECT_TRUE(Distance(triangle, start) > radius || near.count(i) == 1);
      first = std::min(first, MeetingTime(triangle, start, way, radius));
    }
    ball->VisitAlong(start, way, radius, budget,
      [&](std::int32_t i)
      {
        foundFirst = std::min(foundFirst, MeetingTime(ball->GetTriangle(i), start, way, radius));
        return std::min(foundFirst, 1.0);
      });
    EXPECT_EQ(foundFirst, first) << trial;
  }
}

TEST(SurfaceTree, AQueryTakesNoMoreThanItsBudget)
{
  const auto floor = MakeFloor(100);
  const auto ignore = [](std::int32_t) {};
  const int needed = floor->EstimateVisits(5.0);
  EXPECT_GT(needed, 200) << "10 x 10 squares of 2 triangles";
  EXPECT_LT(needed, 2000);
  int enough = needed;
  EXPECT_TRUE(floor->VisitNear({ 0.5, 0.3, 0.0 }, 5.0, enough, ignore));
  EXPECT_LT(enough, needed);
  int few = 20;
  int visited = 0;
  EXPECT_FALSE(floor->VisitNear({ 0.5, 0.3, 0.0 }, 5.0, few, [&](std::int32_t) { ++visited; }));
  EXPECT_LE(visited, 20);
  few = 20;
  EXPECT_FALSE(floor->VisitAlong(
    { -40.0, 0.0, 0.0 }, { 80.0, 0.0, 0.0 }, 1.0, few, [](std::int32_t) { return 1.0; }));
}

TEST(SurfaceTree, ASphereThatTouchesTooManyTrianglesStaysOutside)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription d = DescribeMesh(volume, MakeFloor(200));
  d.Settings.ProxyRadius = 30.0;
  ASSERT_GT(d.Mesh->EstimateVisits(30.0), MostTouched);
  Hand hand(d, { 0.3, 0.2, 35.0 });
  hand.Lead({ 0.3, 0.2, 20.0 });
  EXPECT_TRUE(hand.Record.IsUnfinished);
  EXPECT_GE(hand.Proxy().Z, 30.0);
  // Elsewhere, fewer boxes have to be visited, so the search ends within a tick.
  hand.Lead({ 0.3, 0.2, 60.0 });
  EXPECT_FALSE(hand.Record.IsUnfinished);
  EXPECT_EQ(Norm(hand.Record.Force), 0.0);
}
