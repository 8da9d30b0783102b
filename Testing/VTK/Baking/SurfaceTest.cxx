// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the method SURFACE_PROXY on isosurfaces and on application-defined surfaces. */

#include "Rigs/ApiRig.h"

#include <vtkSphereSource.h>

#include <cmath>

using namespace apitest;

namespace
{
constexpr double Middle = 20.0;
constexpr double BallRadius = 12.0;

/// Makes a path around a ball, 2 mm below its surface.
vtkSmartPointer<vtkPolyData> MakeTurn()
{
  std::vector<Point> points =
    Line({ Middle, Middle, Middle + 18.0 }, { Middle, Middle, Middle + BallRadius - 2.0 }, 80);
  for (int i = 0; i <= 600; ++i)
  {
    const double angle = 0.01 * i;
    const double r = BallRadius - 2.0;
    points.push_back({ Middle + 0.6 * r * std::sin(angle), Middle + 0.8 * r * std::sin(angle),
      Middle + r * std::cos(angle) });
  }
  return MakePath(points);
}

class SurfaceTest : public ApiTest
{
protected:
  SurfaceTest()
  {
    this->Filter->SetMethodToSurfaceProxy();
    this->Filter->SetInputData(0, this->Ball);
    this->Filter->SetPathData(this->Turn);
    this->Filter->SetIsoValue(100.0);
  }
  /// Returns the RMS distance (mm), after the approach, of the proxy from the ideal centre of a
  /// sphere that touches the ball.
  double Deviation(vtkPolyData* output, double proxyRadius)
  {
    double sum = 0.0;
    const vtkIdType first = 90;
    for (vtkIdType i = first; i < output->GetNumberOfPoints(); ++i)
    {
      const double* const x = output->GetPoint(i);
      const double r = std::hypot(x[0] - Middle, x[1] - Middle, x[2] - Middle);
      sum += std::pow(r - BallRadius - proxyRadius, 2);
      EXPECT_EQ(Get(output, "Contact", i), 2.0) << i;
    }
    return std::sqrt(sum / double(output->GetNumberOfPoints() - first));
  }

  /// A ball with the value 100 on the surface, which increases by 10 per voxel towards the middle.
  const vtkSmartPointer<vtkImageData> Ball = MakeImage(41, VTK_FLOAT,
    [](const Point& x)
    {
      const double r = std::hypot(x[0] - Middle, x[1] - Middle, x[2] - Middle);
      return 100.0 + 10.0 * (BallRadius - r);
    });
  const vtkSmartPointer<vtkPolyData> Turn = MakeTurn();
};
} // namespace

TEST_F(SurfaceTest, TheIsosurfaceOfABallIsTracked)
{
  vtkPolyData* const output = this->Run(this->Turn->GetNumberOfPoints());
  EXPECT_LT(this->Deviation(output, 0.5), 0.02) << "voxels: the facets are a voxel wide";
  const vtkIdType last = output->GetNumberOfPoints() - 1;
  EXPECT_NEAR(Get(output, "NormalForce", last), 500.0 * 0.0025, 0.01);
  EXPECT_EQ(Get(output, "Stiffness", last), 500.0);
  EXPECT_EQ(Get(output, "SurfaceValue", last), 100.0);
}

TEST_F(SurfaceTest, TheGeometryOfTheImageCounts)
{
  this->Ball->SetSpacing(2.0, 2.0, 2.0);
  this->Ball->SetOrigin(-Middle, -Middle, -Middle);
  const double turn[9] = { 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0 };
  this->Ball->SetDirectionMatrix(turn);
  this->Filter->SetProxyRadius(0.25);
  double middle[3];
  this->Ball->TransformContinuousIndexToPhysicalPoint(Middle, Middle, Middle, middle);
  const Point above = { middle[0], middle[1], middle[2] + 30.0 };
  const Point below = { middle[0], middle[1], middle[2] + 22.0 };
  this->Filter->SetPathData(MakePath(Line(above, below, 80)));
  vtkPolyData* const output = this->Run(81);
  const double* const proxy = output->GetPoint(80);
  EXPECT_NEAR(proxy[2], middle[2] + 2.0 * BallRadius + 0.25, 0.02);
  EXPECT_NEAR(Get(output, "Force", 80, 2), 500.0 * 0.00225, 0.01);
}

TEST_F(SurfaceTest, MaterialsAreThoseOfTheIsoValue)
{
  vtkPiecewiseFunction* const stiffness = this->Property->GetStiffness();
  stiffness->AddPoint(0.0, 200.0);
  stiffness->AddPoint(200.0, 1000.0);
  SetConstant(this->Property->GetFriction(), 0.3);
  vtkPolyData* const output = this->Run(this->Turn->GetNumberOfPoints());
  const vtkIdType last = output->GetNumberOfPoints() - 1;
  EXPECT_DOUBLE_EQ(Get(output, "Stiffness", last), 600.0);
  EXPECT_NEAR(Get(output, "FrictionForce", last), 0.3 * Get(output, "NormalForce", last), 1e-3);
}

TEST_F(SurfaceTest, AGivenSurfaceTakesTheIsosurfacesPlace)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(Middle, Middle, Middle);
  sphere->SetRadius(BallRadius);
  sphere->SetThetaResolution(120);
  sphere->SetPhiResolution(120);
  this->Filter->SetSurfaceConnection(sphere->GetOutputPort());
  this->Filter->SetIsoValue(1e6); // no sample has this value; it only selects the material
  this->Filter->SetProxyRadius(1.0);
  EXPECT_LT(this->Deviation(this->Run(this->Turn->GetNumberOfPoints()), 1.0), 0.01);
  sphere->SetRadius(5.0);
  EXPECT_EQ(Get(this->Run(this->Turn->GetNumberOfPoints()), "Contact", 300), 0.0)
    << "it has shrunk";
}
