// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the measured width of a ball, between proxies that touch it from two sides, against its
 * diameter. The ball resembles water in a CT scan: a step of Hounsfield units, blurred by a point
 * spread function. An evenly blurred step has half of its height where the step was.
 */

#include "MeasureRig.h"

using namespace measuretest;

namespace
{
constexpr double BallRadius = 30.0; // radius (mm) in voxels of 1 mm

vtkSmartPointer<vtkImageData> ScanBall()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(81, 81, 81);
  image->SetOrigin(-40.0, -40.0, -40.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double out = std::hypot(x[0], x[1], x[2]) - BallRadius;
    image->GetPointData()->GetScalars()->SetTuple1(
      i, -1000.0 + 1040.0 / (1.0 + std::exp(out / 0.7)));
  }
  return image;
}

class Width : public MeasureTest
{
protected:
  Width()
  {
    this->Filter->SetInputData(0, ScanBall());
    this->Filter->GetProperty()->ApplyPreset("CT contrast");
  }
  /// Returns the position of the proxy after the tip has come from `direction` to 1 mm inside the
  /// ball.
  Point Touch(const Point& direction)
  {
    const auto at = [&direction](double r) {
      return Point{ r * direction[0], r * direction[1], r * direction[2] };
    };
    this->Filter->SetPathData(MakePath(Line(at(38.0), at(BallRadius - 1.0), 900)));
    this->Filter->Update();
    vtkPolyData* const trace = this->Filter->GetOutput();
    const vtkIdType last = trace->GetNumberOfPoints() - 1;
    EXPECT_NE(Get(trace, "Contact", last), 0.0);
    Point proxy;
    trace->GetPoint(last, proxy.data());
    return proxy;
  }
  double MeasureAcross(const Point& direction)
  {
    const Point a = this->Touch(direction);
    const Point b = this->Touch({ -direction[0], -direction[1], -direction[2] });
    return this->List->GetValue(this->List->AddDistance(a.data(), b.data()));
  }

  vtkNew<vtkVolumeHapticsFilter> Filter;
};
} // namespace

TEST_F(Width, PreciseRestsHalfwayUpTheEdge)
{
  for (const Point& direction : { Point{ 0.0, 1.0, 0.0 }, Point{ 0.48, 0.6, 0.64 } })
  {
    EXPECT_NEAR(this->MeasureAcross(direction), 2.0 * BallRadius, 0.2)
      << "a tenth of a voxel a side";
  }
}

TEST_F(Width, SurfaceProxyRestsItsRadiusInFrontOfTheIsosurface)
{
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(-480.0); // HU, halfway between air and water
  for (const double radius : { 0.0, 2.0 })
  {
    this->Filter->SetProxyRadius(radius);
    const double gap = radius > 0.0 ? radius : 0.5; // half a voxel by default
    for (const Point& direction : { Point{ 0.0, 1.0, 0.0 }, Point{ 0.48, 0.6, 0.64 } })
    {
      EXPECT_NEAR(this->MeasureAcross(direction), 2.0 * (BallRadius + gap), 0.1) << "of triangles";
    }
  }
}
