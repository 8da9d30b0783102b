// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the points with areas that are made from a mesh: the sum of their areas, their distances,
 * the design's forces in closed form, and meshes that are unsuitable as tools.
 */

#include "VTK/Tools/ShellSampler.h"
#include "Core/Tools/PointShell/ShellContacts.h"
#include "Rigs/ShellRig.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkDiskSource.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace coretest;

namespace
{
std::vector<ShellPoint> Sample(vtkPolyData* mesh, std::size_t count)
{
  std::vector<ToolTriangle> triangles;
  std::string error;
  EXPECT_TRUE(ReadToolMesh(mesh, triangles, error)) << error;
  return triangles.empty() ? std::vector<ShellPoint>{} : SpreadShellPoints(triangles, count);
}

double AreaOf(const std::vector<ShellPoint>& points)
{
  double area = 0.0;
  for (const ShellPoint& point : points)
  {
    area += point.Area;
  }
  return area;
}

void ExpectRefused(vtkPolyData* mesh, const std::string& text)
{
  std::vector<ToolTriangle> triangles(3);
  std::string error;
  EXPECT_FALSE(ReadToolMesh(mesh, triangles, error));
  EXPECT_NE(error.find(text), std::string::npos) << error;
  EXPECT_NE(error.find("mesh of the tool"), std::string::npos) << error;
  EXPECT_TRUE(triangles.empty());
}

/// Makes a ball with long thin triangles at its poles.
vtkSmartPointer<vtkPolyData> MakeBall(double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution / 2);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeBox(double x, double y, double z)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(x);
  cube->SetYLength(y);
  cube->SetZLength(z);
  cube->Update();
  return cube->GetOutput();
}

/// Tests forces on the points of a mesh (mm) in the ramp, whose surface is at 10 mm.
class MeshForces : public testing::Test
{
protected:
  MeshForces()
  {
    this->Settings.Level = 1000.0;
    this->Settings.Scale = 1e-3;
  }

  ShellSum Lower(
    const PointShell& shell, const Vector3& from, double way, const Quaternion& turn) const
  {
    const ShellContactFinder finder(this->Model, shell, this->Settings);
    ShellContacts contacts[2] = { ShellContacts(shell.GetSize()), ShellContacts(shell.GetSize()) };
    ShellClearance clearance(shell.GetBlocks().size());
    ShellSum sum;
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i)
    {
      const Vector3 at = from + Vector3{ 0.0, 0.0, way * i / steps };
      clearance.Reset();
      finder.Collect(
        { 0.001 * at, turn }, 0.0, false, contacts[i % 2], contacts[1 - i % 2], clearance, sum);
    }
    return sum;
  }

  const TestVolume Volume = MakeRamp();
  const HapticModel Model{ Describe(this->Volume) };
  ShellSettings Settings;
};
} // namespace

/// The sum of the areas must equal VTK's area of the mesh.
TEST(ShellSampler, TheAreasSumToThatOfTheMesh)
{
  const vtkSmartPointer<vtkPolyData> ball = MakeBall(5.0, 100);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(ball);
  for (const std::size_t count : { 1, 7, 300, 4000 })
  {
    const std::vector<ShellPoint> points = Sample(ball, count);
    EXPECT_EQ(points.size(), count);
    EXPECT_NEAR(AreaOf(points), mass->GetSurfaceArea(), 1e-9 * mass->GetSurfaceArea());
  }
}

/// Neighbours in a lattice of equilateral triangles are sqrt(2/sqrt(3) area) apart.
TEST(ShellSampler, ThePointsAreSpreadEvenly)
{
  constexpr std::size_t count = 2000;
  const std::vector<ShellPoint> points = Sample(MakeBall(5.0, 200), count);
  const double area = AreaOf(points) / count;
  const double best = std::sqrt(2.0 / std::sqrt(3.0) * area);
  double sum = 0.0;
  double least = best;
  for (const ShellPoint& point : points)
  {
    double nearest = std::numeric_limits<double>::max();
    for (const ShellPoint& other : points)
    {
      nearest =
        &other != &point ? std::min(nearest, Norm(point.Position - other.Position)) : nearest;
    }
    sum += nearest;
    least = std::min(least, nearest);
    EXPECT_LE(point.Area, 1.6 * area);
    EXPECT_GE(point.Area, 0.5 * area);
    EXPECT_NEAR(Norm(point.Position), 5.0, 0.02) << "on the surface";
  }
  EXPECT_GE(sum / count, 0.8 * best) << "random points would have 0.47";
  EXPECT_GE(least, 0.55 * best);
}

/// Case S1 of the design: a sphere of 5 mm, 1 mm deep in a half-space, has the force pi kappa a
/// delta^2 = 0.3142 N.
TEST_F(MeshForces, ASphereHasItsForce)
{
  const PointShell shell(Sample(MakeBall(5.0, 600), 10000));
  const double expected = Pi * Kappa * 5e-3 * 1e-6;
  std::mt19937_64 engine(11);
  for (int i = 0; i < 50; ++i)
  {
    const ShellSum sum = this->Lower(shell, { 11.3, 12.1, 5.0 }, 1.0, RandomTurn(engine));
    EXPECT_NEAR(sum.Gradient[2], expected, 0.001 * expected) << i;
    EXPECT_LE(std::hypot(sum.Gradient[0], sum.Gradient[1]), 0.001 * expected);
  }
}

/// Case S4 of the design: the force on the face of a box is kappa times its area times the depth.
/// Tilted by theta, the face has the torque kappa b h^3/12 theta about its middle. At this small
/// depth, the sides of the box add at most 0.2 % to the force and 0.8 % to the torque.
TEST_F(MeshForces, AFaceOfABoxHasItsForceAndTorque)
{
  const PointShell shell(Sample(MakeBox(10.0, 10.0, 6.0), 4000));
  const Vector3 above{ 12.2, 11.9, 6.91 };
  const ShellSum flat = this->Lower(shell, above, 0.1, {});
  EXPECT_NEAR(flat.Gradient[2], 0.02, 0.02e-2);
  const ShellSum tilted = this->Lower(shell, above, 0.1, TurnAbout({ 1.0, 0.0, 0.0 }, 1e-3));
  const double torque = Kappa * 0.01 * 1e-6 / 12.0 * 1e-3;
  EXPECT_NEAR(torque, 1.667e-5, 1e-8);
  EXPECT_NEAR(tilted.Gradient[2], 0.02, 0.02e-2);
  EXPECT_NEAR(tilted.Gradient[3] - flat.Gradient[3], torque, 0.01 * torque);
}

/// Each side of a blade must have separate points, with half of the area.
TEST(ShellSampler, AThinBladeHasPointsOnBothSides)
{
  const std::vector<ShellPoint> points = Sample(MakeBox(10.0, 10.0, 0.01), 400);
  double areas[2] = {};
  int rim = 0;
  for (const ShellPoint& point : points)
  {
    areas[point.Position.Z > 0.0 ? 1 : 0] += point.Area;
    EXPECT_LE(std::abs(point.Position.Z), 0.005 * (1.0 + 1e-6));
    rim += std::abs(point.Position.Z) < 0.005 * (1.0 - 1e-6) ? 1 : 0;
  }
  EXPECT_LE(rim, 10) << "0.4 of 200.4 mm^2 are the rim";
  EXPECT_NEAR(areas[0], 100.2, 0.5);
  EXPECT_NEAR(areas[1], 100.2, 0.5);
}

/// Moments of a cube's surface in closed form: the integral of z^2 is 5/6 a^4.
TEST(ShellSampler, SumsOverPointsAreIntegrals)
{
  const std::vector<ShellPoint> points = Sample(MakeBox(2.0, 2.0, 2.0), 6000);
  EXPECT_NEAR(AreaOf(points), 24.0, 1e-9);
  double square = 0.0;
  Vector3 first;
  for (const ShellPoint& point : points)
  {
    square += point.Area * point.Position.Z * point.Position.Z;
    first += point.Area * point.Position;
  }
  EXPECT_NEAR(square, 5.0 / 6.0 * 16.0, 0.003 * 5.0 / 6.0 * 16.0);
  EXPECT_LE(Norm(first), 0.01) << "its middle is the origin";
}

TEST(ShellSampler, IsTheSameEveryTime)
{
  const vtkSmartPointer<vtkPolyData> ball = MakeBall(2.0, 40);
  const std::vector<ShellPoint> first = Sample(ball, 500);
  const std::vector<ShellPoint> second = Sample(ball, 500);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_TRUE(IsIdentical(first[i].Position, second[i].Position));
    EXPECT_EQ(first[i].Area, second[i].Area);
  }
}

TEST(ToolMesh, ThatIsNoToolIsRefused)
{
  ExpectRefused(nullptr, "has no polygons");
  vtkNew<vtkPolyData> empty;
  ExpectRefused(empty, "has no polygons");
  const vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 20);
  vtkNew<vtkDiskSource> disk;
  disk->Update();
  ExpectRefused(disk->GetOutput(), "is not closed");
  vtkNew<vtkReverseSense> inverted;
  inverted->SetInputData(ball);
  inverted->ReverseCellsOn();
  inverted->Update();
  ExpectRefused(inverted->GetOutput(), "is inside out");
  // Reverse one triangle of the ball.
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(ball);
  turned->BuildCells();
  turned->ReverseCell(7);
  ExpectRefused(turned, "face opposite sides, at 3 of");
  // Remove one triangle of the ball.
  vtkNew<vtkPolyData> open;
  open->DeepCopy(ball);
  open->BuildCells();
  open->DeleteCell(7);
  open->RemoveDeletedCells();
  ExpectRefused(open, "3 of its");
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(ball);
  broken->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  ExpectRefused(broken, "number 5");
  vtkNew<vtkPolyData> flat;
  flat->DeepCopy(ball);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    const double* const x = ball->GetPoint(i);
    flat->GetPoints()->SetPoint(i, 1.0, 2.0, x[2]);
  }
  ExpectRefused(flat, "has no triangle with an area");
  vtkNew<vtkPolyData> missing;
  missing->DeepCopy(ball);
  const vtkIdType ids[3] = { 0, 1, 1000000 };
  missing->GetPolys()->InsertNextCell(3, ids);
  ExpectRefused(missing, "a polygon with the point 1000000");
}

/// The corners of triangles may be separate points, as in STL files.
TEST(ToolMesh, TrianglesNeedNotShareTheirCorners)
{
  const vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 20);
  vtkNew<vtkPolyData> loose;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> cells;
  for (vtkIdType c = 0; c < ball->GetNumberOfCells(); ++c)
  {
    vtkIdType ids[3];
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = points->InsertNextPoint(ball->GetPoint(ball->GetCell(c)->GetPointId(i)));
    }
    cells->InsertNextCell(3, ids);
  }
  loose->SetPoints(points);
  loose->SetPolys(cells);
  EXPECT_NEAR(AreaOf(Sample(loose, 100)), AreaOf(Sample(ball, 100)), 1e-5);
}
