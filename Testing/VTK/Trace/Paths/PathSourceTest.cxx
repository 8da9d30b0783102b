// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the shapes of vtkHapticPathSource against closed forms.
 */

#include "Rigs/ApiRig.h"

#include <vtkHapticPathSource.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <cmath>

using namespace apitest;

namespace
{
constexpr double Pi = 3.14159265358979323846;

class PathSource : public testing::Test
{
protected:
  /// Updates the source. Expects a polyline with times whose steps are as long as the first step,
  /// or shorter by up to `bend`.
  vtkPolyData* Run(double length, double bend)
  {
    this->Source->Update();
    EXPECT_TRUE(this->Log.Errors.empty()) << this->Log.Errors.front();
    vtkPolyData* const path = this->Source->GetOutput();
    const vtkIdType n = path->GetNumberOfPoints();
    const double rate = this->Source->GetPointsPerSecond();
    const double most = this->Source->GetSpeed() / rate;
    EXPECT_EQ(n - 1, static_cast<vtkIdType>(std::ceil(length / most - 1e-6)));
    EXPECT_EQ(path->GetNumberOfCells(), 1);
    double sum = 0.0;
    for (vtkIdType i = 0; i + 1 < n; ++i)
    {
      const double step =
        std::sqrt(vtkMath::Distance2BetweenPoints(this->At(i).data(), this->At(i + 1).data()));
      EXPECT_LE(step, most * (1.0 + 1e-9));
      EXPECT_GE(step, length / static_cast<double>(n - 1) * (1.0 - bend));
      EXPECT_EQ(Get(path, "Time", i), static_cast<double>(i) / rate);
      sum += step;
    }
    EXPECT_NEAR(sum, length, bend * length + 1e-9);
    return path;
  }
  Point At(vtkIdType i)
  {
    const double* const x = this->Source->GetOutput()->GetPoint(i);
    return { x[0], x[1], x[2] };
  }
  vtkIdType Last() { return this->Source->GetOutput()->GetNumberOfPoints() - 1; }
  void ExpectAt(vtkIdType i, const Point& x)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(this->At(i)[axis], x[axis], 1e-9) << "point " << i << ", axis " << axis;
    }
  }

  vtkNew<vtkHapticPathSource> Source;
  MessageLog Log{ this->Source };
};
} // namespace

TEST_F(PathSource, LineGoesFromEndToEnd)
{
  EXPECT_EQ(this->Run(100.0, 1e-9)->GetNumberOfPoints(), 1001);
  this->ExpectAt(0, { -50, 0, 0 });
  this->ExpectAt(250, { -25, 0, 0 });
  this->ExpectAt(1000, { 50, 0, 0 });
  this->Source->SetSpeed(30.0);
  // Steps are slightly shorter than at 30 mm/s, so that the last step ends exactly at the end of
  // the line.
  EXPECT_EQ(this->Run(100.0, 1e-9)->GetNumberOfPoints(), 3335);
}

TEST_F(PathSource, CircleStaysAtItsRadiusInItsPlane)
{
  this->Source->SetShapeToCircle();
  this->Source->SetCenter(1, 2, 3);
  this->Source->SetNormal(0, -3, 4);
  this->Source->SetTurns(1.5);
  this->Run(2.0 * Pi * 20.0 * 1.5, 1e-4);
  for (vtkIdType i = 0; i <= this->Last(); ++i)
  {
    const Point x = this->At(i);
    EXPECT_NEAR(-3 * (x[1] - 2) + 4 * (x[2] - 3), 0.0, 1e-9);
    EXPECT_NEAR(std::hypot(x[0] - 1, x[1] - 2, x[2] - 3), 20.0, 1e-9);
  }
  this->ExpectAt(0, { 21, 2, 3 });
  this->ExpectAt(this->Last(), { -19, 2, 3 }); // half a turn beyond the start
}

TEST_F(PathSource, SpiralGoesOutEvenlyWithItsTurns)
{
  this->Source->SetShapeToSpiral();
  this->Source->SetTurns(2.0);
  const double full = 4.0 * Pi;
  const double step = 20.0 / full;
  this->Run(0.5 * step * (full * std::hypot(1, full) + std::asinh(full)), 1e-3);
  this->ExpectAt(0, { 0, 0, 0 });
  this->ExpectAt(this->Last(), { 20, 0, 0 });
  double before = 0.0;
  for (vtkIdType i = 1; i <= this->Last(); ++i)
  {
    const Point x = this->At(i);
    const double radius = std::hypot(x[0], x[1]);
    EXPECT_GT(radius, before);
    before = radius;
    EXPECT_NEAR(std::remainder(radius / step - std::atan2(x[1], x[0]), 2.0 * Pi), 0.0, 1e-9);
  }
}

TEST_F(PathSource, PressAndSlideComesDownPressesSlidesAndLifts)
{
  this->Source->SetShapeToPressAndSlide();
  this->Source->SetBoxBounds(0, 10, 0, 40, -5, 5);
  this->Source->SetClearance(7.0);
  this->Run(60.0, 1e-9);
  this->ExpectAt(0, { 5, 0, 12 });
  this->ExpectAt(100, { 5, 0, 2 });
  this->ExpectAt(500, { 5, 40, 2 });
  this->ExpectAt(600, { 5, 40, 12 });
  this->Source->SetPressDirection(vtkHapticPathSource::PLUS_Y);
  this->Run(30.0, 1e-9);
  this->ExpectAt(0, { 5, -7, -5 });
  this->ExpectAt(100, { 5, 3, -5 });
  this->ExpectAt(200, { 5, 3, 5 });
}
