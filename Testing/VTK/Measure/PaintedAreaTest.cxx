// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests areas that a brush paints against closed forms. A dab on a plane or a sphere covers pi r^2
 * (on a sphere, the cap within a chord of r). A straight stroke on a plane covers 2 r L + pi r^2.
 * The border is a polygon with a corner on each edge of the surface's triangles. Edges are at most
 * as long as the diagonal of a voxel h, so the relative error of an area is at most (h / r)^2 / 4:
 * 1.6 % for a radius of four voxels, 0.4 % for a radius of eight.
 */

#include "MeasureRig.h"

#include <vtkImageData.h>
#include <vtkMassProperties.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>

#include <functional>

using namespace measuretest;

namespace
{

/// Returns the largest relative error of a painted area, for a brush radius in voxels.
double Bound(double radius)
{
  return 0.25 / (radius * radius);
}

/// Makes an image with 61 voxels of 1 mm along each axis, around the origin.
vtkSmartPointer<vtkImageData> Sample(const std::function<double(const Point&)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(61, 61, 61);
  image->SetOrigin(-30.0, -30.0, -30.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    image->GetPointData()->GetScalars()->SetTuple1(i, value({ x[0], x[1], x[2] }));
  }
  return image;
}

double Length(const Point& x)
{
  return std::hypot(x[0], x[1], x[2]);
}

/// Makes an image whose value is the depth (mm) below the surface of a sphere, and negative
/// outside.
vtkSmartPointer<vtkImageData> MakeSphere(double radius)
{
  return Sample([radius](const Point& x) { return radius - Length(x); });
}

class PaintedArea : public MeasureTest
{
protected:
  double Paint(vtkImageData* image, const std::vector<Point>& path, double radius)
  {
    const vtkIdType area = this->List->AddPaintedArea(image, 0.0, MakeFelt(path), radius);
    return area < 0 ? -1.0 : this->List->GetValue(area);
  }
};
} // namespace

TEST_F(PaintedArea, ADabOnAPlaneIsADisc)
{
  // The plane is oblique, so that it cuts voxels in all ways.
  const auto plane =
    Sample([](const Point& x) { return (x[0] + 2.0 * x[1] + 3.0 * x[2] - 0.3) / std::sqrt(14.0); });
  for (const double radius : { 4.0, 8.0 })
  {
    const double area = this->Paint(plane, { { 0.1, 0.2, 0.3 } }, radius);
    EXPECT_NEAR(area / (vtkMath::Pi() * radius * radius), 1.0, Bound(radius)) << radius;
  }
}

TEST_F(PaintedArea, AStrokeOnAPlaneIsAStadium)
{
  const auto plane = Sample([](const Point& x) { return 0.25 - x[2]; });
  // The path runs 1.25 mm in front of the plane.
  std::vector<Point> path = Line({ -15.0, 3.0, 1.5 }, { 15.0, 3.0, 1.5 }, 300);
  EXPECT_NEAR(this->Paint(plane, path, 5.0) / (300.0 + 25.0 * vtkMath::Pi()), 1.0, Bound(5.0));
  // A second stroke over the same place must not add area.
  const std::vector<Point> back = Line({ 15.0, 3.0, 1.5 }, { -15.0, 3.0, 1.5 }, 7);
  path.insert(path.end(), back.begin(), back.end());
  EXPECT_NEAR(this->Paint(plane, path, 5.0) / (300.0 + 25.0 * vtkMath::Pi()), 1.0, Bound(5.0));
}

TEST_F(PaintedArea, ADabOnASphereIsTheCapWithinAChord)
{
  const auto sphere = MakeSphere(20.0);
  for (const Point& direction : { Point{ 0.0, 0.0, 1.0 }, Point{ 0.36, 0.48, 0.8 } })
  {
    const Point at = { 21.5 * direction[0], 21.5 * direction[1], 21.5 * direction[2] };
    const double area = this->Paint(sphere, { at }, 6.0);
    EXPECT_NEAR(area / (vtkMath::Pi() * 36.0), 1.0, Bound(6.0));
  }
}

TEST_F(PaintedArea, ABrushThatCoversASphereHasAllOfIt)
{
  // The triangles are inside the sphere, and in total lack up to (h / R)^2 / 2 of the area for both
  // of their directions.
  EXPECT_NEAR(
    this->Paint(MakeSphere(8.0), { { 0.0, 0.0, 9.0 } }, 20.0) / (4.0 * vtkMath::Pi() * 64.0), 1.0,
    0.5 / 64.0);
  vtkNew<vtkPolyData> shape;
  this->List->GetShape(0, shape);
  vtkNew<vtkMassProperties> vtks;
  vtks->SetInputData(shape);
  EXPECT_NEAR(vtks->GetSurfaceArea(), this->List->GetValue(0), 1e-3);
  EXPECT_NEAR(vtks->GetVolume() / (4.0 / 3.0 * vtkMath::Pi() * 512.0), 1.0, 0.02) << "it is closed";
}

TEST_F(PaintedArea, TheOtherSideOfAThinWallIsNotPainted)
{
  const auto wall = Sample([](const Point& x) { return 2.0 - std::abs(x[2]); }); // 4 mm thick
  EXPECT_NEAR(
    this->Paint(wall, { { 0.3, 0.4, 2.5 } }, 8.0) / (vtkMath::Pi() * 64.0), 1.0, Bound(8.0));
}

TEST_F(PaintedArea, PartsWithoutSurfaceBetweenThemAreNotJoined)
{
  const auto plane = Sample([](const Point& x) { return 0.25 - x[2]; });
  // The brush is raised by 20 mm between the two dabs.
  const double area = this->Paint(plane,
    { { -15.0, 0.0, 1.0 }, { -5.0, 0.0, 20.0 }, { 5.0, 0.0, 20.0 }, { 15.0, 0.0, 1.0 } }, 4.0);
  EXPECT_NEAR(area / (2.0 * vtkMath::Pi() * 16.0), 1.0, Bound(4.0));
}

TEST_F(PaintedArea, ImagesMayBeTurnedAndStretched)
{
  const auto image = Sample([](const Point& x) { return 0.25 - x[2]; });
  vtkNew<vtkMatrix3x3> turn; // the image's z axis becomes the world's x axis
  const double rows[9] = { 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
  turn->DeepCopy(rows);
  image->SetDirectionMatrix(turn);
  image->SetSpacing(0.5, 0.8, 0.4);
  image->SetOrigin(100.0, -15.0, -24.0);
  // The plane is at the index 30.25 along z, which is x = 100 + 0.4 * 30.25 in the world.
  const double area = this->Paint(image, { { 112.1, 0.2, -0.3 } }, 4.0);
  EXPECT_NEAR(area / (vtkMath::Pi() * 16.0), 1.0, Bound(5.0)) << "voxels of 0.8 mm at most";
  vtkNew<vtkPolyData> shape;
  this->List->GetShape(0, shape);
  EXPECT_NEAR(shape->GetBounds()[0], 112.1, 1e-5);
  EXPECT_NEAR(shape->GetBounds()[1], 112.1, 1e-5);
}

TEST_F(PaintedArea, WhereThereIsNothingToPaintIsAnError)
{
  const auto sphere = MakeSphere(10.0);
  EXPECT_EQ(this->Paint(sphere, { { 0.0, 0.0, 25.0 } }, 4.0), -1.0);
  this->ExpectError({ "isosurface at 0", "radius (4)" });
  EXPECT_EQ(this->Paint(sphere, { { 0.0, 0.0, 10.0 } }, 0.0), -1.0);
  this->ExpectError({ "radius" });
  EXPECT_EQ(this->Paint(nullptr, { { 0.0, 0.0, 10.0 } }, 4.0), -1.0);
  this->ExpectError({ "image", "scalars" });
}
