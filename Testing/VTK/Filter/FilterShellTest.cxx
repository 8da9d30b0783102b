// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a shaped tool without a device: S2 and S3 of the design with the mesh of a ball, a tilted
 * box, the choice of solid values, paths with orientations, and invalid settings.
 */

#include "Rigs/ApiRig.h"

#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticPointShell.h>
#include <vtkMatrix3x3.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkQuaternion.h>
#include <vtkSphereSource.h>

#include <cmath>

using namespace apitest;

namespace
{
constexpr double Pi = 3.14159265358979323846;
/// Pressure per metre of depth (N/m^3): 500 N/m on 25 mm^2.
constexpr double Kappa = 2e7;
constexpr double Surface = 8.0; // z (mm) of the surface, where V = 800

class FilterShell : public ApiTest
{
protected:
  FilterShell()
  {
    this->Tool->SetSolidToAbove();
    this->Tool->SetContactValue(100.0 * Surface);
    this->Tool->SetMesh(MakeBall(3.0));
    this->Filter->SetTool(this->Tool);
  }

  static vtkSmartPointer<vtkPolyData> MakeBall(double radius)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(300);
    sphere->SetPhiResolution(150);
    sphere->Update();
    return sphere->GetOutput();
  }
  static vtkSmartPointer<vtkPolyData> MakeBox(double x, double y, double z)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(x);
    cube->SetYLength(y);
    cube->SetZLength(z);
    cube->Update();
    return cube->GetOutput();
  }

  /// Presses along z, and rests for 50 ticks. Returns the trace, whose last tick is `Last`.
  vtkPolyData* Press(
    double from, double to, const vtkQuaterniond& turn = vtkQuaterniond(1.0, 0.0, 0.0, 0.0))
  {
    std::vector<Point> points = Line({ 7, 7, from }, { 7, 7, to }, 100);
    points.insert(points.end(), 50, points.back());
    this->Path = MakePath(points);
    vtkNew<vtkDoubleArray> orientations;
    orientations->SetName("Orientation");
    orientations->SetNumberOfComponents(4);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      orientations->InsertNextTuple(turn.GetData());
    }
    this->Path->GetPointData()->AddArray(orientations);
    this->Filter->SetPathData(this->Path);
    this->Last = static_cast<vtkIdType>(points.size()) - 1;
    return this->Run(static_cast<vtkIdType>(points.size()));
  }

  vtkNew<vtkHapticPointShell> Tool;
  vtkIdType Last = 0;
};
} // namespace

/// Case S3, a ball with the radius a: the hand's spring holds the ball at the depth delta, where k
/// (2 mm - delta) = pi kappa a delta^2.
TEST_F(FilterShell, ABallHasItsForce)
{
  vtkPolyData* const trace = this->Press(4.0, 7.0);
  const double b = 500.0 / (Pi * Kappa * 3e-3);
  const double delta = 0.5 * (std::sqrt(b * b + 4.0 * b * 2e-3) - b);
  const double force = 500.0 * (2e-3 - delta);
  EXPECT_NEAR(Get(trace, "Force", this->Last, 2), -force, 0.01 * force);
  EXPECT_NEAR(Get(trace, "NormalForce", this->Last), force, 0.01 * force);
  EXPECT_NEAR(trace->GetPoint(this->Last)[2], 5.0 + 1e3 * delta, 0.01);
  EXPECT_EQ(Get(trace, "Contact", this->Last), 1.0);
  EXPECT_EQ(Get(trace, "Contact", 0), 0.0);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(Get(trace, "Torque", this->Last, c), 0.0, 2e-5);
  }
  EXPECT_NEAR(std::abs(Get(trace, "ToolOrientation", this->Last)), 1.0, 1e-6);
}

/// Case S2 with the hand's spring: at the depth d_c, the pressure reaches its bound P. Deeper down,
/// the force is pi kappa a d_c (2 delta - d_c).
TEST_F(FilterShell, TissueYieldsAtItsStrength)
{
  SetConstant(this->Property->GetSurfaceStrength(), 0.1);
  vtkPolyData* const trace = this->Press(4.0, 7.0);
  const double most = 0.1 / 25e-6 / Kappa;
  // The forces of spring and tissue are in balance: k (2 mm - delta) = pi kappa a d_c (2 delta -
  // d_c).
  const double slope = Pi * Kappa * 3e-3 * most;
  const double delta = (500.0 * 2e-3 + slope * most) / (500.0 + 2.0 * slope);
  ASSERT_GT(delta, most);
  const double force = 500.0 * (2e-3 - delta);
  EXPECT_NEAR(Get(trace, "Force", this->Last, 2), -force, 0.01 * force);
}

/// Case S4 with the hand's springs: the face (kappa b h^3/12) and the torsion spring k_r share the
/// angle in series. The press is only 0.01 mm deep, so that the sides of the box have little
/// effect.
TEST_F(FilterShell, ATiltedBoxGivesATorque)
{
  this->Tool->SetMesh(MakeBox(10.0, 10.0, 4.0));
  this->Tool->SetNumberOfPoints(10000);
  this->Tool->SetTurningStiffness(0.02);
  const double angle = 1e-3;
  vtkQuaterniond tilt;
  tilt.SetRotationAngleAndAxis(angle, 1.0, 0.0, 0.0);
  vtkPolyData* const trace = this->Press(5.9, 6.05, tilt);
  const double face = Kappa * 0.01 * 1e-6 / 12.0;
  const double torque = angle * face * 0.02 / (face + 0.02);
  EXPECT_NEAR(Get(trace, "Torque", this->Last, 0), -torque, 0.02 * torque);
  EXPECT_NEAR(Get(trace, "Force", this->Last, 2), -500.0 * 2000.0 / 2500.0 * 0.05e-3, 5e-4);
  // The tool rotates towards the face.
  const double left = 2.0 * Get(trace, "ToolOrientation", this->Last, 1);
  EXPECT_NEAR(left, angle * 0.02 / (face + 0.02), 0.03 * angle);
}

/// The hand rotates a box that rests on its face, and rotates it back. For small angles, the work
/// is K theta^2/2 with K = face k_r/(face + k_r), for the face and the torsion spring in series. If
/// the spring is much softer than the face, the work is its energy 2 k_r sin^2(theta/2).
TEST_F(FilterShell, EnergyHasTheWorkOfTheTorque)
{
  constexpr int steps = 200;
  constexpr int rest = 50;
  const double face = Kappa * 0.01 * 1e-6 / 12.0; // torsional stiffness of the face (case S4)
  this->Tool->SetMesh(MakeBox(10.0, 10.0, 4.0));
  this->Tool->SetNumberOfPoints(10000);
  const struct
  {
    double Angle;
    double Spring;
    double Work;
    double Tolerance;
  } cases[] = { { 1e-3, 0.02, 0.5 * 1e-6 * face * 0.02 / (face + 0.02), 0.03 },
    { 0.5, 1e-5, 2.0 * 1e-5 * std::pow(std::sin(0.25), 2), 0.01 } };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(one.Angle);
    this->Tool->SetTurningStiffness(one.Spring);
    std::vector<double> angles(100 + rest, 0.0);
    for (int i = 1; i <= steps; ++i)
    {
      angles.push_back(one.Angle * i / steps);
    }
    angles.insert(angles.end(), rest, one.Angle);
    for (int i = steps - 1; i >= 0; --i)
    {
      angles.push_back(one.Angle * i / steps);
    }
    angles.insert(angles.end(), rest, 0.0);
    std::vector<Point> points = Line({ 7, 7, 5.9 }, { 7, 7, 6.05 }, 100);
    points.resize(angles.size(), points.back());
    this->Path = MakePath(points);
    vtkNew<vtkDoubleArray> orientations;
    orientations->SetName("Orientation");
    orientations->SetNumberOfComponents(4);
    for (const double angle : angles)
    {
      vtkQuaterniond turn;
      turn.SetRotationAngleAndAxis(angle, 1.0, 0.0, 0.0);
      orientations->InsertNextTuple(turn.GetData());
    }
    this->Path->GetPointData()->AddArray(orientations);
    this->Filter->SetPathData(this->Path);
    vtkPolyData* const trace = this->Run(static_cast<vtkIdType>(points.size()));
    const double before = Get(trace, "Energy", 100 + rest - 1);
    const double turned = Get(trace, "Energy", 100 + 2 * rest + steps - 1);
    const double back = Get(trace, "Energy", static_cast<vtkIdType>(points.size()) - 1);
    EXPECT_LT(before, 0.0) << "the hand has pressed";
    EXPECT_NEAR(before - turned, one.Work, one.Tolerance * one.Work);
    EXPECT_NEAR(back, before, one.Tolerance * one.Work);
    EXPECT_LE(back, before + 1e-3 * one.Work) << "nothing is created";
  }
}

TEST_F(FilterShell, WhatIsSolidFollowsFromTheStrength)
{
  const vtkSmartPointer<vtkPolyData> wanted = [this]
  {
    this->Press(4.0, 7.0);
    return Keep(this->Filter);
  }();
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  this->Tool->SetSolidToFromStrength();
  strength->RemoveAllPoints();
  strength->AddPoint(700.0, 0.0);
  strength->AddPoint(900.0, 2.0);
  vtkPolyData* trace = this->Press(4.0, 7.0);
  EXPECT_NEAR(Get(trace, "Force", this->Last, 2), Get(wanted, "Force", this->Last, 2), 1e-3);
  // Make values below the surface value solid, so that the ball presses from the other side.
  strength->RemoveAllPoints();
  strength->AddPoint(700.0, 2.0);
  strength->AddPoint(900.0, 0.0);
  trace = this->Press(12.0, 9.0);
  EXPECT_NEAR(Get(trace, "Force", this->Last, 2), -Get(wanted, "Force", this->Last, 2), 0.01);
}

TEST_F(FilterShell, ATwoFoldStrengthNeedsAValue)
{
  this->Tool->SetSolidToFromStrength();
  this->ExpectError({ "vtkHapticPointShell", "what is solid", "nowhere", "SetContactValue()" });
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  strength->RemoveAllPoints();
  strength->AddPoint(500.0, 0.0);
  strength->AddPoint(700.0, 2.0);
  strength->AddPoint(900.0, 0.0);
  this->ExpectError({ "2 times", "SetSolidToAbove()" });
}

TEST_F(FilterShell, WhatCanNotBeFeltIsNamed)
{
  this->Tool->SetMesh(nullptr);
  this->ExpectError({ "mesh of the tool has no polygons", "SetMesh()" });
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  this->Tool->SetMesh(plane->GetOutput());
  this->ExpectError({ "is not closed", "4 of its 5 edges", "vtkFillHolesFilter" });
  this->Tool->SetMesh(MakeBall(1.0));
  this->Tool->SetNumberOfPoints(0);
  this->ExpectError({ "NumberOfPoints", "is 0", "SetNumberOfPoints()" });
  this->Tool->SetNumberOfPoints(1000000);
  this->ExpectError({ "NumberOfPoints", "is 1000000", "1 to 100000" });
  this->Tool->SetNumberOfPoints(200);
  this->Tool->SetContactArea(0.0);
  this->ExpectError({ "ContactArea", "more than 0", "SetContactArea()" });
  this->Tool->SetContactArea(25.0);
  this->Tool->SetCouplingStiffness(0.0);
  this->ExpectError({ "CouplingStiffness", "N/m", "more than 0" });
  this->Tool->SetCouplingStiffness(500.0);
  this->Tool->SetTurningStiffness(0.0);
  this->ExpectError({ "TurningStiffness", "N m/rad" });
  this->Tool->SetTurningStiffness(0.5);
  this->Tool->SetContactValue(std::nan(""));
  this->ExpectError({ "ContactValue", "not a finite number" });
  this->Tool->SetContactValue(800.0);
  this->Filter->SetMethodToForceField();
  this->ExpectError({ "vtkHapticPointShell", "PROXY", "SetTool(nullptr)" });
}

/// A single point with an area of 25 mm^2 must act like the point without a tool, so half of the
/// depth is in the material.
TEST_F(FilterShell, OnePointIsAPoint)
{
  this->Tool->SetMesh(MakeBox(std::sqrt(25.0 / 6.0), std::sqrt(25.0 / 6.0), std::sqrt(25.0 / 6.0)));
  this->Tool->SetNumberOfPoints(1);
  vtkPolyData* const trace = this->Press(5.0, 12.0);
  // The point may be anywhere on the box, up to 1.02 mm above or below the middle.
  const double force = -Get(trace, "Force", this->Last, 2);
  const double depth = 2e3 * force / 500.0; // depth of the hand (mm)
  EXPECT_NEAR(depth, 4.0, 1.03);
}

/// A change of an unrelated setting must preserve the points of the tool, because the mesh is the
/// same. So the trace must not change either.
TEST_F(FilterShell, IsTheSameEveryTime)
{
  const vtkQuaterniond turn(0.9, 0.1, 0.3, 0.2);
  this->Press(4.0, 7.0, turn.Normalized());
  const auto first = Keep(this->Filter);
  this->Tool->Modified();
  this->Press(4.0, 7.0, turn.Normalized());
  EXPECT_TRUE(IsSame(first, this->Filter->GetOutput()));
}

/// The forces must rotate with the data and the tool.
TEST_F(FilterShell, TurnsWithTheData)
{
  this->Tool->SetMesh(MakeBox(6.0, 4.0, 5.0));
  const vtkQuaterniond turn(0.3, -0.5, 0.2, 0.7);
  vtkPolyData* trace = this->Press(4.5, 7.0, turn.Normalized());
  const auto straight = Keep(this->Filter);
  ASSERT_GT(Get(straight, "NormalForce", this->Last), 0.2);
  vtkQuaterniond world;
  world.SetRotationAngleAndAxis(0.8, 0.6, 0.0, 0.8);
  double matrix[3][3];
  world.ToMatrix3x3(matrix);
  this->Image->SetDirectionMatrix(&matrix[0][0]);
  vtkDataArray* const orientations = this->Path->GetPointData()->GetArray("Orientation");
  for (vtkIdType i = 0; i < this->Path->GetNumberOfPoints(); ++i)
  {
    double x[3];
    vtkMath::Multiply3x3(matrix, this->Path->GetPoint(i), x);
    this->Path->GetPoints()->SetPoint(i, x);
    const vtkQuaterniond turned = world * turn.Normalized();
    orientations->SetTuple(i, turned.GetData());
  }
  this->Path->Modified();
  trace = this->Run(this->Last + 1);
  for (const char* const array : { "Force", "Torque" })
  {
    double before[3];
    straight->GetPointData()->GetArray(array)->GetTuple(this->Last, before);
    vtkMath::Multiply3x3(matrix, before, before);
    const double size = vtkMath::Norm(before);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(Get(trace, array, this->Last, c), before[c], 1e-3 * size + 1e-7) << array;
    }
  }
}
