// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests measuring with keys where the hand touches a ball. Distances and angles are compared with
 * the geometry of a sphere, areas with that of a cap, and paths with the servo's states.
 */

#include "StyleRig.h"

#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticMeasurements.h>
#include <vtkPolyData.h>

using namespace scenetest;

namespace
{
constexpr double Pi = 3.14159265358979323846;

class StyleMeasure : public StyleTest
{
protected:
  StyleMeasure()
  {
    this->Style->SetMeasurements(this->List);
    this->Style->SetHeadUpDisplay(this->Display);
    this->Display->SetDevice(this->Device);
    this->Display->SetMeasurements(this->List);
  }
  void Push()
  {
    this->PushIn();
    this->Run(100);
    ASSERT_NE(this->Device->GetState()->GetContact(), 0);
  }
  /// Moves the mouse along x in steps of one pixel (0.2 mm).
  void Slide(int from, int to)
  {
    for (int x = from; x != to; x += from < to ? 1 : -1)
    {
      this->Pointer(x, 150);
      this->Run(4);
    }
    this->Pointer(to, 150);
    this->Run(200); // long enough for the proxy to rest
  }
  std::array<double, 3> Proxy()
  {
    const double* const p = this->Device->GetState()->GetProxyPosition();
    return { p[0], p[1], p[2] };
  }

  vtkNew<vtkHapticMeasurements> List;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};
} // namespace

TEST_F(StyleMeasure, APointIsWhereTheSurfaceHoldsTheProxy)
{
  this->Push();
  this->Press("1");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  double x[3];
  this->List->GetPoint(0, 0, x);
  const std::array<double, 3> proxy = this->Proxy();
  EXPECT_TRUE(std::equal(x, x + 3, proxy.begin()));
  EXPECT_GT(Length(x), Length(this->Device->GetState()->GetTipPosition()) + 1.0) << "not the tip";
  EXPECT_EQ(this->List->GetValue(0), this->Device->GetState()->GetSurfaceValue());
  EXPECT_NE(this->Display->GetText().find("Point 1"), std::string::npos);
}

TEST_F(StyleMeasure, ADistanceIsAChordAndAnAngleThatOfItsPoints)
{
  this->Push();
  this->Press("2");
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
  EXPECT_NE(this->Display->GetText().find("Distance: 1 of 2 points"), std::string::npos);
  const double radius = Length(this->Device->GetState()->GetProxyPosition());
  const double first = std::atan2(this->Proxy()[0], this->Proxy()[2]);
  this->Press("3");
  EXPECT_EQ(this->List->GetUnfinishedText(), "Angle: 1 of 3 points") << "takes the other's place";
  this->Press("2");
  this->Slide(150, 190);
  this->Press("2");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  EXPECT_EQ(this->List->GetUnfinishedText(), "");
  // Without friction, the proxy is at the ball's point nearest to the tip. The tip has moved 8 mm
  // sideways.
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double turn = std::atan2(tip[0], tip[2]) - first;
  EXPECT_GT(turn, 0.2);
  EXPECT_NEAR(this->List->GetValue(0), 2.0 * radius * std::sin(0.5 * turn), 0.05) << "voxels: 1 mm";

  // Euclid III.20: an angle at a point of a circle is half of the angle at the centre.
  this->Press("3");
  this->Slide(190, 150);
  this->Press("3");
  const double corner = std::atan2(this->Proxy()[0], this->Proxy()[2]);
  this->Slide(150, 110);
  this->Press("3");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 2);
  const double last = std::atan2(this->Proxy()[0], this->Proxy()[2]);
  const double centre = (first + turn) - last; // the arc that contains the corner
  EXPECT_LT(last, corner);
  EXPECT_NEAR(this->List->GetValue(1), 180.0 - 0.5 * centre * 180.0 / Pi, 0.5);
}

TEST_F(StyleMeasure, APathHasTheStatesOfTheServo)
{
  this->Push();
  std::vector<std::array<double, 7>> felt; // time, proxy, force
  this->Press("4");
  const auto see = [&felt](vtkTable* states, vtkIdType row)
  {
    const auto read = [&](const char* column, int component)
    {
      return vtkDataArray::SafeDownCast(states->GetColumnByName(column))
        ->GetComponent(row, component);
    };
    if (read("Contact", 0) != 0.0)
    {
      felt.push_back({ read("Time", 0), read("Proxy", 0), read("Proxy", 1), read("Proxy", 2),
        read("Force", 0), read("Force", 1), read("Force", 2) });
    }
  };
  for (int x = 151; x <= 180; ++x)
  {
    this->Pointer(x, 150);
    this->Run(5, see);
  }
  EXPECT_NE(this->Display->GetText().find("so far"), std::string::npos);
  this->Press("4");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  EXPECT_EQ(this->List->GetKind(0), vtkHapticMeasurements::PATH);
  vtkNew<vtkPolyData> shape;
  this->List->GetShape(0, shape);
  ASSERT_EQ(shape->GetNumberOfPoints(), static_cast<vtkIdType>(felt.size()));
  EXPECT_GT(felt.size(), 100u);
  vtkDataArray* const times = shape->GetPointData()->GetArray("Time");
  vtkDataArray* const forces = shape->GetPointData()->GetArray("Force");
  double length = 0.0;
  for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
  {
    const std::array<double, 7>& state = felt[static_cast<std::size_t>(i)];
    ASSERT_EQ(times->GetComponent(i, 0), state[0]);
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(shape->GetPoint(i)[c], state[static_cast<std::size_t>(1 + c)]);
      ASSERT_EQ(forces->GetComponent(i, c), state[static_cast<std::size_t>(4 + c)]);
    }
    const auto before = felt[static_cast<std::size_t>(std::max<vtkIdType>(i - 1, 0))];
    length += std::hypot(state[1] - before[1], state[2] - before[2], state[3] - before[3]);
  }
  EXPECT_NEAR(this->List->GetValue(0), length, 1e-9);

  this->List->SetPathSpacing(0.5);
  this->Press("4");
  this->Slide(180, 150);
  this->Press("Escape"); // ends the path, like a second L
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 2);
  this->List->GetShape(1, shape);
  EXPECT_GT(shape->GetNumberOfPoints(), 5);
  for (vtkIdType i = 1; i < shape->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    shape->GetPoint(i - 1, a);
    shape->GetPoint(i, b);
    EXPECT_GE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.5);
  }
}

TEST_F(StyleMeasure, AnAreaIsTheCapUnderTheBrush)
{
  this->Push();
  constexpr double brush = 6.0;
  this->List->SetBrushRadius(brush);
  this->Press("5");
  this->Run(50);
  this->Press("5");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  EXPECT_EQ(this->List->GetKind(0), vtkHapticMeasurements::AREA);
  // From any point of a sphere of any radius, a chord r bounds a cap with the area pi r^2: see
  // PaintedArea.
  EXPECT_NEAR(this->List->GetValue(0) / (Pi * brush * brush), 1.0, 0.25 / (brush * brush) + 0.01);

  // A stroke along a great circle of a sphere with the radius R paints a zone with the area 2 R
  // sin(half) L, and half a cap at each end. L is the length of the stroke, and `half` the half
  // angle of the brush.
  this->Press("5");
  this->Run(10);
  const double first = std::atan2(this->Proxy()[0], this->Proxy()[2]);
  this->Slide(150, 200);
  const double last = std::atan2(this->Proxy()[0], this->Proxy()[2]);
  this->Press("5");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 2);
  vtkNew<vtkPolyData> shape;
  this->List->GetShape(1, shape);
  const double radius = Length(shape->GetPoint(0)); // radius of the touched isosurface
  EXPECT_NEAR(radius, 30.0, 3.0);
  const double half = 2.0 * std::asin(0.5 * brush / radius);
  const double zone = 2.0 * radius * radius * std::sin(half) * (last - first);
  EXPECT_NEAR(this->List->GetValue(1) / (zone + Pi * brush * brush), 1.0, 0.02);
}

TEST_F(StyleMeasure, SurfaceProxyPaintsItsIsosurface)
{
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetIsoValue(0.0);
  this->Push();
  this->Press("5");
  this->Run(50);
  this->Press("5");
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
  vtkNew<vtkPolyData> shape;
  this->List->GetShape(0, shape);
  EXPECT_NEAR(Length(shape->GetPoint(0)), 30.0, 0.05);
  EXPECT_NEAR(this->List->GetValue(0) / (Pi * 16.0), 1.0, 0.25 / 16.0 + 0.01) << "four voxels";
}

TEST_F(StyleMeasure, NothingIsMeasuredInTheAir)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Run(20);
  for (const char* const key : { "1", "2", "3" })
  {
    this->Press(key);
    EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
    EXPECT_EQ(this->List->GetUnfinishedText(), "");
    EXPECT_NE(this->Display->GetText().find("Nothing is touched"), std::string::npos);
  }
  for (const char* const key : { "4", "5" })
  {
    this->Press(key);
    EXPECT_NE(this->Display->GetText().find("begins where you touch"), std::string::npos);
    this->Run(20);
    this->Press(key);
    EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
    EXPECT_EQ(this->Display->GetText().find("begins"), std::string::npos) << "nothing stays";
  }
}

TEST_F(StyleMeasure, ChangesAreUndone)
{
  this->Push();
  this->Press("1");
  this->Press("2");
  this->Press("Ctrl+z");
  EXPECT_EQ(this->List->GetUnfinishedText(), "") << "the point of the distance goes first";
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 1);
  this->Press("Ctrl+z");
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
  this->Press("Ctrl+y");
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 1);
  this->Press("Delete");
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
  this->Press("2");
  this->Press("Escape");
  EXPECT_EQ(this->List->GetUnfinishedText(), "");
  EXPECT_FALSE(this->Style->GetTouchMode());
}

TEST_F(StyleMeasure, KeysAreListedAndTheListIsHidden)
{
  EXPECT_NE(this->Style->GetKeys().find("a painted area"), std::string::npos);
  this->Push();
  this->Press("1");
  this->Press("i");
  EXPECT_EQ(this->Display->GetText().find("Point 1"), std::string::npos);
  this->Style->SetMeasurements(nullptr);
  EXPECT_EQ(this->Style->GetKeys().find("a painted area"), std::string::npos);
  this->Press("1");
  EXPECT_EQ(this->List->GetNumberOfMeasurements(), 1);
}
