// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that SameShape applies one stiffness everywhere, with every method that has a spring. */

#include "Rigs/ApiRig.h"
#include "VTK/Filter/PlannerSettings.h"
#include "VTK/Regions/RegionPlanner.h"

using namespace apitest;

namespace
{
class SameShape : public ApiTest
{
protected:
  SameShape()
  {
    // The stiffness increases from 80 N/m at the value 700 to 400 N/m at the value 1300. The image
    // V = 100 z contains all these values.
    this->Property->GetStiffness()->AddPoint(700.0, 80.0);
    this->Property->GetStiffness()->AddPoint(1300.0, 400.0);
    this->Filter->SetIsoValue(800.0);
  }
};
} // namespace

TEST_F(SameShape, IsTheStiffnessOfEveryMethod)
{
  const std::pair<const char*, double> methods[] = { { "proxy", -2.0 }, { "paper", -2.0 },
    { "surface-proxy", 0.0 }, { "local-surface", 0.0 } };
  for (const auto& [method, force] : methods)
  {
    SCOPED_TRACE(method);
    ASSERT_TRUE(this->Filter->SetMethodByName(method));
    this->Filter->SameShapeOff();
    const double own = Get(this->Run(51), "Stiffness", 50);
    EXPECT_LT(own, 400.0) << "the function's";
    EXPECT_NE(own, 321.0);
    this->Filter->SameShapeOn();
    this->Filter->SetCouplingStiffness(321.0);
    vtkPolyData* const output = this->Run(51);
    EXPECT_EQ(Get(output, "Stiffness", 50), 321.0);
    const double lag = Get(output, "Tip", 50, 2) - output->GetPoint(50)[2];
    EXPECT_GT(lag, 0.5);
    EXPECT_NEAR(Get(output, "Force", 50, 2), -0.321 * lag, 1e-9);
    if (force < 0.0)
    {
      // Case T1 of Documentation/evaluation.md: at the end of the path, the surface strength limits
      // the force.
      this->Filter->SetCouplingStiffness(500.0);
      EXPECT_NEAR(Get(this->Run(51), "Force", 50, 2), force, 1e-9);
    }
    this->Filter->SetMaximumStiffness(200.0);
    EXPECT_EQ(Get(this->Run(51), "Stiffness", 50), 200.0) << "the cap holds";
    this->Filter->SetMaximumStiffness(0.0);
  }
}

TEST_F(SameShape, IsWhatASpringOfThatStiffnessGives)
{
  this->Filter->SameShapeOn();
  const auto one = (this->Run(51), Keep(this->Filter));
  this->Filter->SameShapeOff();
  const auto own = (this->Run(51), Keep(this->Filter));
  EXPECT_FALSE(IsSame(one, own));
  // Without points, the stiffness is 500 N/m, like the default of the coupling stiffness.
  this->Property->GetStiffness()->RemoveAllPoints();
  this->Run(51);
  EXPECT_TRUE(IsSame(this->Filter->GetOutput(), one));
  this->Filter->SetCouplingStiffness(100.0);
  this->Run(51);
  EXPECT_TRUE(IsSame(this->Filter->GetOutput(), one)) << "of no use while it is off";
}

TEST_F(SameShape, HidesIsosurfacesWithoutStiffness)
{
  SetConstant(this->Property->GetStiffness(), 0.0);
  this->Filter->SameShapeOn();
  for (const char* const method : { "proxy", "paper", "surface-proxy", "local-surface" })
  {
    ASSERT_TRUE(this->Filter->SetMethodByName(method));
    vtkPolyData* const output = this->Run(51);
    for (vtkIdType tick = 0; tick < 51; ++tick)
    {
      EXPECT_EQ(Get(output, "Force", tick, 2), 0.0) << method;
    }
  }
}

TEST_F(SameShape, DecidesHowFarASpringOfARegionReaches)
{
  VolumeHaptics::RegionPlanner planner;
  VolumeHaptics::ConfigurePlanner(planner, this->Filter);
  EXPECT_DOUBLE_EQ(planner.SpringLength, 1000.0 * 2.0 / 80.0);
  this->Filter->SameShapeOn();
  VolumeHaptics::ConfigurePlanner(planner, this->Filter);
  EXPECT_DOUBLE_EQ(planner.SpringLength, 4.0) << "2 N and 500 N/m";
}
