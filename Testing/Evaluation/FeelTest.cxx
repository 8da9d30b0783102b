// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the strokes on a ball, whose sections are circles. */

#include "Feel.h"

#include "Shapes.h"
#include "TickRatio.h"

#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

using namespace evaluation;

namespace
{
constexpr double BallRadius = 14.0; // mm

/**
 * Returns air with a ball of a value, and a thin plate beside the ball that represents a head rest.
 */
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
  const double level = -480.0; // the value in the middle of the edge
  const double beyond = 3.0;
  const auto head = MakeHead(40.0);
  const std::vector<Arc> arcs = FindArcs(head, AroundHead(head, level, beyond, { true }));
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

TEST(Feel, ArcsAreFoundFromInside)
{
  // Make a shell around a ball: outwards from the middle, the ball's surface comes first.
  const auto ball = SampleImage(
    [](const Vector3& x)
    {
      const double shell = std::exp(-0.5 * std::pow((Norm(x) - 20.0) / 1.0, 2.0));
      return BlurredStep(BallRadius - Norm(x), 0.8, 100.0) + 150.0 * shell;
    },
    24.0);
  Course course = AroundHead(ball, 50.0, 0.0, {});
  course.Middles = { { 0.0, 0.0, 3.0 } };
  course.IsSeenFromInside = true;
  const std::vector<Arc> arcs = FindArcs(ball, course);
  ASSERT_FALSE(arcs.empty());
  const double section = std::sqrt(BallRadius * BallRadius - 9.0);
  for (std::size_t i = arcs[0].Pressed; i < arcs[0].Tips.size(); ++i)
  {
    EXPECT_NEAR(Norm(arcs[0].Tips[i] - arcs[0].Middle), section - ArcDepth, 0.15);
  }
  course.IsSeenFromInside = false;
  for (const Arc& arc : FindArcs(ball, course))
  {
    EXPECT_GT(Norm(arc.Tips.back() - arc.Middle), section + 2.0) << "the shell";
  }
}

TEST(Feel, WidenedStepsAreRamps)
{
  vtkNew<vtkPiecewiseFunction> step;
  step->AddPoint(-225.0, 1.0);
  step->AddPoint(-0.001, 1.0);
  step->AddPoint(0.001, 3.0);
  step->AddPoint(225.0, 3.0);
  Widen(step, 60.0);
  for (const double value : { -300.0, -100.0, -31.0 })
  {
    EXPECT_NEAR(step->GetValue(value), 1.0, 1e-9) << value;
  }
  for (const double value : { -22.5, -15.0, 0.0, 7.5 })
  {
    EXPECT_NEAR(step->GetValue(value), 2.0 + value / 30.0, 1e-6) << value;
  }
  EXPECT_NEAR(step->GetValue(500.0), 3.0, 1e-9);
}

TEST(Feel, CausesOfDropsAreWhatChanges)
{
  // Make three drops: the first while the strength falls, the second while the proxy jumps, and the
  // third without a known cause.
  Trace trace(400);
  for (std::size_t i = 0; i < trace.size(); ++i)
  {
    trace[i].Stiffness = 500.0;
    trace[i].SurfaceStrength = i < 100 ? 2.0 : 0.5;
    trace[i].Proxy = { i < 200 ? 0.0 : 0.001, 0.0, 0.0 };
    const bool isLow = i % 100 < 50 && i >= 100;
    trace[i].Force = { 0.0, 0.0, isLow ? 0.5 : 1.0 };
  }
  DropCauses causes;
  AddDropCauses(trace, 10, causes);
  EXPECT_EQ(causes.Drops, 3);
  EXPECT_EQ(causes.Strength, 1);
  EXPECT_EQ(causes.Stiffness, 0);
  EXPECT_EQ(causes.Snap, 1);
  EXPECT_EQ(causes.Unexplained, 1);
}

TEST(Feel, ABallOfOneTissueIsSmooth)
{
  const Feel feel = MeasureFeel(FindHeadSurfaces(MakeHead(1000.0), {}));
  ASSERT_EQ(feel.Found.Plots.size(), 2u);
  ASSERT_FALSE(feel.Found.Plots.front().Curves.empty());
  EXPECT_EQ(feel.Required.size(), 6u);
  int judged = 0;
  for (const std::vector<std::string>& row : feel.Found.Tables.front().Rows)
  {
    ASSERT_EQ(row.size(), feel.Found.Tables.front().Columns.size());
    if (row[1].rfind("SURFACE_PROXY", 0) == 0 || row[1] == "... one material")
    {
      ++judged;
      EXPECT_GT(std::stod(row[2]), 0.1) << row[0] << " " << row[1];
      EXPECT_LT(std::stod(row[5]), 0.6) << row[0] << " " << row[1];
      EXPECT_EQ(std::stod(row[6]), 0.0) << row[0] << " " << row[1];
    }
  }
  EXPECT_EQ(judged, 6);
}

TEST(Feel, TicksAreComparedOnStrokesThatThereAre)
{
  // The times themselves are not checked.
  FeltSurface surface = FindHeadSurfaces(MakeHead(1000.0), {}).front();
  const Setting none = [](vtkVolumeHapticsFilter*) {};
  EXPECT_GT(MeasureTickRatio(surface, none, none), 0.0);
  surface.Arcs.clear();
  EXPECT_EQ(MeasureTickRatio(surface, none, none), 0.0);
}
} // namespace
