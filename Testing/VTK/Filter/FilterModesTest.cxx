// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests modes of the method PRIMITIVES through the filter. Forces have closed forms: a line with
 * the strength S pulls a tip at a distance d with min(k d, S), where k is the spring's stiffness.
 */

#include "FilterModesRig.h"
#include "Rigs/TimeSource.h"

#include <vtkDataArray.h>
#include <vtkHapticGuideMode.h>
#include <vtkHapticMode.h>
#include <vtkMatrix3x3.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkStringArray.h>

#include <limits>
#include <map>

using namespace modestest;

TEST_F(FilterModes, AFlowLetsGoAlongItHoldsAcrossItAndPushes)
{
  // Cases P1 and P2, with the default strength of 2 N.
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 3.0;
      v[1] = v[2] = 0.0;
    });
  const auto mode = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
  this->Filter->AddMode(mode);
  this->Follow(Line({ 8, 8, 12 }, { 16, 11, 12 }, 100));
  vtkPolyData* trace = this->Run(101);
  ExpectNear(Last(trace, "Force"), { 0.0, -3.0 * SpringPerMm, 0.0 }, 1e-12);
  ExpectNear(LastProxy(trace), { 16.0, 8.0, 12.0 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_0"), Last(trace, "Force"), 0.0);
  EXPECT_EQ(Get(trace, "Stiffness", 100), SpringOf);
  this->Follow(Line({ 8, 8, 12 }, { 16, 15, 12 }, 100));
  ExpectNear(Last(this->Run(101), "Force"), { 0.0, -2.0, 0.0 }, 1e-12);
  mode->GetSecondStrength()->AddPoint(0.0, 0.0);
  mode->GetSecondStrength()->AddPoint(6.0, 1.0);
  this->Follow({ { 8, 8, 12 }, { 8, 8, 12 } });
  ExpectNear(Last(this->Run(2), "Force"), { 0.5, 0.0, 0.0 }, 1e-12);
  // The force is proportional to the coupling stiffness, which MaximumStiffness limits.
  mode->GetSecondStrength()->RemoveAllPoints();
  this->Filter->SetCouplingStiffness(300.0);
  this->Follow(Line({ 8, 8, 12 }, { 9, 9, 12 }, 10));
  ExpectNear(Last(this->Run(11), "Force"), { 0.0, -0.3, 0.0 }, 1e-12);
  this->Filter->SetMaximumStiffness(200.0);
  ExpectNear(Last(this->Run(11), "Force"), { 0.0, -0.2, 0.0 }, 1e-12);
}

TEST_F(FilterModes, ACircleIsFollowedWithoutDrift)
{
  // Case P4: the tip is 2 mm inside a circle of 8 mm, so the force is 1 N outwards in each turn.
  this->AddCircles();
  this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow"));
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
  // Case P11: the image's x axis is the world's z axis. A vector (x, y, z) of the image is (z, x,
  // y) in the world.
  vtkNew<vtkMatrix3x3> direction;
  const double rows[9] = { 0, 1, 0, 0, 0, 1, 1, 0, 0 };
  direction->DeepCopy(rows);
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 1.0;
      v[1] = v[2] = 0.0;
    });
  const auto mode = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
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
  const auto mode = NewMode(vtkHapticMode::TENSOR_FOLLOW, "six");
  mode->GetSecondStrength()->AddPoint(0.0, 0.5);
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
  // The flow defines a line along x, and wave fronts across z. The surfaces of the scalars, which
  // increase with z, are also across z.
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
  const auto follow = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
  const auto front = NewMode(vtkHapticMode::VECTOR_FRONT, "wave");
  const auto surface = NewMode(vtkHapticMode::SURFACE);
  SetConstant(follow->GetStrength(), 0.7);
  SetConstant(front->GetStrength(), 0.4);
  SetConstant(this->Property->GetSurfaceStrength(), 0.3);
  SetConstant(this->Property->GetDistinctness(), 1.0);
  this->Filter->AddMode(follow);
  this->Filter->AddMode(follow); // must not add the same mode again
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
  // All three modes resist along z, each with its strength.
  ExpectNear(Last(trace, "Force"), { 0.0, 0.0, -1.4 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_0"), { 0.0, 0.0, -0.7 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_1"), { 0.0, 0.0, -0.4 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_2"), { 0.0, 0.0, -0.3 }, 1e-9);
  // A backward motion without the line must be free, because one-sided fronts and surfaces resist
  // only forward motions.
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
  // The vessel is a tube with a Gaussian profile along (1, 1, 0)/sqrt(2) through the point (11.3,
  // 11.3, 11.8).
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
    const auto mode = NewMode(vtkHapticMode::RIDGE);
    mode->SetPolarity(isDark);
    this->Filter->AddMode(mode);
    // The tip starts 1 mm off the axis, moves along the axis, and ends 1 mm off it.
    this->Follow(Line({ 8, 8, 12.8 }, { 15 + s, 15 - s, 11.8 }, 300));
    vtkPolyData* const trace = this->Run(301);
    const Point on = LastProxy(trace);
    EXPECT_NEAR(on[0] - on[1], 0.0, 0.01);
    EXPECT_NEAR(on[2], 11.8, 0.01);
    EXPECT_NEAR(on[0] + on[1], 30.0, 0.02) << "free along it";
    ExpectNear(Last(trace, "Force"), { -s * SpringPerMm, s * SpringPerMm, 0.0 }, 0.01);
    // For the other polarity, the vessel is no ridge, so it must not attract the tip.
    mode->SetPolarity(!isDark);
    this->Follow(Line({ 8, 8, 11.8 }, { 12, 12, 11.8 }, 50));
    ExpectNear(Last(this->Run(51), "Force"), { 0.0, 0.0, 0.0 }, 1e-9);
  }
}

TEST_F(FilterModes, WhereAFlowTurnsOverTheForceGoesThroughZero)
{
  // Case P8: the tip crosses y = Middle, where the shear flow along x changes its sign.
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      v[0] = p[1] - Middle;
      v[1] = v[2] = 0.0;
    });
  const auto mode = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
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
    // The strength increases by 0.25 N per millimetre from the middle, at half of the spring's
    // stiffness.
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
    this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow"));
    this->Filter->AddMode(NewMode(vtkHapticMode::TENSOR_FOLLOW, "tensor"));
    this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FRONT, "flow"));
    this->Filter->AddMode(NewMode(vtkHapticMode::SHEAR, "flow"));
    this->Filter->AddMode(NewMode(vtkHapticMode::RIDGE));
    this->Follow(Line({ 8, 8, 12 }, { 16, 15, 30 }, 100));
    vtkPolyData* const trace = this->Run(101);
    for (vtkIdType tick = 0; tick < 101; ++tick)
    {
      ASSERT_EQ(Get(trace, "NormalForce", tick), 0.0);
    }
    this->Filter->RemoveAllModes();
    this->Filter->AddMode(NewMode(vtkHapticMode::VORTEX, "flow"));
    this->Filter->AddMode(NewMode(vtkHapticMode::SURFACE));
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
  const auto follow = NewMode(vtkHapticMode::VECTOR_FOLLOW, "velocity");
  this->Filter->AddMode(follow);
  this->ExpectError(
    { "port 0", "\"velocity\"", "vtkHapticMode of kind VectorFollow", "SetArrayName()" });
  follow->SetArrayName("");
  this->ExpectError({ "port 0", "active vectors of 3 components", "SetArrayName()" });
  follow->SetArrayName("Density");
  this->ExpectError({ "array \"Density\"", "1 component(s)", "vectors of 3", "SetArrayName()" });
  follow->SetArrayName("flow");
  SetConstant(follow->GetSecondStrength(), -1.0);
  this->ExpectError({ "Push", "kind VectorFollow", "-1", "0 N or more", "GetSecondStrength()" });
  SetConstant(follow->GetSecondStrength(), 1.0);
  follow->SetKindToShear();
  this->ExpectError({ "kind Shear has no SecondStrength", "SetSecondStrength(nullptr)" });
  follow->SetKindToVectorFollow();
  follow->SetSecondStrength(nullptr);
  const auto tensors = NewMode(vtkHapticMode::TENSOR_FOLLOW, "flow");
  this->Filter->AddMode(tensors);
  this->ExpectError({ "array \"flow\"", "3 component(s)", "6 (XX", "SetArrayName()" });
  tensors->ActiveOff();
  const auto guide = vtkSmartPointer<vtkHapticGuideMode>::New();
  this->Filter->AddMode(guide);
  guide->SetPath(MakePath({ { 0, 0, 0 }, { 5, 5, 5 } }));
  this->Run(51);
  for (int i = 0; i < 3; ++i)
  {
    this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow"));
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

TEST_F(FilterModes, ARankineVortexLetsGoAtItsRadius)
{
  // Case P6: rot v is 2 within a = 10 mm, and 0 outside. S is 2 N where rot v exceeds 1.
  constexpr double axis = 23.5;
  this->Image = MakeImage(48, VTK_FLOAT, [](const Point&) { return 0.0; });
  this->Filter->SetInputData(this->Image);
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      const double x = p[0] - axis;
      const double y = p[1] - axis;
      const double turn = std::min(1.0, 100.0 / (x * x + y * y));
      v[0] = -turn * y;
      v[1] = turn * x;
      v[2] = 0.0;
    });
  const auto mode = NewMode(vtkHapticMode::VORTEX, "flow");
  mode->GetStrength()->AddPoint(0.99, 0.0);
  mode->GetStrength()->AddPoint(1.01, 2.0);
  this->Filter->AddMode(mode);
  this->Follow(Line({ axis, axis, axis }, { axis + 18.0, axis, axis }, 1800));
  vtkPolyData* const trace = this->Run(1801);
  double last = 0.0; // largest radius at which the full strength acts
  for (vtkIdType tick = 450; tick < 1801; ++tick)
  {
    double proxy[3];
    trace->GetPoint(tick, proxy);
    const double r = proxy[0] - axis;
    const double force = Get(trace, "NormalForce", tick);
    if (r < 9.0)
    {
      ASSERT_NEAR(force, 2.0, 0.01) << r;
    }
    last = force > 1.0 ? r : last;
  }
  EXPECT_NEAR(last, 10.0, 0.5) << "within the kernel's voxel";
  EXPECT_LT(Get(trace, "NormalForce", 1800), 1e-3);
}

TEST_F(FilterModes, ALineOfADipoleIsKept)
{
  // Case P7: a field line of a dipole is r = C sin^2 of the angle to the axis. The field is
  // harmonic, so splines don't blur it. The tip moves 5 % inside the line, from the equator to 50
  // degrees.
  this->Image = MakeImage(48, VTK_FLOAT, [](const Point&) { return 0.0; });
  this->Image->SetOrigin(10.0, -23.5, -10.0);
  this->Filter->SetInputData(this->Image);
  this->AddArray("field", 3,
    [](const Point& p, double* v)
    {
      const double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      const double fall = 1e6 * std::pow(square, -2.5);
      v[0] = fall * 3.0 * p[2] * p[0];
      v[1] = fall * 3.0 * p[2] * p[1];
      v[2] = fall * (3.0 * p[2] * p[2] - square);
    });
  this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FOLLOW, "field"));
  constexpr double c = 40.0;
  std::vector<Point> tips = { { c, 0.0, 0.0 } };
  for (int i = 0; i <= 500; ++i)
  {
    const double angle = std::acos(-1.0) * (90.0 - 40.0 * i / 500.0) / 180.0;
    const double r = 0.95 * c * std::sin(angle) * std::sin(angle);
    tips.push_back({ r * std::sin(angle), 0.0, r * std::cos(angle) });
  }
  this->Follow(tips);
  vtkPolyData* const trace = this->Run(502);
  for (vtkIdType tick = 0; tick < 502; ++tick)
  {
    double x[3];
    trace->GetPoint(tick, x);
    const double r = std::hypot(x[0], x[1], x[2]);
    ASSERT_NEAR(r * r * r / (x[0] * x[0] + x[1] * x[1]), c, 0.01) << tick;
  }
  EXPECT_GT(LastProxy(trace)[2], 12.0) << "it has followed";
}

TEST_F(FilterModes, AnObliqueFrontAndALineShareTheSpring)
{
  // Case P10: a line along x and a front across (1, 0, 1), with 1 N each. While neither strength is
  // exceeded, the forces have a unique solution. If the tip is pulled further along -z, both modes
  // yield, each at its full strength.
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 1.0;
      v[1] = v[2] = 0.0;
    });
  this->AddArray("wave", 3,
    [](const Point&, double* v)
    {
      v[0] = v[2] = 3.0;
      v[1] = 0.0;
    });
  const auto line = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
  const auto front = NewMode(vtkHapticMode::VECTOR_FRONT, "wave");
  SetConstant(line->GetStrength(), 1.0);
  SetConstant(front->GetStrength(), 1.0);
  this->Filter->AddMode(line);
  this->Filter->AddMode(front);
  this->Follow(Line({ 12, 12, 16 }, { 11.4, 12.4, 14.8 }, 100));
  vtkPolyData* trace = this->Run(101);
  ExpectNear(LastProxy(trace), { 12, 12, 16 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_0"), { 0.0, -0.2, 0.3 }, 1e-9);
  ExpectNear(Last(trace, "ModeForce_1"), { 0.3, 0.0, 0.3 }, 1e-9);
  this->Follow(Line({ 12, 12, 18 }, { 12, 12, 8 }, 1000));
  trace = this->Run(1001);
  const double s = std::sqrt(0.5);
  ExpectNear(Last(trace, "Force"), { s, 0.0, 1.0 + s }, 1e-4);
  ExpectNear(LastProxy(trace), { 12 + 2 * s, 12, 10 + 2 * s }, 1e-3);
}

TEST_F(FilterModes, PresetsMakeTheirModes)
{
  this->AddCircles();
  this->AddArray("tensor", 6,
    [](const Point&, double* t)
    {
      std::fill_n(t, 6, 0.1);
      t[0] = 1.0;
    });
  // The scalars have a bright and a dark tube, so that both vessel presets can be proposed.
  for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
  {
    Point p;
    this->Image->GetPoint(i, p.data());
    const double bright = std::exp(-(std::pow(p[1] - 7, 2) + std::pow(p[2] - 7, 2)) / 4.0);
    const double dark = std::exp(-(std::pow(p[1] - 16, 2) + std::pow(p[2] - 16, 2)) / 4.0);
    this->Image->GetPointData()->GetScalars()->SetTuple1(i, 500.0 + 400.0 * (bright - dark));
  }
  const std::map<std::string, const char*> kinds = { { "Follow the flow", "VectorFollow" },
    { "Drift with the flow", "VectorFollow" }, { "Feel wave fronts", "VectorFront" },
    { "Find a vortex", "Vortex" }, { "Feel where a flow stretches", "Shear" },
    { "Slide along fibres", "TensorFollow" }, { "Slide along fibres and sheets", "TensorFollow" },
    { "Follow a vessel", "Ridge" }, { "Follow a dark vessel", "Ridge" },
    { "Follow the flow and touch surfaces", "VectorFollow" } };
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetModePresetNames();
  ASSERT_EQ(names->GetNumberOfValues(), static_cast<vtkIdType>(kinds.size()));
  // Apply the preset for shear without an image, because the flow is a rotation, whose shear is 0,
  // and the preset would propose no strength.
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const std::string name = names->GetValue(i);
    SCOPED_TRACE(name);
    const bool isStrange = name == "Feel where a flow stretches";
    this->Filter->SetMethodToProxy();
    this->Filter->RemoveAllModes();
    ASSERT_TRUE(
      this->Filter->ApplyModePreset(name.c_str(), isStrange ? nullptr : this->Image.Get()));
    EXPECT_EQ(this->Filter->GetMethodName(), "primitives");
    const bool hasSurface = name.find("surfaces") != std::string::npos;
    ASSERT_EQ(this->Filter->GetNumberOfModes(), hasSurface ? 2 : 1);
    vtkHapticMode* const mode = this->Filter->GetMode(0);
    EXPECT_EQ(vtkHapticMode::GetKindNames()->GetValue(mode->GetKind()), kinds.at(name));
    EXPECT_EQ(mode->GetStrength()->GetSize(), isStrange ? 0 : 2);
  }
  // The proposed strength must pull a tip that is 0.5 mm off the vessel to the vessel's middle.
  ASSERT_TRUE(this->Filter->ApplyModePreset("Follow a dark vessel", this->Image));
  this->Follow(Line({ 8, 15.5, 16 }, { 14, 15.5, 16 }, 100));
  EXPECT_NEAR(LastProxy(this->Run(101))[1], 16.0, 0.02);
  // An unknown name and an image without vectors must be refused, and change nothing.
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Filter->ApplyModePreset("Waltz", this->Image));
  this->Image->GetPointData()->RemoveArray("flow");
  EXPECT_FALSE(this->Filter->ApplyModePreset("Find a vortex", this->Image));
  ASSERT_EQ(this->Log.Errors.size(), 2u);
  EXPECT_NE(this->Log.Errors[0].find("\"Waltz\". Use one of: \"Follow"), std::string::npos);
  EXPECT_NE(this->Log.Errors[1].find("no vectors (a point array of 3"), std::string::npos);
  EXPECT_EQ(this->Filter->GetMode(0)->GetKind(), vtkHapticMode::RIDGE);
  this->Log.Errors.clear();
}

TEST_F(FilterModes, AnImageOfVectorsAloneNeedsNoScalars)
{
  this->AddCircles();
  this->Image->GetPointData()->SetActiveVectors("flow");
  this->Image->GetPointData()->RemoveArray("Density");
  this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FOLLOW));
  this->Follow(Line({ 16, Middle, 12 }, { 17, Middle, 12 }, 20));
  ExpectNear(Last(this->Run(21), "Force"), { -SpringPerMm, 0.0, 0.0 }, 1e-3);
  // Without modes, the method has no force, so NextMethod() skips it.
  this->Filter->RemoveAllModes();
  this->ExpectError({ "no point scalars" });
  this->Filter->SetMethodToLocalSurface();
  this->Filter->NextMethod();
  EXPECT_EQ(this->Filter->GetMethodName(), "proxy");
}

TEST_F(FilterModes, AFlowEndsAtACut)
{
  this->AddArray("flow", 3,
    [](const Point&, double* v)
    {
      v[0] = 3.0;
      v[1] = v[2] = 0.0;
    });
  this->Filter->AddMode(NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow"));
  this->Follow(Line({ 8, 8, 12 }, { 8, 11, 12 }, 100));
  ExpectNear(Last(this->Run(101), "Force"), { 0.0, -3.0 * SpringPerMm, 0.0 }, 1e-12);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 13.0);
  plane->SetNormal(0.0, 0.0, 1.0);
  this->Filter->AddClippingPlane(plane);
  ExpectNear(Last(this->Run(101), "Force"), { 0.0, 0.0, 0.0 }, 0.0);
  // The cut is half a voxel in front of the face, so half of the flow remains.
  plane->SetNormal(0.0, 0.0, -1.0);
  plane->SetOrigin(0.0, 0.0, 12.5);
  // stiff enough that the mode's strength of 2 N limits the force
  this->Filter->SetCouplingStiffness(2000.0);
  ExpectNear(Last(this->Run(101), "Force"), { 0.0, -1.0, 0.0 }, 1e-9);
}
