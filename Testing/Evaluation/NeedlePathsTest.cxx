// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Plans paths into a ball of liver in a ball of flesh, with a plate of bone in front of one side.
 * Computes the errors of forces that differ by a known amount.
 */

#include "NeedlePaths.h"

#include "Shapes.h"

#include "vtkImageData.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
constexpr double LiverRadius = 8.0;
constexpr double SkinRadius = 20.0;

bool IsPlate(const Vector3& x)
{
  return std::abs(x.X - 13.0) < 1.5;
}

TEST(NeedlePaths, LeadFromTheSkinToTheLiverPastBone)
{
  constexpr double halfSize = 40.0;
  for (const bool isBoneByLabel : { false, true })
  {
    const auto image = SampleImage(
      [&](const Vector3& x)
      {
        if (Norm(x) > SkinRadius)
        {
          return -1000.0;
        }
        return IsPlate(x) && !isBoneByLabel ? 900.0 : 50.0;
      },
      halfSize);
    const auto labels = SampleImage(
      [&](const Vector3& x)
      {
        if (Norm(x) < LiverRadius)
        {
          return 5.0;
        }
        return IsPlate(x) && Norm(x) < SkinRadius && isBoneByLabel ? 93.0 : 0.0;
      },
      halfSize);
    const NeedleLabels sorted = SortLabels({ { 5, "liver" }, { 93, "rib_left_2" } });
    const std::vector<Path> paths = PlanNeedlePaths(image, labels, sorted, 60);
    ASSERT_EQ(paths.size(), 60u);
    for (const Path& path : paths)
    {
      EXPECT_LT(Norm(path.back()), LiverRadius);
      EXPECT_NEAR(Norm(path.front()), SkinRadius + 4.0, 2.5);
      for (const Vector3& x : path)
      {
        EXPECT_FALSE(IsPlate(x) && Norm(x) < SkinRadius - 1.0) << "bone";
      }
    }
    EXPECT_EQ(PlanNeedlePaths(image, labels, sorted, 3)[2].front().X, paths[2].front().X)
      << "the same ones for the same seed";
  }
}

TEST(NeedlePaths, LabelsAreSortedByTheirNames)
{
  const NeedleLabels sorted =
    SortLabels({ { 1, "spleen" }, { 5, "liver" }, { 11, "lung_lower_lobe_left" },
      { 31, "vertebrae_L1" }, { 51, "heart" }, { 118, "costal_cartilages" } });
  EXPECT_EQ(sorted.Liver, (std::set<int>{ 5 }));
  EXPECT_EQ(sorted.Bone, (std::set<int>{ 31, 118 }));
  EXPECT_EQ(sorted.Others, (std::set<int>{ 11, 51 }));
}

TEST(NeedlePaths, ErrorsOfForcesThatDifferByAKnownAmount)
{
  Trace one(100);
  Trace other(100);
  for (std::size_t i = 0; i < 25; ++i)
  {
    other[i].Force = { 0.0, 0.6, 0.8 }; // 1 N in a quarter of the ticks
  }
  const ForceError error = CompareForces({ one }, { other });
  EXPECT_NEAR(error.RootMeanSquare, 0.5, 1e-12);
  EXPECT_NEAR(error.Largest, 1.0, 1e-12);
  EXPECT_NEAR(error.Affected, 25.0, 1e-9);
  const ForceError two = CompareForces({ one, one }, { other, one });
  EXPECT_NEAR(two.RootMeanSquare, 0.25, 1e-12) << "the mean of paths";
  EXPECT_NEAR(two.Affected, 12.5, 1e-9);
  EXPECT_NEAR(CompareForces({ one, one, one }, { one, one, other }).Typical, 0.0, 1e-12);
  EXPECT_NEAR(CompareForces({ one, one, one }, { other, one, other }).Typical, 1.0, 1e-12);
}

TEST(NeedlePaths, LabelsChangeTheForceOnlyWhereValuesMislead)
{
  const auto labels =
    SampleImage([](const Vector3& x) { return Norm(x) < LiverRadius ? 5.0 : 0.0; }, 40.0);
  // A liver as dense as the surrounding flesh has the material of its value; a liver as light as
  // fat has not.
  for (const double liver : { 50.0, -90.0 })
  {
    const auto image = SampleImage(
      [&](const Vector3& x)
      {
        const double flesh = BlurredStep(SkinRadius - Norm(x), 1.0, 1050.0) - 1000.0;
        return flesh + BlurredStep(LiverRadius - Norm(x), 1.0, liver - 50.0);
      },
      40.0);
    Comparison found;
    const ForceError error = RunNeedleProtocol(image, labels, { { 5, "liver" } }, 5, found);
    ASSERT_EQ(found.Tables.size(), 1u);
    EXPECT_EQ(found.Tables[0].Rows.size(), 2u);
    ASSERT_EQ(found.Plots.size(), 1u);
    EXPECT_GT(
      *std::max_element(found.Plots[0].Curves[0].Y.begin(), found.Plots[0].Curves[0].Y.end()), 0.3)
      << "the skin resists";
    if (liver == 50.0)
    {
      EXPECT_LT(error.Largest, 1e-6);
      EXPECT_EQ(error.Affected, 0.0);
    }
    else
    {
      EXPECT_GT(error.Largest, 0.02);
      EXPECT_GT(error.Affected, 5.0);
      EXPECT_LT(error.Affected, 70.0) << "not before the liver";
    }
  }
}
} // namespace
