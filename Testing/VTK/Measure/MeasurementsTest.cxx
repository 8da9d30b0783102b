// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the values of measurements on a sphere against closed forms of elementary geometry, and the
 * list of measurements.
 */

#include "MeasureRig.h"
#include "Rigs/SettingChecks.h"
#include "VTK/Measure/HapticMeasurementSettings.h"

#include <vtkMassProperties.h>
#include <vtkMath.h>
#include <vtkSphereSource.h>

using namespace measuretest;

namespace
{
constexpr double Radius = 40.0; // mm, of the sphere

/// Returns the point on a sphere around (10, -20, 30) at these angles in degrees.
Point OnSphere(double longitude, double latitude)
{
  const double u = longitude * vtkMath::Pi() / 180.0;
  const double v = latitude * vtkMath::Pi() / 180.0;
  return { 10.0 + Radius * std::cos(u) * std::cos(v), -20.0 + Radius * std::sin(u) * std::cos(v),
    30.0 + Radius * std::sin(v) };
}
} // namespace

TEST_F(MeasureTest, ADistanceOnASphereIsItsChord)
{
  for (const double angle : { 1e-6, 10.0, 60.0, 90.0, 180.0 })
  {
    const vtkIdType i =
      this->List->AddDistance(OnSphere(0.0, 20.0).data(), OnSphere(0.0, 20.0 + angle).data());
    EXPECT_NEAR(
      this->List->GetValue(i), 2.0 * Radius * std::sin(angle * vtkMath::Pi() / 360.0), 1e-12);
    EXPECT_EQ(this->List->GetUnit(i), "mm");
  }
}

TEST_F(MeasureTest, AnAngleOnACircleIsHalfOfThatAtItsCentre)
{
  // Euclid III.20: an inscribed angle is half of the central angle. Over a diameter, it is a right
  // angle.
  for (const double arc : { 20.0, 90.0, 180.0, 300.0 })
  {
    const vtkIdType i = this->List->AddAngle(
      OnSphere(0.0, 0.0).data(), OnSphere(330.0, 0.0).data(), OnSphere(arc, 0.0).data());
    EXPECT_NEAR(this->List->GetValue(i), 0.5 * arc, 1e-10);
    EXPECT_EQ(this->List->GetUnit(i), "deg");
  }
  const double a[3] = { 0.0, 0.0, 0.0 };
  const double b[3] = { 1.0, 0.0, 0.0 };
  const double c[3] = { 2.0, 1e-9, 0.0 };
  const vtkIdType flat = this->List->AddAngle(a, b, c);
  EXPECT_NEAR(180.0 - this->List->GetValue(flat), 1e-9 * 180.0 / vtkMath::Pi(), 1e-13)
    << "not lost in cos";
}

TEST_F(MeasureTest, APathAroundACircleIsAsLongAsItsPolygon)
{
  constexpr int sides = 360;
  std::vector<Point> circle;
  for (int i = 0; i <= sides; ++i)
  {
    circle.push_back(OnSphere(360.0 * i / sides, 30.0));
  }
  const vtkIdType path =
    this->List->AddMeasurement(vtkHapticMeasurements::PATH, MakeFelt(circle), "Round");
  const double around = Radius * std::cos(vtkMath::Pi() / 6.0);
  EXPECT_NEAR(
    this->List->GetValue(path), 2.0 * sides * around * std::sin(vtkMath::Pi() / sides), 1e-10);
  EXPECT_EQ(this->List->GetNumberOfPoints(path), sides + 1);
  vtkNew<vtkPolyData> shape;
  this->List->GetShape(path, shape);
  EXPECT_EQ(shape->GetNumberOfLines(), 1);
  for (const char* const name : { "Time", "Force", "SurfaceValue" })
  {
    ExpectSameArray(shape, MakeFelt(circle), name);
  }
}

TEST_F(MeasureTest, AnAreaIsThatOfVtk)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(Radius);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->SetEndPhi(70.0); // leaves a cap
  sphere->Update();
  vtkNew<vtkMassProperties> vtks;
  vtks->SetInputConnection(sphere->GetOutputPort());
  const vtkIdType area =
    this->List->AddMeasurement(vtkHapticMeasurements::AREA, sphere->GetOutput());
  EXPECT_NEAR(this->List->GetValue(area), vtks->GetSurfaceArea(), 1e-3);
  const double cap =
    2.0 * vtkMath::Pi() * Radius * Radius * (1.0 - std::cos(70.0 * vtkMath::Pi() / 180.0));
  EXPECT_NEAR(this->List->GetValue(area), cap, 2e-3 * cap);
  EXPECT_EQ(this->List->GetUnit(area), "mm2");
}

TEST_F(MeasureTest, APointHasTheValueThatWasFeltThere)
{
  EXPECT_EQ(this->List->AddPoint(OnSphere(1.0, 2.0).data()), 0);
  EXPECT_TRUE(std::isnan(this->List->GetValue(0)));
  EXPECT_EQ(this->List->GetText(0), "Point 1");
  this->List->AddMeasurement(
    vtkHapticMeasurements::POINT, MakeFelt({ OnSphere(3.0, 4.0) }), "Nasion");
  EXPECT_EQ(this->List->GetValue(1), 53.0);
  EXPECT_EQ(this->List->GetText(1), "Nasion: value 53.0");
}

TEST_F(MeasureTest, LengthsHaveTheUnitOfTheWorld)
{
  const double a[3] = { 0.0, 0.0, 0.0 };
  const double b[3] = { 0.0, 0.0, 2.5 };
  this->List->AddDistance(a, b, "d");
  EXPECT_EQ(this->List->GetText(0), "d: 2.50 mm");
  this->List->SetMetersPerWorldUnit(0.01);
  EXPECT_EQ(this->List->GetText(0), "d: 2.50 cm");
  this->List->SetMetersPerWorldUnit(1e-6);
  EXPECT_EQ(this->List->GetUnit(0), "um");
  EXPECT_EQ(this->List->GetText(0), "d: 2.50 \xC2\xB5m");
  this->List->SetMetersPerWorldUnit(0.0254); // inches are not in the list of units
  EXPECT_NEAR(this->List->GetValue(0), 63.5, 1e-12);
  EXPECT_EQ(this->List->GetText(0), "d: 63.5 mm");
}

TEST_F(MeasureTest, NamesAreFreeOnesAndCanBeChanged)
{
  const double a[3] = { 0.0, 0.0, 0.0 };
  this->List->AddPoint(a);
  this->List->AddPoint(a, "Point 3");
  this->List->AddPoint(a);
  this->List->AddPoint(a);
  EXPECT_EQ(this->List->GetName(2), "Point 2");
  EXPECT_EQ(this->List->GetName(3), "Point 4");
  EXPECT_TRUE(this->List->SetName(3, "apex\nof the heart"));
  EXPECT_EQ(this->List->GetName(3), "apex of the heart");
}

TEST_F(MeasureTest, ChangesAreUndoneAndDoneAgain)
{
  const double a[3] = { 0.0, 0.0, 0.0 };
  EXPECT_FALSE(this->List->Undo());
  this->List->AddPoint(a, "a");
  this->List->AddPoint(a, "b");
  this->List->SetName(0, "c");
  this->List->Remove(0);
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  EXPECT_TRUE(this->List->Undo());
  EXPECT_EQ(this->List->GetName(0), "c");
  EXPECT_TRUE(this->List->Undo());
  EXPECT_EQ(this->List->GetName(0), "a");
  EXPECT_TRUE(this->List->Redo());
  EXPECT_EQ(this->List->GetName(0), "c");
  this->List->AddPoint(a, "d");
  EXPECT_FALSE(this->List->Redo()) << "a new change takes the place of those undone";
  this->List->RemoveAll();
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
  const vtkMTimeType time = this->List->GetMTime();
  EXPECT_TRUE(this->List->Undo());
  EXPECT_GT(this->List->GetMTime(), time);
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 3);
}

TEST_F(MeasureTest, WhatCannotBeMeasuredIsRefused)
{
  const double nan[3] = { 0.0, vtkMath::Nan(), 0.0 };
  EXPECT_EQ(this->List->AddPoint(nan), -1);
  this->ExpectError({ "NaN", "finite" });
  using M = vtkHapticMeasurements;
  EXPECT_EQ(this->List->AddMeasurement(M::ANGLE, MakeFelt({ { 0, 0, 0 } })), -1);
  this->ExpectError({ "1 point.", "An Angle needs 3" });
  EXPECT_EQ(this->List->AddMeasurement(M::PATH, MakeFelt({})), -1);
  this->ExpectError({ "0 points", "A Path needs at least 1" });
  EXPECT_EQ(this->List->AddMeasurement(M::AREA, MakeFelt({ { 0, 0, 0 } })), -1);
  this->ExpectError({ "An Area needs triangles" });
  EXPECT_EQ(this->List->AddMeasurement(7, MakeFelt({ { 0, 0, 0 } })), -1);
  this->ExpectError({ "kind", "7" });
  EXPECT_EQ(this->List->AddMeasurement(M::POINT, nullptr), -1);
  this->ExpectError({ "vtkPolyData" });
  EXPECT_EQ(this->List->GetValue(0), 0.0);
  this->ExpectError({ "no measurement 0" });
  double x[3] = { 0.0, 0.0, 0.0 };
  this->List->AddPoint(x);
  this->List->GetPoint(0, 1, x);
  this->ExpectError({ "no point 1" });
}

TEST(MeasurementSettingList, TheHeaderSaysTheSame)
{
  using namespace settingtest;
  ExpectHeadersBehave<vtkHapticMeasurements>(VolumeHaptics::MeasurementSettings);
  ExpectRows("vtkHapticMeasurements", Names(VolumeHaptics::MeasurementSettings));
  ExpectComments("vtkHapticMeasurements", VolumeHaptics::MeasurementSettings);
}
