// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests modes with arbitrary fields: closed forms on long paths and in rotated volumes, and bounds
 * of the forces. FilterModesTest.cxx tests simple cases.
 */

#include "FilterModesRig.h"

#include <vtkHapticGuideMode.h>
#include <vtkHapticMode.h>
#include <vtkMath.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <random>

using namespace modestest;

namespace
{
const double Turn = 2.0 * std::acos(-1.0);

/// Makes an image with these numbers of voxels around the origin and zero scalars.
vtkSmartPointer<vtkImageData> MakeGrid(const std::array<int, 3>& size, double spacing)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(
    -0.5 * spacing * (size[0] - 1), -0.5 * spacing * (size[1] - 1), -0.5 * spacing * (size[2] - 1));
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
  return image;
}

/// Makes a random walk that starts at the origin, with a weak pull back to the origin.
std::vector<Point> RandomWalk(int ticks, double stride)
{
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> uniform(-stride, stride);
  std::vector<Point> places = { {} };
  for (int tick = 0; tick < ticks; ++tick)
  {
    Point next = places.back();
    for (double& x : next)
    {
      x = (1.0 - 0.1 * stride) * x + uniform(engine);
    }
    places.push_back(next);
  }
  return places;
}

Point ForceAt(vtkPolyData* trace, vtkIdType tick)
{
  return { Get(trace, "Force", tick, 0), Get(trace, "Force", tick, 1),
    Get(trace, "Force", tick, 2) };
}

/// Sets `v` to a flow in many directions, with a rotation, a stretching, and a place without flow.
void Swirl(const Point& p, double* v)
{
  v[0] = std::sin(0.4 * p[1]);
  v[1] = std::cos(0.3 * p[2]) - 0.5;
  v[2] = 0.5 * std::sin(0.5 * p[0] + 0.2 * p[1]);
}

/// Sets `t` to the flow's tensor v v^T + 0.1 I, which becomes flat at some heights.
void SwirlTensor(const Point& p, double* t)
{
  double v[3];
  Swirl(p, v);
  const double flat = 0.3 * std::sin(0.3 * p[2]);
  const double six[6] = { v[0] * v[0] + 0.1, v[1] * v[1] + 0.1 + flat * flat, v[2] * v[2] + 0.1,
    v[0] * v[1], v[1] * v[2], v[0] * v[2] };
  std::copy_n(six, 6, t);
}
} // namespace

class FilterModeForms : public FilterModes
{
protected:
  void UseGrid(const std::array<int, 3>& size, double spacing)
  {
    this->Image = MakeGrid(size, spacing);
    this->Filter->SetInputData(this->Image);
  }

  /// A mode for the swirling fields, and the largest sum of its strengths (N).
  struct FeltMode
  {
    vtkSmartPointer<vtkHapticMode> Mode;
    double Most;
  };

  /// Sets the swirling fields, and makes one mode of each kind. The first, third and fifth mode can
  /// be combined.
  std::vector<FeltMode> UseSwirl()
  {
    this->UseGrid({ 24, 24, 24 }, 1.0);
    this->AddArray("flow", 3, Swirl);
    this->AddArray("tensor", 6, SwirlTensor);
    vtkDataArray* const scalars = this->Image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
    {
      // Make a bright vessel that passes near the origin.
      Point p;
      this->Image->GetPoint(i, p.data());
      const double up = 0.6 * p[0] - 0.8 * p[1] + 0.2;
      const double square = up * up + std::pow(p[2] - 0.4, 2);
      scalars->SetTuple1(i, 500.0 + 400.0 * std::exp(-square / 8.0));
    }
    SetConstant(this->Property->GetSurfaceStrength(), 0.6);
    SetConstant(this->Property->GetFriction(), 0.3);
    SetConstant(this->Property->GetViscosity(), 0.2);
    SetConstant(this->Property->GetDistinctness(), 1.0);
    const auto front = NewMode(vtkHapticMode::VECTOR_FRONT, "flow");
    front->TwoSidedOn();
    const auto vortex = NewMode(vtkHapticMode::VORTEX, "flow");
    SetConstant(vortex->GetSecondStrength(), 0.3);
    const auto fibres = NewMode(vtkHapticMode::TENSOR_FOLLOW, "tensor");
    SetConstant(fibres->GetSecondStrength(), 0.5);
    // The strength functions end with their last value, 1.5 N, and a tensor's measure is at most 1.
    // A two-sided front resists on one side at a time. A guide resists with its line, and at its
    // ends also with a front.
    const std::vector<FeltMode> modes = { { NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow"), 1.5 },
      { front, 1.5 }, { vortex, 1.8 }, { NewMode(vtkHapticMode::SHEAR, "flow"), 1.5 },
      { fibres, 2.0 }, { NewMode(vtkHapticMode::VECTOR_FRONT, "flow"), 1.5 },
      { NewMode(vtkHapticMode::RIDGE), 1.5 }, { vtkSmartPointer<vtkHapticGuideMode>::New(), 3.0 },
      { NewMode(vtkHapticMode::SURFACE), 0.6 * (1.0 + 0.3) + 0.2 } };
    for (const FeltMode& felt : modes)
    {
      felt.Mode->GetStrength()->AddPoint(0.0, 0.0);
      felt.Mode->GetStrength()->AddPoint(1.0, 1.5);
    }
    SetConstant(modes[7].Mode->GetStrength(), 1.5); // independent of the distance from the line
    return modes;
  }

  /// Sets a guide's path to a straight line that rotates with the volume, and does not change other
  /// modes. A path with a kink would not rotate exactly: rounding decides where a motion ends at a
  /// kink, by up to FinishedFraction of a step (Core/Solvers/Primitives/PrimitiveFollower.h).
  template <typename Turn>
  static void SetGuide(vtkHapticMode* mode, const Turn& turn)
  {
    if (auto* const guide = vtkHapticGuideMode::SafeDownCast(mode))
    {
      guide->SetPath(MakePath({ turn({ -1.5, -1.0, 0.2 }), turn({ 1.0, 0.4, 0.7 }) }));
    }
  }
};

TEST_F(FilterModeForms, ALineIsKeptOverAHundredTurns)
{
  // Case P4: the line is a circle of 20 mm. The tip at a radius of 18 mm is pulled outwards with 1
  // N.
  this->UseGrid({ 48, 48, 7 }, 1.0);
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      v[0] = -p[1];
      v[1] = p[0];
      v[2] = 0.0;
    });
  const auto mode = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
  this->Filter->AddMode(mode);
  std::vector<Point> tips = { { 20.0, 0.0, 0.0 } };
  for (int tick = 0; tick <= 100 * 500; ++tick)
  {
    const double angle = Turn * (tick % 500) / 500.0;
    tips.push_back({ 18.0 * std::cos(angle), 18.0 * std::sin(angle), 0.0 });
  }
  this->Follow(tips);
  this->Filter->SetTraceArrays("Force");
  vtkPolyData* const trace = this->Run(100 * 500 + 2);
  ExpectNear(LastProxy(trace), { 20.0, 0.0, 0.0 }, 0.005);
  ExpectNear(Last(trace, "Force"), { 1.0, 0.0, 0.0 }, 0.005);
}

TEST_F(FilterModeForms, AStrengthThatFallsOutwardLetsTheHandGoAsItSays)
{
  // Case P3: Poiseuille's profile with R = 20 mm has the strength S = 2 (1 - r^2/R^2) N. If the tip
  // is at r + S(r)/k, the proxy is at r: at 10 mm with 1.5 N for a tip at 13 mm, at 15 mm with
  // 0.875 N for 16.75 mm, and at the wall without force for 20 mm. The cubic B-spline adds a third
  // of 0.5^2 to the square of each coordinate, which changes S by 8e-4 N.
  this->UseGrid({ 96, 96, 8 }, 0.5);
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      v[0] = v[1] = 0.0;
      v[2] = 1.0 - (p[0] * p[0] + p[1] * p[1]) / 400.0;
    });
  const auto mode = NewMode(vtkHapticMode::VECTOR_FOLLOW, "flow");
  mode->GetStrength()->AddPoint(0.0, 0.0);
  mode->GetStrength()->AddPoint(1.0, 2.0);
  this->Filter->AddMode(mode);
  struct Place
  {
    double Tip, Proxy, Force;
  };
  for (const Place& at :
    { Place{ 13.0, 10.0, 1.5 }, Place{ 16.75, 15.0, 0.875 }, Place{ 20.0, 20.0, 0.0 } })
  {
    this->Follow(Line({ 0, 0, 0 }, { 0.8 * at.Tip, -0.6 * at.Tip, 0 }, 500));
    vtkPolyData* const trace = this->Run(501);
    const double tolerance = at.Force > 0.0 ? 0.005 * at.Force : 0.002;
    EXPECT_NEAR(Get(trace, "NormalForce", 500), at.Force, tolerance) << at.Tip;
    EXPECT_NEAR(Get(trace, "Force", 500, 2), 0.0, 1e-6) << "none along the flow";
    ExpectNear(LastProxy(trace), { 0.8 * at.Proxy, -0.6 * at.Proxy, 0.0 }, 0.005);
  }
}

TEST_F(FilterModeForms, AVortexHoldsTheHandInAsItsVorticityFalls)
{
  // Case P5 (Lamb-Oseen): curl v = 2 exp(-r^2/100 mm^2), which is also the value of S in N. If the
  // tip is at r + S(r)/k, the proxy is at r: at 5 mm for a tip at 8.115 mm, at 10 mm for 11.472 mm,
  // at 20 mm for 20.073 mm.
  this->UseGrid({ 96, 96, 8 }, 0.5);
  this->AddArray("flow", 3,
    [](const Point& p, double* v)
    {
      const double square = p[0] * p[0] + p[1] * p[1];
      const double turn = -std::expm1(-square / 100.0) * 100.0 / square;
      v[0] = -turn * p[1];
      v[1] = turn * p[0];
      v[2] = 0.0;
    });
  const auto mode = NewMode(vtkHapticMode::VORTEX, "flow");
  mode->GetStrength()->AddPoint(0.0, 0.0);
  mode->GetStrength()->AddPoint(2.0, 2.0);
  this->Filter->AddMode(mode);
  struct Place
  {
    double Proxy, Tip, Force;
  };
  for (const Place& at : { Place{ 0.0, 3.9, 1.95 }, Place{ 5.0, 8.1152, 1.5576 },
         Place{ 10.0, 11.4715, 0.7358 }, Place{ 20.0, 20.0733, 0.0366 } })
  {
    // The tip moves slowly outwards from the core, in a different direction in each case.
    const double angle = 0.3 + at.Proxy;
    const Point out{ std::cos(angle), std::sin(angle), 0.0 };
    this->Follow(Line({ 0, 0, 0 }, { at.Tip * out[0], at.Tip * out[1], 0.0 }, 1000));
    vtkPolyData* const trace = this->Run(1001);
    // The cubic B-spline blurs f with a variance of q = h^2/3 along each axis, which changes f to f
    // + q/2 Laplace(f).
    const double blur =
      0.25 / 6.0 * (4.0 * at.Proxy * at.Proxy / 1e4 - 4.0 / 100.0) * (at.Proxy > 0.0 ? 1.0 : 0.0);
    const double force = (1.0 + blur) * at.Force;
    EXPECT_NEAR(Get(trace, "NormalForce", 1000), force, 0.005 * force) << at.Proxy;
    // The core line is located within 0.01 voxel. Elsewhere, the position depends on the strength.
    const double tolerance = at.Proxy == 0.0 ? 0.005 : 0.02;
    ExpectNear(LastProxy(trace), { at.Proxy * out[0], at.Proxy * out[1], 0.0 }, tolerance);
  }
  // A motion inwards must have no force.
  this->Follow(Line({ 15, 0, 0 }, { 2, 0, 0 }, 1000));
  EXPECT_LT(Get(this->Run(1001), "NormalForce", 1000), 1e-3);
}

TEST_F(FilterModeForms, FibresTurnAsInterpolatedTensorsDo)
{
  // Case P9: the fibres have the angle a in the lowest slice and b in the highest slice. At the
  // fraction t between the slices, their angle is atan2((1-t) sin 2a + t sin 2b, (1-t) cos 2a + t
  // cos 2b)/2. The hand pulls along x.
  struct Turned
  {
    double From, To, Share, Angle;
  };
  for (const Turned& of : { Turned{ 30, 0, 0.5, 15.0 }, Turned{ 60, 20, 0.25, 51.380 },
         Turned{ 80, 0, 0.25, 75.287 }, Turned{ 60, -60, 0.5, 90.0 } })
  {
    this->UseGrid({ 24, 24, 17 }, 1.0);
    this->AddArray("tensor", 6,
      [&](const Point& p, double* t)
      {
        const double share = (p[2] + 8.0) / 16.0;
        const double a = 2.0 * of.From * Turn / 360.0;
        const double b = 2.0 * of.To * Turn / 360.0;
        const double c = 0.4 * ((1.0 - share) * std::cos(a) + share * std::cos(b));
        const double s = 0.4 * ((1.0 - share) * std::sin(a) + share * std::sin(b));
        const double six[6] = { 0.6 + c, 0.6 - c, 0.1, s, 0.0, 0.0 };
        std::copy_n(six, 6, t);
      });
    this->Filter->RemoveAllModes();
    this->Filter->AddMode(NewMode(vtkHapticMode::TENSOR_FOLLOW, "tensor"));
    const double z = 16.0 * of.Share - 8.0;
    this->Follow(Line({ 0, 0, z }, { 2.0, 0, z }, 100));
    vtkPolyData* const trace = this->Run(101);
    // The proxy moves along the fibre by 2 mm times the cosine of the angle. The force across the
    // fibre is 1 N times the sine.
    const double angle = of.Angle * Turn / 360.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    ExpectNear(LastProxy(trace), { 2.0 * c * c, 2.0 * c * s, z }, 1e-4);
    ExpectNear(Last(trace, "Force"), { -s * s, s * c, 0.0 }, 1e-4);
  }
}

TEST_F(FilterModeForms, TurnWithVolumeAndPath)
{
  // Case P11: an image with rotated axes and the same samples must have rotated forces.
  const double rows[3][3] = { { 0.36, -0.8, 0.48 }, { 0.48, 0.6, 0.64 }, { -0.8, 0.0, 0.6 } };
  const auto turned = [&](const Point& p)
  {
    Point q;
    vtkMath::Multiply3x3(rows, p.data(), q.data());
    return q;
  };
  const std::vector<Point> tips = RandomWalk(2000, 0.2);
  std::vector<Point> turnedTips(tips.size());
  std::transform(tips.begin(), tips.end(), turnedTips.begin(), turned);
  const auto modes = this->UseSwirl();
  Point origin;
  this->Image->GetOrigin(origin.data());
  const Point turnedOrigin = turned(origin);
  for (const FeltMode& felt : modes)
  {
    vtkHapticMode* const mode = felt.Mode;
    mode->SetAxesToImage();
    SetGuide(mode, [](const Point& p) { return p; });
    this->Filter->RemoveAllModes();
    this->Filter->AddMode(mode);
    this->Image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
    this->Image->SetOrigin(origin.data());
    this->Follow(tips);
    const auto here = (this->Run(2001), Keep(this->Filter));
    this->Image->SetDirectionMatrix(&rows[0][0]);
    this->Image->SetOrigin(turnedOrigin.data());
    this->Follow(turnedTips);
    SetGuide(mode, turned);
    vtkPolyData* const there = this->Run(2001);
    double worst = 0.0;
    double strongest = 0.0;
    for (vtkIdType tick = 0; tick < 2001; ++tick)
    {
      const Point f = turned(ForceAt(here, tick));
      const Point g = ForceAt(there, tick);
      worst = std::max(worst, std::hypot(f[0] - g[0], f[1] - g[1], f[2] - g[2]));
      strongest = std::max(strongest, std::hypot(f[0], f[1], f[2]));
    }
    EXPECT_LT(worst, 1e-12) << mode->GetClassName();
    EXPECT_GT(strongest, 0.1) << mode->GetClassName();
  }
}

TEST_F(FilterModeForms, PullNoMoreThanTheirStrengths)
{
  // Case P11: each mode alone, and the largest set of modes that can be combined, must pull at most
  // with their strengths.
  const auto modes = this->UseSwirl();
  for (const FeltMode& felt : modes)
  {
    SetGuide(felt.Mode, [](const Point& p) { return p; });
  }
  for (const double stride : { 0.2, 3.0 }) // mm per tick: of a hand, or jumps
  {
    this->Follow(RandomWalk(20000, stride));
    for (std::size_t i = 0; i <= modes.size(); ++i)
    {
      this->Filter->RemoveAllModes();
      double sum = 0.0;
      for (std::size_t j = 0; j < modes.size(); ++j)
      {
        // Add one mode, or in the last round the flow's line, the vortex and the fibres, which have
        // eight primitives together.
        if (j == i || (i == modes.size() && j < 5 && j % 2 == 0))
        {
          this->Filter->AddMode(modes[j].Mode);
          sum += modes[j].Most;
        }
      }
      vtkPolyData* const trace = this->Run(20001);
      double strongest = 0.0;
      for (vtkIdType tick = 0; tick < 20001; ++tick)
      {
        strongest = std::max(strongest, Get(trace, "NormalForce", tick));
      }
      EXPECT_LE(strongest, sum * (1.0 + 1e-12)) << i;
      EXPECT_GT(strongest, 0.1) << i << " does pull";
    }
  }
}
