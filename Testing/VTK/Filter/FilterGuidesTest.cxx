// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the filter's guides: polylines, meshes and distance fields. Forces have closed forms: a tip
 * at a distance d from the guide is pulled towards it with k d.
 */

#include "FilterModesRig.h"

#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkHapticGuideMode.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

using namespace modestest;

namespace
{
class FilterGuides : public FilterModes
{
};
} // namespace

TEST_F(FilterGuides, AGuideLeadsAroundItsCornerAndEnds)
{
  const auto mode = vtkSmartPointer<vtkHapticGuideMode>::New();
  mode->SetPath(MakePath({ { 5, 5, 12 }, { 15, 5, 12 }, { 15, 15, 12 } }));
  this->Filter->AddMode(mode);
  // The paths end beside the first leg, outside the corner, beside the second leg, and beyond the
  // end of the guide.
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
  // The strength limits the pull to 1 N for a hand that is more than 1 mm away.
  mode->GetStrength()->AddPoint(0.0, 1.0);
  this->Follow({ { 8, 8, 12 }, { 8, 8, 12 } });
  ExpectNear(Last(this->Run(2), "Force"), { 0.0, -1.0, 0.0 }, 1e-9);
}

TEST_F(FilterGuides, ASurfaceHoldsTheHandOnIt)
{
  // The plane consists of two triangles whose outer edges are far from the hand, so the forces are
  // exact.
  const vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(0, 0, 12);
  corners->InsertNextPoint(23, 0, 12);
  corners->InsertNextPoint(23, 23, 12);
  corners->InsertNextPoint(0, 23, 12);
  const vtkNew<vtkCellArray> square;
  square->InsertNextCell({ 0, 1, 2, 3 });
  const vtkNew<vtkPolyData> plane;
  plane->SetPoints(corners);
  plane->SetPolys(square);
  const auto mode = vtkSmartPointer<vtkHapticGuideMode>::New();
  mode->SetSurface(plane);
  this->Filter->AddMode(mode);
  const double tips[2] = { 15.0, 9.0 };
  for (const double tip : tips)
  {
    this->Follow(Line({ 8, 9, 12 }, { 15, 13, tip }, 200));
    vtkPolyData* const trace = this->Run(201);
    ExpectNear(LastProxy(trace), { 15, 13, 12 }, 1e-9);
    ExpectNear(Last(trace, "Force"), { 0, 0, (12 - tip) * SpringPerMm }, 1e-9);
  }
  // The mode keeps the hand above the plane (outside), below the plane (inside), or on a surface 2
  // mm above the plane.
  mode->SetSideToOutside();
  ExpectNear(Last(this->Run(201), "Force"), { 0, 0, 1.5 }, 1e-9);
  mode->SetSideToInside();
  ExpectNear(Last(this->Run(201), "Force"), { 0, 0, 0 }, 1e-9);
  mode->SetSideToSurface();
  mode->SetDistance(2.0);
  this->Follow(Line({ 8, 9, 12 }, { 15, 13, 15 }, 200));
  ExpectNear(LastProxy(this->Run(201)), { 15, 13, 14 }, 1e-9);
  // First the strength is 0.5 N at any distance, then it falls to 0 at a distance of 1 mm.
  mode->SetDistance(0.0);
  SetConstant(mode->GetStrength(), 0.5);
  this->Follow({ { 8, 9, 17 }, { 8, 9, 17 } });
  ExpectNear(Last(this->Run(2), "Force"), { 0, 0, -0.5 }, 1e-9);
  mode->GetStrength()->AddPoint(1.0, 0.0);
  ExpectNear(Last(this->Run(2), "Force"), { 0, 0, 0 }, 0.0);
}

TEST_F(FilterGuides, AMeshOfABallAndItsDistanceFieldHoldTheHandAlike)
{
  // The ball has a radius of 8 mm around the middle. The tip circles it twice, 2 mm outside or
  // inside of the surface, so the force is 1 N.
  const vtkNew<vtkSphereSource> ball;
  ball->SetCenter(Middle, Middle, Middle);
  ball->SetRadius(8.0);
  ball->SetThetaResolution(160);
  ball->SetPhiResolution(80);
  ball->Update();
  const auto field = MakeImage(24, VTK_FLOAT,
    [](const Point& p) { return std::hypot(p[0] - Middle, p[1] - Middle, p[2] - Middle) - 8.0; });
  for (const bool isField : { false, true })
  {
    SCOPED_TRACE(isField);
    this->Filter->RemoveAllModes();
    const auto mode = vtkSmartPointer<vtkHapticGuideMode>::New();
    mode->SetSurface(isField ? nullptr : ball->GetOutput());
    mode->SetDistanceField(isField ? field.Get() : nullptr);
    this->Filter->AddMode(mode);
    // The spline increases the field by 1/6 of its Laplacian 2/r. The mesh's chords of 4.5 degrees
    // are up to 8/1300 mm inside the ball.
    const double radius = isField ? 4.0 + std::sqrt(16.0 - 1.0 / 3.0) : 8.0;
    const double s = std::sqrt(0.5);
    for (const double tip : { 6.0, 10.0 })
    {
      std::vector<Point> tips = { { Middle + radius, Middle, Middle } };
      for (int i = 0; i <= 1000; ++i)
      {
        const double angle = 4.0 * std::acos(-1.0) * i / 1000.0;
        const double y = tip * std::sin(angle);
        tips.push_back({ Middle + tip * std::cos(angle), Middle + s * y, Middle + s * y });
      }
      this->Follow(tips);
      vtkPolyData* const trace = this->Run(1002);
      for (vtkIdType tick = 100; tick < 1002; tick += 50)
      {
        Point on;
        trace->GetPoint(tick, on.data());
        const double r = std::hypot(on[0] - Middle, on[1] - Middle, on[2] - Middle);
        ASSERT_NEAR(r, radius, 0.01) << tick;
        ASSERT_NEAR(Get(trace, "NormalForce", tick), std::abs(tip - r) * SpringPerMm, 0.005);
        // The hand can move freely along the ball's surface, so the proxy follows it there.
        double at[3];
        trace->GetPointData()->GetArray("Tip")->GetTuple(tick, at);
        for (int a = 0; a < 3; ++a)
        {
          ASSERT_NEAR(on[a] - Middle, (at[a] - Middle) * r / tip, 0.2) << tick;
        }
      }
    }
    mode->SetDistance(1.0);
    mode->SetSideToOutside();
    this->Follow(Line({ Middle + 10, Middle, Middle }, { Middle + 7, Middle, Middle }, 100));
    EXPECT_NEAR(LastProxy(this->Run(101))[0], Middle + radius + 1.0, 0.01);
    mode->SetSideToInside();
    ExpectNear(Last(this->Run(101), "Force"), { 0, 0, 0 }, 1e-9);
  }
}

TEST_F(FilterGuides, TheEdgeOfAGuidingCubeIsGoneAround)
{
  // The tip moves around an edge of the cube at a distance of 1 mm. The proxy stays on the faces,
  // and on the edge while the tip is outside the edge. The force must change no faster than the tip
  // moves.
  const vtkNew<vtkCubeSource> cube;
  cube->SetBounds(6, 16, 6, 16, 6, 16);
  cube->Update();
  const auto mode = vtkSmartPointer<vtkHapticGuideMode>::New();
  mode->SetSurface(cube->GetOutput());
  this->Filter->AddMode(mode);
  std::vector<Point> tips = Line({ 12, 11, 16 }, { 15, 11, 17 }, 100);
  for (const auto& [from, to] : { std::pair<Point, Point>{ { 15, 11, 17 }, { 17, 11, 17 } },
         { { 17, 11, 17 }, { 17, 11, 14 } } })
  {
    for (const Point& p : Line(from, to, 300))
    {
      tips.push_back(p);
    }
  }
  this->Follow(tips);
  vtkPolyData* const trace = this->Run(703);
  for (vtkIdType tick = 1; tick < 703; ++tick)
  {
    Point on;
    trace->GetPoint(tick, on.data());
    ASSERT_NEAR(std::max(on[0], on[2]), 16.0, 0.02) << tick;
    double change = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      change =
        std::max(change, std::abs(Get(trace, "Force", tick, a) - Get(trace, "Force", tick - 1, a)));
    }
    ASSERT_LT(change, 0.05) << tick;
  }
  Point corner;
  trace->GetPoint(401, corner.data());
  ExpectNear(corner, { 16, 11, 16 }, 0.02);
  ExpectNear(LastProxy(trace), { 16, 11, 14 }, 1e-6);
}

TEST_F(FilterGuides, BadGuidesGiveOneErrorWithItsCure)
{
  const auto guide = vtkSmartPointer<vtkHapticGuideMode>::New();
  this->Filter->AddMode(guide);
  this->ExpectError({ "vtkHapticGuideMode", "no path", "SetPath()" });
  guide->SetPath(MakePath({ { 0, 0, 0 }, { NAN, 0, 0 } }));
  this->ExpectError({ "vtkHapticGuideMode", "not finite", "SetPath()" });
  const vtkNew<vtkPolyData> cut; // polydata with a line that refers to missing points
  const vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  cut->SetLines(line);
  guide->SetPath(cut);
  this->ExpectError({ "vtkHapticGuideMode", "has 0 points", "SetPath()" });
  cut->SetPoints(MakePath({ { 0, 0, 0 } })->GetPoints());
  guide->Modified();
  this->ExpectError({ "vtkHapticGuideMode", "has the point 1", "SetPath()" });
  const vtkNew<vtkPolyData> none;
  guide->SetSurface(none);
  this->ExpectError({ "vtkHapticGuideMode", "more than one shape", "SetSurface()" });
  guide->SetPath(nullptr);
  this->ExpectError({ "surface of a vtkHapticGuideMode", "no triangles", "SetSurface()" });
  guide->SetSurface(nullptr);
  const vtkNew<vtkImageData> empty;
  guide->SetDistanceField(empty);
  this->ExpectError({ "vtkHapticGuideMode", "no active point scalars", "SetDistanceField()" });
  empty->SetDimensions(4, 4, 1);
  empty->AllocateScalars(VTK_FLOAT, 1);
  this->ExpectError({ "distance field of a vtkHapticGuideMode", "4 x 4 x 1" });
  guide->SetDistance(NAN);
  this->ExpectError({ "Distance of a vtkHapticGuideMode", "not finite", "SetDistance()" });
  guide->SetDistance(0.0);
  guide->SetDistanceField(nullptr);
}
