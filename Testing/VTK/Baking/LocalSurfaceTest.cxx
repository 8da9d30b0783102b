// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the method LOCAL_SURFACE through the filter.
 */

#include "Rigs/ApiRig.h"

#include <cmath>

using namespace apitest;

namespace
{
constexpr double Middle = 20.0;
constexpr double BallRadius = 12.0;

class LocalSurfaceTest : public ApiTest
{
protected:
  LocalSurfaceTest()
  {
    this->Filter->SetMethodToLocalSurface();
    this->Filter->SetLocalSurfaceShapeToQuadric();
    this->Filter->SetInputData(0, this->Ball);
    this->Filter->SetIsoValue(100.0);
    std::vector<Point> points = Line({ Middle, Middle, Middle + BallRadius + 3.0 },
      { Middle, Middle, Middle + BallRadius - 2.0 }, 100);
    const std::vector<Point> rest(100, points.back());
    points.insert(points.end(), rest.begin(), rest.end());
    this->Filter->SetPathData(MakePath(points));
  }

  /// A ball with the value 100 on the surface, which increases by 10 per voxel towards the middle.
  const vtkSmartPointer<vtkImageData> Ball = MakeImage(41, VTK_FLOAT,
    [](const Point& x)
    {
      const double r = std::hypot(x[0] - Middle, x[1] - Middle, x[2] - Middle);
      return 100.0 + 10.0 * (BallRadius - r);
    });
};
} // namespace

TEST_F(LocalSurfaceTest, HoldsOnTheIsosurface)
{
  vtkPolyData* const output = this->Run(201);
  EXPECT_NEAR(output->GetPoint(200)[2], Middle + BallRadius, 0.01);
  EXPECT_NEAR(Get(output, "Force", 200, 2), 500.0 * 0.002, 0.005);
  EXPECT_EQ(Get(output, "Stiffness", 200), 500.0);
  EXPECT_EQ(Get(output, "SurfaceValue", 200), 100.0);
  EXPECT_EQ(Get(output, "SurfaceStrength", 200), 0.0);
}

TEST_F(LocalSurfaceTest, TheSlowLoopIsAsSlowAsItIsSaid)
{
  for (const auto& [rate, period] : { std::pair{ 60.0, 17 }, { 100.0, 10 }, { 30.0, 34 } })
  {
    this->Filter->SetLocalSurfaceRate(rate);
    vtkPolyData* const output = this->Run(201);
    for (int i = 0; i < 201; ++i)
    {
      EXPECT_EQ(Get(output, "Renewed", i), i > 0 && i % period == 0) << rate << " Hz, tick " << i;
    }
  }
}

TEST_F(LocalSurfaceTest, RecoveryIsAsLongAsItIsSaid)
{
  // The hand is inside the ball when the first local surface arrives, at tick 17.
  std::vector<Point> points{ { Middle, Middle, Middle + BallRadius + 0.5 } };
  points.insert(points.end(), 120, { Middle, Middle, Middle + BallRadius - 2.0 });
  this->Filter->SetPathData(MakePath(points));
  this->Filter->SetRecoveryTime(0.05);
  vtkPolyData* const output = this->Run(121);
  EXPECT_EQ(Get(output, "NormalForce", 16), 0.0);
  for (const int tick : { 0, 1, 10, 24, 49 })
  {
    EXPECT_NEAR(Get(output, "NormalForce", 17 + tick), tick / 50.0, 0.01) << tick;
  }
  EXPECT_NEAR(Get(output, "NormalForce", 17 + 60), 1.0, 0.01);
  this->Filter->SetRecoveryTime(0.0);
  EXPECT_NEAR(Get(this->Run(121), "NormalForce", 18), 1.0, 0.01);
}

TEST_F(LocalSurfaceTest, WithoutAnIsosurfaceThereIsNoContact)
{
  for (const double iso : { 1e6, -1e6 })
  {
    this->Filter->SetIsoValue(iso);
    vtkPolyData* const output = this->Run(201);
    EXPECT_EQ(Get(output, "Contact", 200), 0.0);
    EXPECT_EQ(Get(output, "NormalForce", 200), 0.0);
  }
}
