// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the nearest point in several half-spaces with the result of alternating projections.
 */

#include "Core/Math/HalfSpaces.h"
#include "Rigs/MeshScene.h"

#include <gtest/gtest.h>

using namespace coretest;

TEST(HalfSpaces, TheNearestPointOfHalfSpacesIsAllowedAndNoneIsNearer)
{
  Dice dice(1);
  for (int trial = 0; trial < 2000; ++trial)
  {
    // All half-spaces contain the origin, so a common point exists.
    HalfSpaces spaces;
    std::vector<HalfSpace> all;
    for (int i = trial % 9; i >= 0; --i)
    {
      const Vector3 direction = dice.Point(1.0);
      all.push_back({ (1.0 / Norm(direction)) * direction, dice(-1.0, 0.0) });
      spaces.Add(all.back());
    }
    const Vector3 goal = dice.Point(3.0);
    const Vector3 found = spaces.Nearest(goal, {});
    // Dykstra's alternating projections converge to the nearest point of the intersection.
    Vector3 y = goal;
    std::vector<Vector3> corrections(all.size());
    for (int round = 0; round < 3000; ++round)
    {
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        const Vector3 from = y + corrections[i];
        const double missing = std::max(0.0, all[i].Bound - Dot(all[i].Normal, from));
        y = from + missing * all[i].Normal;
        corrections[i] = from - y;
      }
    }
    for (const HalfSpace& space : all)
    {
      EXPECT_GE(Dot(space.Normal, found), space.Bound - 1e-9);
    }
    EXPECT_LE(Norm(found - goal), Norm(y - goal) + 1e-6) << trial;
  }
}

TEST(HalfSpaces, WhereNothingIsAllowedTheProxyStays)
{
  HalfSpaces spaces;
  spaces.Add({ { 0.0, 0.0, 1.0 }, 1.0 });
  spaces.Add({ { 0.0, 0.0, -1.0 }, 1.0 });
  const Vector3 stay = { 1.0, 2.0, 3.0 };
  EXPECT_EQ(Norm(spaces.Nearest({ 5.0, 0.0, 0.0 }, stay) - stay), 0.0);
}
