// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Units: what ServoRate, MetersPerWorldUnit, MaximumForce and the force field's constants mean.
 */

#include "Rigs/ApiRig.h"

#include <cmath>

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
};
} // namespace

TEST_F(FilterUnits, LifeSizeMillimetres)
{
  // T1: 1 N at 2 mm, 2 N at 4 mm and from there on.
  vtkPolyData* const output = this->Run(51);
  EXPECT_NEAR(this->Force(20), -1.0, 1e-9);
  EXPECT_NEAR(this->Force(40), -2.0, 1e-9);
  EXPECT_NEAR(this->Force(50), -2.0, 1e-9);
  EXPECT_NEAR(output->GetPoint(50)[2], 6.0, 1e-9);
  EXPECT_NEAR(Get(output, "GradientMagnitude", 1), 100.0, 1e-9);
}

TEST_F(FilterUnits, LargerIsNotStiffer)
{
  // Twice as large: the hand moves twice as far for the same way through the data.
  this->Filter->SetMetersPerWorldUnit(0.002);
  vtkPolyData* const output = this->Run(51);
  EXPECT_EQ(Get(output, "Stiffness", 10), 500.0);
  EXPECT_NEAR(this->Force(10), -1.0, 1e-9) << "1 mm of data is 2 mm of the hand";
  EXPECT_NEAR(this->Force(20), -2.0, 1e-9);
  EXPECT_NEAR(Get(output, "GradientMagnitude", 10), 100.0, 1e-9) << "per world unit";
  EXPECT_EQ(Get(output, "Tip", 20, 2), 7.0);
  // The same motion of the hand gives the same forces.
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
  // 0.1 mm a tick: 0.1 m/s at 1 kHz.
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
