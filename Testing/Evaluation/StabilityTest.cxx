// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects, for every method that has a wall, the stiffest stable wall that theory predicts for a
 * sampled spring.
 */

#include "Comparison.h"

#include <gtest/gtest.h>

using namespace evaluation;

TEST(Stability, EveryWallIsAsStiffAsTheoryAllows)
{
  std::vector<Plot> plots;
  CompareStability({}, plots);
  ASSERT_EQ(plots.size(), 2u);
  for (const bool isLate : { false, true })
  {
    int walls = 0;
    for (const Curve& curve : plots[isLate ? 1 : 0].Curves)
    {
      if (curve.Name == "2 b / T")
      {
        continue;
      }
      ++walls;
      for (std::size_t i = 0; i < curve.X.size(); ++i)
      {
        // One tick of delay reduces the stiffness to a third.
        const double theory = 2000.0 * curve.X[i] / (isLate ? 3.0 : 1.0);
        EXPECT_NEAR(curve.Y[i], theory, 0.02 * theory) << curve.Name << ", " << curve.X[i];
      }
    }
    EXPECT_GE(walls, 3) << "PAPER, PRECISE and SURFACE_PROXY at least";
  }
}
