// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a property's tissues: their names and ranges, and their materials in the functions. Ramps
 * are straight lines, whose values are computed by hand.
 */

#include "Rigs/ApiRig.h"

#include <cmath>
#include <limits>

using namespace apitest;

namespace
{
class Tissues : public testing::Test
{
protected:
  bool Says(const std::string& words)
  {
    return !this->Log.Errors.empty() && this->Log.Errors.back().find(words) != std::string::npos;
  }

  vtkNew<vtkHapticProperty> Property;
  MessageLog Log{ this->Property };
};
} // namespace

TEST_F(Tissues, StandInTheOrderOfTheirValues)
{
  EXPECT_EQ(this->Property->AddTissue("bone", 300.0, 3000.0), 0);
  const vtkMTimeType before = this->Property->GetMTime();
  EXPECT_EQ(this->Property->AddTissue("air", -1000.0, -900.0), 0);
  EXPECT_GT(this->Property->GetMTime(), before);
  EXPECT_EQ(this->Property->AddTissue("water", 0.0, 0.0), 1) << "one value";
  ASSERT_EQ(this->Property->GetNumberOfTissues(), 3);
  EXPECT_STREQ(this->Property->GetTissueName(0), "air");
  EXPECT_STREQ(this->Property->GetTissueName(2), "bone");
  double range[2];
  this->Property->GetTissueRange(2, range);
  EXPECT_EQ(range[0], 300.0);
  EXPECT_EQ(range[1], 3000.0);
  vtkNew<vtkHapticProperty> copy;
  copy->DeepCopy(this->Property);
  this->Property->RemoveAllTissues();
  EXPECT_EQ(this->Property->GetNumberOfTissues(), 0);
  ASSERT_EQ(copy->GetNumberOfTissues(), 3);
  EXPECT_STREQ(copy->GetTissueName(1), "water");
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(Tissues, ThatAreNoneAreErrors)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double inf = std::numeric_limits<double>::infinity();
  this->Property->AddTissue("fat", -150.0, -80.0);
  const vtkMTimeType before = this->Property->GetMTime();
  EXPECT_EQ(this->Property->AddTissue("", 0.0, 1.0), -1);
  EXPECT_TRUE(this->Says("needs a name"));
  EXPECT_EQ(this->Property->AddTissue(nullptr, 0.0, 1.0), -1);
  EXPECT_EQ(this->Property->AddTissue("fat", 0.0, 1.0), -1);
  EXPECT_TRUE(this->Says("the name or values of the tissue \"fat\", -150 to -80"));
  EXPECT_EQ(this->Property->AddTissue("other", -80.0, 1.0), -1) << "a value of both";
  for (const double bad : { nan, inf, -inf })
  {
    EXPECT_EQ(this->Property->AddTissue("other", bad, 1.0), -1);
    EXPECT_EQ(this->Property->AddTissue("other", 0.0, bad), -1);
  }
  EXPECT_EQ(this->Property->AddTissue("other", 1.0, 0.0), -1);
  EXPECT_TRUE(this->Says("the lower one first"));
  EXPECT_EQ(this->Log.Errors.size(), 11U) << "one each";
  for (const int tissue : { -1, 1, 100 })
  {
    double range[2] = { 7.0, 8.0 };
    EXPECT_STREQ(this->Property->GetTissueName(tissue), "");
    this->Property->GetTissueRange(tissue, range);
    EXPECT_EQ(range[0], 7.0);
    EXPECT_EQ(this->Property->GetTissueStiffness(tissue), 0.0);
    this->Property->SetTissueStiffness(tissue, 300.0);
  }
  EXPECT_EQ(this->Property->GetMTime(), before);
}

TEST_F(Tissues, OfAPresetHaveItsMaterials)
{
  ASSERT_TRUE(this->Property->ApplyPreset("CT contrast"));
  ASSERT_EQ(this->Property->GetNumberOfTissues(), 7);
  EXPECT_STREQ(this->Property->GetTissueName(2), "fat");
  // The expected values are in a table of Documentation/materials.md.
  EXPECT_DOUBLE_EQ(this->Property->GetTissueStiffness(2), 400.0);
  EXPECT_DOUBLE_EQ(this->Property->GetTissueFriction(2), 0.18);
  EXPECT_DOUBLE_EQ(this->Property->GetTissueViscosity(2), 0.30);
  EXPECT_DOUBLE_EQ(this->Property->GetTissueSurfaceStrength(2), 1.0);
}

TEST_F(Tissues, ChangeAloneAndOnRamps)
{
  ASSERT_TRUE(this->Property->ApplyPreset("CT contrast"));
  vtkNew<vtkHapticProperty> before;
  before->DeepCopy(this->Property);
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  strength->AddPoint(-100.0, 9.0); // a bump inside fat, which the change removes
  this->Property->SetTissueSurfaceStrength(2, 1.4);
  EXPECT_EQ(this->Property->GetSurfaceStrength(), strength) << "in place";
  for (double value = -1100.0; value < 3200.0; value += 1.0)
  {
    const double was = before->GetSurfaceStrength()->GetValue(value);
    double expected = was;
    if (value >= -150.0 && value <= -80.0)
    {
      expected = 1.4;
    }
    else if (value > -300.0 && value < -150.0) // on the ramp from lung, whose strength is 0
    {
      expected = (value + 300.0) / 150.0 * 1.4;
    }
    else if (value > -80.0 && value < -10.0) // on the ramp to fluid, whose strength is 1.5 N
    {
      expected = 1.4 + (value + 80.0) / 70.0 * 0.1;
    }
    ASSERT_NEAR(strength->GetValue(value), expected, 1e-12) << value;
    ASSERT_EQ(
      this->Property->GetFriction()->GetValue(value), before->GetFriction()->GetValue(value));
  }
  const vtkMTimeType time = this->Property->GetMTime();
  this->Property->SetTissueSurfaceStrength(2, 1.4);
  EXPECT_EQ(this->Property->GetMTime(), time) << "the same value";
}

TEST_F(Tissues, AtTheEndsGoOnForever)
{
  ASSERT_TRUE(this->Property->ApplyPreset("CT contrast"));
  this->Property->SetTissueFriction(0, 0.7);
  this->Property->SetTissueFriction(6, 0.9);
  EXPECT_DOUBLE_EQ(this->Property->GetFriction()->GetValue(-5000.0), 0.7);
  EXPECT_DOUBLE_EQ(this->Property->GetFriction()->GetValue(9000.0), 0.9);
  EXPECT_DOUBLE_EQ(this->Property->GetFriction()->GetValue(200.0), 0.25) << "its neighbour";
}

TEST_F(Tissues, GiveAnEmptyFunctionItsFirstPoints)
{
  this->Property->AddTissue("soft", 0.0, 10.0);
  this->Property->AddTissue("middle", 20.0, 30.0);
  this->Property->AddTissue("hard", 40.0, 50.0);
  EXPECT_EQ(this->Property->GetTissueStiffness(1), 500.0) << "the default of the class comment";
  EXPECT_EQ(this->Property->GetTissueSurfaceStrength(1), 2.0);
  this->Property->SetTissueStiffness(1, 100.0);
  vtkPiecewiseFunction* const k = this->Property->GetStiffness();
  for (const auto& [value, expected] : std::vector<std::pair<double, double>>{ { -99.0, 500.0 },
         { 10.0, 500.0 }, { 15.0, 300.0 }, { 25.0, 100.0 }, { 35.0, 300.0 }, { 99.0, 500.0 } })
  {
    EXPECT_NEAR(k->GetValue(value), expected, 1e-12) << value;
  }
}
