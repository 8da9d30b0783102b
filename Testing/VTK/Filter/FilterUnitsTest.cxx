// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the units of ServoRate, MetersPerWorldUnit, MaximumForce and the constants of the force
 * field.
 */

#include "Rigs/ApiRig.h"

#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace apitest;

namespace
{
class FilterUnits : public ApiTest
{
protected:
  double Force(vtkIdType tick, int axis = 2)
  {
    return Get(this->Filter->GetOutput(), "Force", tick, axis);
  }

  /**
   * Sets a ball with a radius of 7 mm around (12, 12, 12) mm, with the value `high` in surroundings
   * of the value `low`. Also sets a path that presses 2 mm into the ball and slides. One millimetre
   * has `units` world units, and the ball is touched at life size.
   */
  void SetBall(double units, double low, double high)
  {
    std::uint32_t random = 1;
    this->Image = MakeImage(25, VTK_DOUBLE,
      [&](const Point& p)
      {
        random = random * 1664525U + 1013904223U;
        const double noise =
          2e-3 * (high - low) * (static_cast<double>(random >> 8) * 0x1p-24 - 0.5);
        const double r = std::hypot(p[0] - 12.0, p[1] - 12.0, p[2] - 12.0);
        return low + (high - low) * 0.5 * std::erfc((r - 7.0) / 0.9) + noise;
      });
    this->Image->SetSpacing(units, units, units);
    this->Filter->SetInputDataObject(0, this->Image);
    this->Filter->SetMetersPerWorldUnit(1e-3 / units);
    std::vector<Point> points = Line({ 12.6, 11.3, 2 }, { 12.6, 11.3, 7 }, 50);
    const std::vector<Point> slide = Line({ 12.7, 11.3, 7 }, { 14.6, 11.3, 7 }, 20);
    points.insert(points.end(), slide.begin(), slide.end());
    for (Point& point : points)
    {
      for (double& x : point)
      {
        x *= units;
      }
    }
    this->Filter->SetPathData(MakePath(points));
    if (this->IsFitted)
    {
      this->Property->ApplyPreset("MRI", this->Image);
    }
  }

  bool IsFitted = false; ///< applies the preset "MRI" to each ball

  /**
   * Expects that presses into the ball have the same forces in worlds with other units as in mm.
   * Powers of two as units cause no rounding errors, and decimal units at most `rounded` (N).
   */
  void ExpectSameForces(double low, double high, double leastForce, double rounded = 1e-9)
  {
    this->SetBall(1.0, low, high);
    const auto millimeters = (this->Run(72), Keep(this->Filter));
    double most = 0.0;
    struct World
    {
      double Units;
      double Tolerance; // N, error of the expected force
    };
    const World worlds[] = { { 1024.0, 1e-9 }, { 0.125, 1e-9 }, { 0x1p-10, 1e-9 },
      { 0x1p-20, 1e-9 }, { 1e3, rounded }, { 0.1, rounded }, { 1e-3, rounded }, { 1e-6, rounded },
      { 1.0 + 0x1p-51, rounded } };
    for (const World& world : worlds)
    {
      SCOPED_TRACE(testing::Message() << world.Units << " units to a millimetre");
      this->SetBall(world.Units, low, high);
      this->Run(72);
      for (vtkIdType tick = 0; tick < 72; ++tick)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const double expected = Get(millimeters, "Force", tick, axis);
          EXPECT_NEAR(this->Force(tick, axis), expected, world.Tolerance) << "tick " << tick;
          most = std::max(most, std::abs(expected));
        }
      }
    }
    EXPECT_GE(most, leastForce);
  }
};
} // namespace

TEST_F(FilterUnits, LifeSizeMillimetres)
{
  // Case T1: the force is 1 N at 2 mm, and 2 N at 4 mm or more.
  vtkPolyData* const output = this->Run(51);
  EXPECT_NEAR(this->Force(20), -1.0, 1e-9);
  EXPECT_NEAR(this->Force(40), -2.0, 1e-9);
  EXPECT_NEAR(this->Force(50), -2.0, 1e-9);
  EXPECT_NEAR(output->GetPoint(50)[2], 6.0, 1e-9);
  EXPECT_NEAR(Get(output, "GradientMagnitude", 1), 100.0, 1e-9);
}

TEST_F(FilterUnits, LargerIsNotStiffer)
{
  // The data are twice as large as before, so the hand moves twice as far through them.
  this->Filter->SetMetersPerWorldUnit(0.002);
  vtkPolyData* const output = this->Run(51);
  EXPECT_EQ(Get(output, "Stiffness", 10), 500.0);
  EXPECT_NEAR(this->Force(10), -1.0, 1e-9) << "1 mm of data is 2 mm of the hand";
  EXPECT_NEAR(this->Force(20), -2.0, 1e-9);
  EXPECT_NEAR(Get(output, "GradientMagnitude", 10), 100.0, 1e-9) << "per world unit";
  EXPECT_EQ(Get(output, "Tip", 20, 2), 7.0);
  // The same motion of the hand must give the same forces.
  const auto twice = Keep(this->Filter);
  this->Filter->SetMetersPerWorldUnit(0.001);
  this->Filter->SetPathData(MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 25)));
  this->Run(26);
  for (const vtkIdType tick : { 1, 5, 9, 20 })
  {
    EXPECT_NEAR(this->Force(tick), Get(twice, "Force", tick, 2), 1e-9);
  }
}

TEST_F(FilterUnits, ForceFieldIsEquationOne)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.005);
  this->Filter->SetForceFieldDamping(2.0);
  vtkPolyData* const output = this->Run(51);
  EXPECT_EQ(this->Force(0), 0.0) << "the first tick enables";
  // The tip moves 0.1 mm per tick of 1 ms, so its speed is 0.1 m/s.
  EXPECT_NEAR(this->Force(10), -0.005 * 100.0 - 2.0 * 0.1, 1e-9);
  EXPECT_NEAR(Get(output, "NormalForce", 10), 0.5, 1e-9);
  EXPECT_NEAR(Get(output, "DragForce", 10), 0.2, 1e-9);
  EXPECT_EQ(output->GetPoint(10)[2], Get(output, "Tip", 10, 2)) << "there is no proxy";
  EXPECT_EQ(Get(output, "Contact", 10), 0.0);

  this->Filter->SetServoRate(250.0);
  this->Run(51);
  EXPECT_NEAR(this->Force(10), -0.5 - 2.0 * 0.025, 1e-9) << "the same step in four times the time";
  this->Filter->SetMetersPerWorldUnit(0.01);
  this->Run(51);
  EXPECT_NEAR(this->Force(10), -0.5 - 2.0 * 0.25, 1e-9) << "the hand moves ten times as fast";
}

TEST_F(FilterUnits, ForceFieldSideways)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(-0.01);
  this->Filter->SetForceFieldDamping(1.0);
  this->Filter->SetPathData(MakePath({ { 7, 7, 7 }, { 7.3, 6.9, 7 }, { 7.3, 6.9, 7 } }));
  this->Run(3);
  EXPECT_NEAR(this->Force(1, 0), -0.3, 1e-9);
  EXPECT_NEAR(this->Force(1, 1), 0.1, 1e-9);
  EXPECT_NEAR(this->Force(1, 2), 1.0, 1e-9) << "a negative gain attracts";
  EXPECT_NEAR(this->Force(2, 0), 0.0, 1e-12) << "at rest there is no damping";
}

TEST_F(FilterUnits, ProxyDoesNotDependOnTheServoRate)
{
  const auto fast = (this->Run(51), Keep(this->Filter));
  this->Filter->SetServoRate(100.0);
  vtkPolyData* const slow = this->Run(51);
  for (const vtkIdType tick : { 1, 20, 50 })
  {
    EXPECT_EQ(Get(slow, "Force", tick, 2), Get(fast, "Force", tick, 2));
  }
}

TEST_F(FilterUnits, MaximumForceInNewtons)
{
  this->Filter->SetMaximumForce(1.5);
  vtkPolyData* const output = this->Run(51);
  EXPECT_NEAR(this->Force(20), -1.0, 1e-9);
  EXPECT_NEAR(this->Force(40), -1.5, 1e-12);
  EXPECT_NEAR(Get(output, "NormalForce", 40), 2.0, 1e-9) << "what the surface pushes with";
  EXPECT_NEAR(output->GetPoint(50)[2], 6.0, 1e-9) << "the proxy does not care";
}

TEST_F(FilterUnits, MaximumStiffnessCapsTheMaterial)
{
  this->Filter->SetMaximumStiffness(200.0);
  vtkPolyData* const output = this->Run(51);
  EXPECT_EQ(Get(output, "Stiffness", 10), 200.0);
  EXPECT_NEAR(this->Force(10), -0.2, 1e-9);
  this->Filter->SetMaximumStiffness(600.0);
  EXPECT_EQ(Get(this->Run(51), "Stiffness", 10), 500.0);
}

// The same bodies and the same motion must give the same forces in any unit of length.
TEST_F(FilterUnits, PresetsFeelTheSameInAWorldOfAnyUnit)
{
  vtkStringArray* const names = vtkHapticProperty::GetPresetNames();
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const vtkStdString name = names->GetValue(i);
    if (name == "Labels")
    {
      continue; // its walls are between integer values, where values have no gradient
    }
    this->Property->ApplyPreset(name.c_str());
    for (const int solver : { vtkVolumeHapticsFilter::PAPER, vtkVolumeHapticsFilter::PRECISE })
    {
      SCOPED_TRACE(testing::Message() << name << ", solver " << solver);
      this->Filter->SetSolver(solver);
      const bool isGrey = name == "MRI" || name == "Micro-CT";
      // PAPER reads the material before it moves the proxy, so rounding errors grow where a
      // two-sided surface switches its side.
      const bool isPaper = solver == vtkVolumeHapticsFilter::PAPER;
      this->ExpectSameForces(isGrey ? 0.0 : -1000.0, isGrey ? 200.0 : 60.0, 0.02,
        isPaper && name == "MRI" ? 2e-7 : 1e-9);
    }
  }
}

TEST_F(FilterUnits, PresetsFittedToAnImageFeelTheSameInAWorldOfAnyUnit)
{
  this->IsFitted = true;
  for (const int solver : { vtkVolumeHapticsFilter::PAPER, vtkVolumeHapticsFilter::PRECISE })
  {
    SCOPED_TRACE(solver);
    this->Filter->SetSolver(solver);
    this->ExpectSameForces(0.0, 40.0, 0.1);
    EXPECT_FALSE(this->Property->GetDistinctnessPerMillimeter()) << "not fitted";
  }
}

TEST_F(FilterUnits, MethodsFeelTheSameInAWorldOfAnyUnit)
{
  this->Property->ApplyPreset("CT contrast");
  this->Filter->SetIsoValue(-400.0);
  for (const int method :
    { vtkVolumeHapticsFilter::SURFACE_PROXY, vtkVolumeHapticsFilter::LOCAL_SURFACE })
  {
    SCOPED_TRACE(method);
    this->Filter->SetMethod(method);
    this->ExpectSameForces(-1000.0, 60.0, 0.1);
  }
}

TEST_F(FilterUnits, DistinctnessOfOnesOwnIsPerWorldUnit)
{
  // A gradient of 100 per millimetre has the distinctness 0.5.
  this->Property->GetDistinctness()->AddPoint(50.0, 0.0);
  this->Property->GetDistinctness()->AddPoint(150.0, 1.0);
  this->Run(51);
  EXPECT_NEAR(this->Force(50), -1.0, 1e-9);
  this->Filter->SetMetersPerWorldUnit(1e-4);
  this->Filter->SetPathData(MakePath(Line({ 7, 7, 3 }, { 7, 7, 13 }, 100)));
  this->Property->GetStiffness()->AddPoint(0.0, 5000.0);
  this->Run(101);
  EXPECT_NEAR(this->Force(100), -1.0, 1e-9);
  this->Property->DistinctnessPerMillimeterOn();
  this->Run(101);
  EXPECT_NEAR(this->Force(100), -2.0, 1e-9) << "1000 a millimetre";
}
