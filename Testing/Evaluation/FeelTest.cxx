// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Strokes over a ball, whose sections are circles, and what is felt on it. */

#include "Feel.h"

#include "Shapes.h"

#include "vtkImageData.h"

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
constexpr double BallRadius = 14.0; // mm

/** Air around a ball of a value, and a thin plate beside it, as a head rest is. */
vtkSmartPointer<vtkImageData> MakeHead(double value)
{
  return SampleImage(
    [value](const Vector3& x)
    {
      const double plate = std::exp(-0.5 * std::pow((x.Y + 20.0) / 0.8, 2.0));
      return -1000.0 + BlurredStep(BallRadius - Norm(x), 1.0, value + 1000.0) + 1500.0 * plate;
    },
    24.0);
}

TEST(Feel, ArcsLieUnderTheBallAndNotUnderThePlate)
{
  const double level = -480.0; // the middle of the edge
  const double beyond = 3.0;
  const std::vector<Arc> arcs = FindArcs(MakeHead(40.0), level, beyond, { true });
  ASSERT_FALSE(arcs.empty());
  for (const Arc& arc : arcs)
  {
    ASSERT_GT(arc.Tips.size(), arc.Pressed + 300);
    const double z = arc.Tips.front().Z;
    const double section = std::sqrt(BallRadius * BallRadius - z * z);
    double deepest = section;
    for (std::size_t i = 0; i < arc.Tips.size(); ++i)
    {
      const Vector3& tip = arc.Tips[i];
      EXPECT_EQ(tip.Z, z);
      const double radius = std::hypot(tip.X, tip.Y);
      deepest = std::min(deepest, radius);
      if (i >= arc.Pressed)
      {
        EXPECT_NEAR(radius, section - 2.0, 0.15);
      }
    }
    EXPECT_NEAR(deepest, section - 2.0 - beyond, 0.15);
  }
}

TEST(Feel, ABallOfOneTissueIsSmooth)
{
  std::vector<Plot> plots;
  const Table table = CompareFeel(MakeHead(1000.0), {}, plots);
  ASSERT_EQ(plots.size(), 2u);
  ASSERT_FALSE(plots.front().Curves.empty());
  for (const std::vector<std::string>& row : table.Rows)
  {
    ASSERT_EQ(row.size(), table.Columns.size());
    if (row[1] == "SURFACE_PROXY" || row[1] == "... one material")
    {
      EXPECT_GT(std::stod(row[2]), 0.1) << row[0] << " " << row[1];
      EXPECT_LT(std::stod(row[3]), 0.6) << row[0] << " " << row[1];
      EXPECT_EQ(std::stod(row[5]), 0.0) << row[0] << " " << row[1];
    }
  }
}
} // namespace
