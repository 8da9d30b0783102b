// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The modes of the method PRIMITIVES through the filter. Forces are those of closed forms: with a
 * spring k, a line that holds with S and a tip at the distance d from it, min(k d, S) towards it.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/TimeSource.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkHapticGuideMode.h>
#include <vtkHapticRidgeMode.h>
#include <vtkHapticShearMode.h>
#include <vtkHapticSurfaceMode.h>
#include <vtkHapticTensorFollowMode.h>
#include <vtkHapticVectorFollowMode.h>
#include <vtkHapticVectorFrontMode.h>
#include <vtkHapticVortexMode.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>

#include <cmath>
#include <limits>

using namespace apitest;

namespace
{
constexpr double SpringOf = 500.0;  // N/m
constexpr double SpringPerMm = 0.5; // N/mm
constexpr double Middle = 11.5;     // of 24 voxels

class FilterModes : public ApiTest
{
protected:
  FilterModes()
  {
    this->Image = MakeImage(24, VTK_DOUBLE, [](const Point& p) { return 100.0 * p[2]; });
    this->Filter->SetInputData(this->Image);
    this->Filter->SetMethodToPrimitives();
  }

  /// A point array of the image.
  template <typename F>
  vtkSmartPointer<vtkDoubleArray> AddArray(const char* name, int components, F&& f)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
    {
      Point p;
      this->Image->GetPoint(i, p.data());
      f(p, array->GetPointer(components * i));
    }
    this->Image->GetPointData()->AddArray(array);
    return array;
  }
  /// The flow v = (x - 11.5) turned by 90 degrees around z: circles.
  void AddCircles()
  {
    this->AddArray("flow", 3,
      [](const Point& p, double* v)
      {
        v[0] = Middle - p[1];
        v[1] = p[0] - Middle;
        v[2] = 0.0;
      });
  }

  void Follow(const std::vector<Point>& points) { this->Filter->SetPathData(MakePath(points)); }

  /// Of the last tick.
  static Point Last(vtkPolyData* trace, const char* array)
  {
    const vtkIdType tick = trace->GetNumberOfPoints() - 1;
    return { Get(trace, array, tick, 0), Get(trace, array, tick, 1), Get(trace, array, tick, 2) };
  }
  static Point LastProxy(vtkPolyData* trace)
  {
    Point p;
    trace->GetPoint(trace->GetNumberOfPoints() - 1, p.data());
    return p;
  }
  static void ExpectNear(const Point& a, const Point& b, double tolerance)
  {
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
    }
  }
};

template <typename Mode>
vtkSmartPointer<Mode> NewMode(const char* array = "")
{
  auto mode = vtkSmartPointer<Mode>::New();
  mode->SetArrayName(array);
  return mode;
}
} // namespace

TEST_F(FilterModes, AFlowLetsGoAlongItHoldsAcrossItAndPushes)
{
  // P1, P2. The default strength is 2 N.
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 3.0;
      v[1] = v[2] = 0.0;
    });
  const auto mode = NewMode<vtkHapticVectorFollowMode>("flow");
  this->Filter->AddMode(mode);
  this->Follow(Line({ 8, 8, 12 }, { 16, 11, 12 }, 100));
  vtkPolyData* trace = this->Run(101);
  ExpectNear(Last(trace, "Force"), { 0.0, -3.0 * SpringPerMm, 0.0 }, 1e-12);
  ExpectNear(LastProxy(trace), { 16.0, 8.0, 12.0 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_0"), Last(trace, "Force"), 0.0);
  EXPECT_EQ(Get(trace, "Stiffness", 100), SpringOf);
  this->Follow(Line({ 8, 8, 12 }, { 16, 15, 12 }, 100));
  ExpectNear(Last(this->Run(101), "Force"), { 0.0, -2.0, 0.0 }, 1e-12);
  mode->GetPush()->AddPoint(0.0, 0.0);
  mode->GetPush()->AddPoint(6.0, 1.0);
  this->Follow({ { 8, 8, 12 }, { 8, 8, 12 } });
  ExpectNear(Last(this->Run(2), "Force"), { 0.5, 0.0, 0.0 }, 1e-12);
  // A stiffness of the coupling, and a cap on it.
  mode->GetPush()->RemoveAllPoints();
  this->Filter->SetCouplingStiffness(300.0);
  this->Follow(Line({ 8, 8, 12 }, { 9, 9, 12 }, 10));
  ExpectNear(Last(this->Run(11), "Force"), { 0.0, -0.3, 0.0 }, 1e-12);
  this->Filter->SetMaximumStiffness(200.0);
  ExpectNear(Last(this->Run(11), "Force"), { 0.0, -0.2, 0.0 }, 1e-12);
}

TEST_F(FilterModes, ACircleIsFollowedWithoutDrift)
{
  // P4: the tip 2 mm inside of a circle of 8 mm: 1 N outwards, turn after turn.
  this->AddCircles();
  this->Filter->AddMode(NewMode<vtkHapticVectorFollowMode>("flow"));
  std::vector<Point> tips = { { Middle + 8.0, Middle, Middle } };
  for (int i = 0; i <= 5000; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / 500.0;
    tips.push_back({ Middle + 6.0 * std::cos(angle), Middle + 6.0 * std::sin(angle), Middle });
  }
  this->Follow(tips);
  vtkPolyData* const trace = this->Run(5002);
  ExpectNear(LastProxy(trace), { Middle + 8.0, Middle, Middle }, 1e-3);
  ExpectNear(Last(trace, "Force"), { 1.0, 0.0, 0.0 }, 1e-3);
}

TEST_F(FilterModes, ComponentsMayStandAlongTheAxesOfTheImage)
{
  // P11. x of the image is z of the world: (z, x, y) of the world are (x, y, z) of the image.
  vtkNew<vtkMatrix3x3> direction;
  const double rows[9] = { 0, 1, 0, 0, 0, 1, 1, 0, 0 };
  direction->DeepCopy(rows);
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 1.0;
      v[1] = v[2] = 0.0;
    });
  const auto mode = NewMode<vtkHapticVectorFollowMode>("flow");
  this->Filter->AddMode(mode);
  this->Image->SetDirectionMatrix(direction);
  this->Follow(Line({ 12, 12, 8 }, { 13, 12, 9 }, 20));
  ExpectNear(Last(this->Run(21), "Force"), { 0.0, 0.0, -SpringPerMm }, 1e-12);
  mode->SetAxesToImage();
  ExpectNear(Last(this->Run(21), "Force"), { -SpringPerMm, 0.0, 0.0 }, 1e-12);
}

TEST_F(FilterModes, LayoutsOfAnArrayAreAlikeToTheBit)
{
  const auto six = this->AddArray("six", 6,
    [](const Point& p, double* t)
    {
      const double a = 0.05 * p[0] + 0.03 * p[2];
      t[0] = 0.6 + 0.4 * std::cos(2.0 * a);
      t[1] = 0.6 - 0.4 * std::cos(2.0 * a);
      t[2] = 0.1;
      t[3] = 0.4 * std::sin(2.0 * a);
      t[4] = t[5] = 0.0;
    });
  this->AddArray("nine", 9,
    [&](const Point& p, double* t)
    {
      const vtkIdType i = this->Image->FindPoint(p[0], p[1], p[2]);
      const double* const s = six->GetPointer(6 * i);
      const double all[9] = { s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2] };
      std::copy_n(all, 9, t);
    });
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->DeepCopy(six);
  apart->SetName("apart");
  this->Image->GetPointData()->AddArray(apart);
  const auto mode = NewMode<vtkHapticTensorFollowMode>("six");
  mode->GetSheetStrength()->AddPoint(0.0, 0.5);
  this->Filter->AddMode(mode);
  this->Follow(Line({ 6, 6, 6 }, { 17, 15, 16 }, 300));
  const auto first = (this->Run(301), Keep(this->Filter));
  EXPECT_GT(std::abs(Last(first, "Force")[0]), 0.1);
  for (const char* const name : { "nine", "apart" })
  {
    mode->SetArrayName(name);
    EXPECT_TRUE(IsSame((this->Run(301), Keep(this->Filter)), first)) << name;
  }
  this->Image->GetPointData()->SetActiveTensors("nine");
  mode->SetArrayName("");
  EXPECT_TRUE(IsSame((this->Run(301), Keep(this->Filter)), first));
}

TEST_F(FilterModes, ModesAreFeltTogetherAndEachHasItsForce)
{
  // A line along x and fronts across z, beside the surfaces of the scalars, which rise with z.
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 1.0;
      v[1] = v[2] = 0.0;
    });
  this->AddArray("wave", 3,
    [](const Point&, double* v)
    {
      v[0] = v[1] = 0.0;
      v[2] = -1.0;
    });
  const auto follow = NewMode<vtkHapticVectorFollowMode>("flow");
  const auto front = NewMode<vtkHapticVectorFrontMode>("wave");
  const auto surface = NewMode<vtkHapticSurfaceMode>();
  SetConstant(follow->GetStrength(), 0.7);
  SetConstant(front->GetStrength(), 0.4);
  SetConstant(this->Property->GetSurfaceStrength(), 0.3);
  SetConstant(this->Property->GetDistinctness(), 1.0);
  this->Filter->AddMode(follow);
  this->Filter->AddMode(follow); // is there
  this->Filter->AddMode(front);
  this->Filter->AddMode(surface);
  this->Filter->AddMode(nullptr);
  ASSERT_EQ(this->Filter->GetNumberOfModes(), 3);
  EXPECT_EQ(this->Filter->GetMode(1), front.Get());
  EXPECT_EQ(this->Filter->GetMode(3), nullptr);
  this->Follow(Line({ 10, 10, 10 }, { 14, 16, 10 }, 50));
  vtkPolyData* trace = this->Run(51);
  ExpectNear(Last(trace, "ModeForce_0"), { 0.0, -0.7, 0.0 }, 1e-12);
  this->Follow(Line({ 10, 10, 10 }, { 10, 10, 16 }, 50));
  trace = this->Run(51);
  // Held along z by all three, with all of their strengths.
  ExpectNear(Last(trace, "Force"), { 0.0, 0.0, -1.4 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_0"), { 0.0, 0.0, -0.7 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_1"), { 0.0, 0.0, -0.4 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_2"), { 0.0, 0.0, -0.3 }, 1e-9);
  // Without the line, and backwards: fronts of one side and surfaces are free.
  follow->ActiveOff();
  trace = this->Run(51);
  ExpectNear(Last(trace, "Force"), { 0.0, 0.0, -0.7 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_0"), { 0.0, 0.0, 0.0 }, 0.0);
  this->Follow(Line({ 10, 10, 16 }, { 10, 10, 10 }, 50));
  ExpectNear(Last(this->Run(51), "Force"), { 0.0, 0.0, 0.0 }, 1e-9);
  front->TwoSidedOn();
  ExpectNear(Last(this->Run(51), "Force"), { 0.0, 0.0, 0.4 }, 1e-9);
  this->Filter->RemoveMode(front);
  ExpectNear(Last(this->Run(51), "Force"), { 0.0, 0.0, 0.0 }, 1e-9);
  this->Filter->SetTraceArrays("Force ModeForce_1");
  trace = this->Run(51);
  EXPECT_TRUE(trace->GetPointData()->GetArray("ModeForce_1"));
  EXPECT_FALSE(trace->GetPointData()->GetArray("ModeForce_0"));
}

TEST_F(FilterModes, AVesselIsSnappedOnAndFollowed)
{
  // A tube of Gaussian profile along (1, 1, 0)/sqrt(2), through (11.3, 11.3, 11.8).
  const double s = std::sqrt(0.5);
  for (const bool isDark : { false, true })
  {
    this->Image = MakeImage(24, VTK_DOUBLE,
      [&](const Point& p)
      {
        const double aside = s * (p[0] - p[1]);
        const double above = p[2] - 11.8;
        const double tube = 1000.0 * std::exp(-(aside * aside + above * above) / 8.0);
        return isDark ? 1000.0 - tube : tube;
      });
    this->Filter->SetInputData(this->Image);
    this->Filter->RemoveAllModes();
    const auto mode = NewMode<vtkHapticRidgeMode>();
    mode->SetPolarity(isDark);
    this->Filter->AddMode(mode);
    // From 1 mm off the axis, along it with 1 mm of lag across it.
    this->Follow(Line({ 8, 8, 12.8 }, { 15 + s, 15 - s, 11.8 }, 300));
    vtkPolyData* const trace = this->Run(301);
    const Point on = LastProxy(trace);
    EXPECT_NEAR(on[0] - on[1], 0.0, 0.01);
    EXPECT_NEAR(on[2], 11.8, 0.01);
    EXPECT_NEAR(on[0] + on[1], 30.0, 0.02) << "free along it";
    ExpectNear(Last(trace, "Force"), { -s * SpringPerMm, s * SpringPerMm, 0.0 }, 0.01);
    // The other polarity has no ridge here.
    mode->SetPolarity(!isDark);
    this->Follow(Line({ 8, 8, 11.8 }, { 12, 12, 11.8 }, 50));
    ExpectNear(Last(this->Run(51), "Force"), { 0.0, 0.0, 0.0 }, 1e-9);
  }
}

TEST_F(FilterModes, AGuideLeadsAroundItsCornerAndEnds)
{
  const auto mode = NewMode<vtkHapticGuideMode>();
  mode->SetPath(MakePath({ { 5, 5, 12 }, { 15, 5, 12 }, { 15, 15, 12 } }));
  this->Filter->AddMode(mode);
  // Beside the first leg; outside of the corner; beside the second leg; beyond the end.
  this->Follow(Line({ 6, 5, 12 }, { 10, 4, 12 }, 50));
  vtkPolyData* trace = this->Run(51);
  ExpectNear(LastProxy(trace), { 10.0, 5.0, 12.0 }, 1e-9);
  ExpectNear(Last(trace, "Force"), { 0.0, SpringPerMm, 0.0 }, 1e-9);
  this->Follow(Line({ 13, 5, 12 }, { 17, 3, 12 }, 200));
  trace = this->Run(201);
  ExpectNear(LastProxy(trace), { 15.0, 5.0, 12.0 }, 0.01);
  ExpectNear(Last(trace, "Force"), { -2.0 * SpringPerMm, 2.0 * SpringPerMm, 0.0 }, 0.01);
  auto points = Line({ 13, 5, 12 }, { 17, 3, 12 }, 200);
  for (const Point& p : Line({ 17, 3, 12 }, { 16, 11, 13 }, 200))
  {
    points.push_back(p);
  }
  this->Follow(points);
  trace = this->Run(402);
  ExpectNear(LastProxy(trace), { 15.0, 11.0, 12.0 }, 1e-6);
  ExpectNear(Last(trace, "Force"), { -SpringPerMm, 0.0, -SpringPerMm }, 1e-6);
  this->Follow(Line({ 15, 13, 12 }, { 15, 17, 12 }, 50));
  trace = this->Run(51);
  ExpectNear(LastProxy(trace), { 15.0, 15.0, 12.0 }, 1e-9);
  ExpectNear(Last(trace, "Force"), { 0.0, -2.0 * SpringPerMm, 0.0 }, 1e-9);
  // 1 N beyond a millimetre: farther off, the hand is led back with it.
  mode->GetStrength()->AddPoint(0.0, 1.0);
  this->Follow({ { 8, 8, 12 }, { 8, 8, 12 } });
  ExpectNear(Last(this->Run(2), "Force"), { 0.0, -1.0, 0.0 }, 1e-9);
}

TEST_F(FilterModes, AStrengthThatFallsOutwardLetsTheHandGoAsItSays)
{
  // P3, Poiseuille's profile with R = 20 mm: S = 2 (1 - r^2/R^2) N, so that the proxy is at r if
  // the tip is at r + S(r)/k: at 10 mm with 1.5 N for 13 mm, at 15 mm with 0.875 N for 16.75 mm.
  // A cubic B-spline of samples 1 mm apart adds 1/3 mm^2 to the square of each coordinate.
  constexpr double axis = 23.5;
  this->Image = MakeImage(48, VTK_DOUBLE, [](const Point&) { return 0.0; });
  this->Filter->SetInputData(this->Image);
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      v[0] = v[1] = 0.0;
      v[2] = 1.0 - (std::pow(p[0] - axis, 2) + std::pow(p[1] - axis, 2)) / 400.0;
    });
  const auto mode = NewMode<vtkHapticVectorFollowMode>("flow");
  mode->GetStrength()->AddPoint(0.0, 0.0);
  mode->GetStrength()->AddPoint(1.0, 2.0);
  this->Filter->AddMode(mode);
  for (const double tip : { 13.0, 16.75 })
  {
    this->Follow(Line({ axis, axis, axis }, { axis + 0.8 * tip, axis - 0.6 * tip, axis }, 500));
    vtkPolyData* const trace = this->Run(501);
    const double proxy =
      50.0 * (1.0 - std::sqrt(1.0 - 0.04 * (tip - 4.0 + 4.0 * 2.0 / 3.0 / 400.0)));
    const double force = SpringPerMm * (tip - proxy);
    EXPECT_NEAR(Get(trace, "NormalForce", 500), force, 0.001 * force);
    ExpectNear(LastProxy(trace), { axis + 0.8 * proxy, axis - 0.6 * proxy, axis }, 0.002);
    EXPECT_NEAR(force, tip == 13.0 ? 1.5 : 0.875, 0.006) << "of the flow itself";
  }
}

TEST_F(FilterModes, WhereAFlowTurnsOverTheForceGoesThroughZero)
{
  // P8, the shear v = (y, 0, 0), across y = 0.
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      v[0] = p[1] - Middle;
      v[1] = v[2] = 0.0;
    });
  const auto mode = NewMode<vtkHapticVectorFollowMode>("flow");
  mode->GetStrength()->AddPoint(0.0, 0.0);
  mode->GetStrength()->AddPoint(4.0, 1.0);
  this->Filter->AddMode(mode);
  this->Follow(Line({ 8, Middle - 5.0, 12 }, { 8, Middle + 5.0, 12 }, 1000));
  vtkPolyData* const trace = this->Run(1001);
  double before = 0.0;
  double nearest = 10.0;
  double force = 1.0;
  for (vtkIdType tick = 0; tick <= 1000; ++tick)
  {
    double proxy[3];
    trace->GetPoint(tick, proxy);
    const double now = Get(trace, "Force", tick, 1);
    ASSERT_TRUE(std::isfinite(now));
    ASSERT_EQ(Get(trace, "Force", tick, 2), 0.0);
    // The hold is 0.25 N/mm of the distance from the middle: half of what the spring has.
    ASSERT_LT(std::abs(now - before), 0.5 * 0.01 * 2.0 + 1e-9) << tick;
    before = now;
    if (std::abs(proxy[1] - Middle) < nearest)
    {
      nearest = std::abs(proxy[1] - Middle);
      force = std::abs(now);
    }
  }
  EXPECT_LT(nearest, 0.02);
  EXPECT_LT(force, 0.02);
}

TEST_F(FilterModes, WhatHasNoDirectionOrIsNotFiniteIsNotFelt)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : { 0.0, nan })
  {
    this->Filter->RemoveAllModes();
    this->AddArray("flow", 3, [&](const Point&, double* v) { v[0] = v[1] = v[2] = value; });
    this->AddArray("tensor", 6,
      [&](const Point&, double* t)
      {
        std::fill_n(t, 6, 0.0);
        t[0] = value;
      });
    this->Image->GetPointData()->GetScalars()->FillComponent(0, value);
    this->Filter->AddMode(NewMode<vtkHapticVectorFollowMode>("flow"));
    this->Filter->AddMode(NewMode<vtkHapticTensorFollowMode>("tensor"));
    this->Filter->AddMode(NewMode<vtkHapticVectorFrontMode>("flow"));
    this->Filter->AddMode(NewMode<vtkHapticShearMode>("flow"));
    this->Filter->AddMode(NewMode<vtkHapticRidgeMode>());
    this->Follow(Line({ 8, 8, 12 }, { 16, 15, 30 }, 100));
    vtkPolyData* const trace = this->Run(101);
    for (vtkIdType tick = 0; tick < 101; ++tick)
    {
      ASSERT_EQ(Get(trace, "NormalForce", tick), 0.0);
    }
    this->Filter->RemoveAllModes();
    this->Filter->AddMode(NewMode<vtkHapticVortexMode>("flow"));
    this->Filter->AddMode(NewMode<vtkHapticSurfaceMode>());
    this->Run(101);
  }
}

TEST_F(FilterModes, BadInputGivesOneErrorWithItsCure)
{
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 1.0;
      v[1] = v[2] = 0.0;
    });
  const auto follow = NewMode<vtkHapticVectorFollowMode>("velocity");
  this->Filter->AddMode(follow);
  this->ExpectError({ "port 0", "\"velocity\"", "vtkHapticVectorFollowMode", "SetArrayName()" });
  follow->SetArrayName("");
  this->ExpectError({ "port 0", "active vectors of 3 components", "SetArrayName()" });
  follow->SetArrayName("Density");
  this->ExpectError({ "array \"Density\"", "1 component(s)", "vectors of 3", "SetArrayName()" });
  follow->SetArrayName("flow");
  SetConstant(follow->GetPush(), -1.0);
  this->ExpectError({ "Push", "vtkHapticVectorFollowMode", "-1", "0 N or more", "GetPush()" });
  follow->GetPush()->RemoveAllPoints();
  const auto tensors = NewMode<vtkHapticTensorFollowMode>("flow");
  this->Filter->AddMode(tensors);
  this->ExpectError({ "array \"flow\"", "3 component(s)", "6 (XX", "SetArrayName()" });
  tensors->ActiveOff();
  const auto guide = NewMode<vtkHapticGuideMode>();
  this->Filter->AddMode(guide);
  this->ExpectError({ "vtkHapticGuideMode", "no path", "SetPath()" });
  guide->SetPath(MakePath({ { 0, 0, 0 }, { NAN, 0, 0 } }));
  this->ExpectError({ "vtkHapticGuideMode", "not finite", "SetPath()" });
  const vtkNew<vtkPolyData> cut; // of points that are not there any more
  const vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  cut->SetLines(line);
  guide->SetPath(cut);
  this->ExpectError({ "vtkHapticGuideMode", "has 0 points", "SetPath()" });
  cut->SetPoints(MakePath({ { 0, 0, 0 } })->GetPoints());
  guide->Modified();
  this->ExpectError({ "vtkHapticGuideMode", "has the point 1", "SetPath()" });
  guide->SetPath(MakePath({ { 0, 0, 0 }, { 5, 5, 5 } }));
  this->Run(51);
  for (int i = 0; i < 3; ++i)
  {
    this->Filter->AddMode(NewMode<vtkHapticVectorFollowMode>("flow"));
  }
  this->ExpectError({ "too many", "8 primitives", "have 10", "RemoveMode()" });
  this->Filter->RemoveMode(guide);
  this->Run(51);
  vtkNew<TimeSource> source;
  source->Steps = { 0.0, 1.0 };
  source->Make = [this](double) { return this->Image; };
  this->Filter->SetInputConnection(source->GetOutputPort());
  this->ExpectError({ "PRIMITIVES", "several frames", "SetTimeUnitsPerSecond(0)" });
  this->Filter->SetTimeUnitsPerSecond(0.0);
  this->Run(51);
}

TEST_F(FilterModes, AnImageOfVectorsAloneNeedsNoScalars)
{
  this->AddCircles();
  this->Image->GetPointData()->SetActiveVectors("flow");
  this->Image->GetPointData()->RemoveArray("Density");
  this->Filter->AddMode(NewMode<vtkHapticVectorFollowMode>());
  this->Follow(Line({ 16, Middle, 12 }, { 17, Middle, 12 }, 20));
  ExpectNear(Last(this->Run(21), "Force"), { -SpringPerMm, 0.0, 0.0 }, 1e-3);
  // Without modes the hand is free; menus leave the method out then.
  this->Filter->RemoveAllModes();
  this->ExpectError({ "no point scalars" });
  this->Filter->SetMethodToLocalSurface();
  this->Filter->NextMethod();
  EXPECT_EQ(this->Filter->GetMethodName(), "proxy");
}
