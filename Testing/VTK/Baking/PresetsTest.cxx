// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The presets, against the specification's table of tissues.
 */

#include "Rigs/ApiRig.h"

#include <vtkStringArray.h>

using namespace apitest;

namespace
{
struct Tissue
{
  const char* Name;
  double Low, High; // HU
  double Stiffness, Friction, Viscosity, SurfaceStrength;
};

/// Bone starts a little above 300 HU, the end of contrast medium.
const Tissue Contrast[] = {
  { "air", -3000.0, -960.0, 0.0, 0.0, 0.0, 0.0 },
  { "lung", -950.0, -500.0, 80.0, 0.10, 0.05, 0.3 },
  { "fat", -150.0, -30.0, 150.0, 0.15, 0.2, 0.7 },
  { "fluid", -10.0, 15.0, 100.0, 0.05, 0.3, 0.1 },
  { "muscle, organ", 20.0, 80.0, 350.0, 0.25, 0.4, 1.5 },
  { "contrast medium", 100.0, 300.0, 600.0, 0.20, 0.4, 2.5 },
};

class Presets : public testing::Test
{
protected:
  vtkNew<vtkHapticProperty> Property;
  MessageLog Log{ this->Property };
};

void ExpectNear(vtkPiecewiseFunction* function, const Tissue& tissue, double expected)
{
  for (int i = 0; i <= 20; ++i)
  {
    const double hu = tissue.Low + i * (tissue.High - tissue.Low) / 20.0;
    EXPECT_NEAR(function->GetValue(hu), expected, 1e-12) << tissue.Name << " at " << hu << " HU";
  }
}
} // namespace

TEST_F(Presets, ContrastIsTheSpecificationsTable)
{
  vtkPiecewiseFunction* const stiffness = this->Property->GetStiffness();
  stiffness->AddPoint(-5000.0, 77.0);
  stiffness->ClampingOff();
  ASSERT_TRUE(this->Property->ApplyPreset("CT contrast"));
  EXPECT_EQ(this->Property->GetStiffness(), stiffness) << "filled in place";
  for (const Tissue& tissue : Contrast)
  {
    ExpectNear(this->Property->GetStiffness(), tissue, tissue.Stiffness);
    ExpectNear(this->Property->GetFriction(), tissue, tissue.Friction);
    ExpectNear(this->Property->GetViscosity(), tissue, tissue.Viscosity);
    ExpectNear(this->Property->GetSurfaceStrength(), tissue, tissue.SurfaceStrength);
  }
  for (const double bone : { 310.0, 1200.0, 3071.0, 30000.0 })
  {
    const double k = this->Property->GetStiffness()->GetValue(bone);
    EXPECT_TRUE(k > 600.0 && k <= 1000.0) << "stiffest, and at most 2b/T";
    EXPECT_DOUBLE_EQ(this->Property->GetFriction()->GetValue(bone), 0.30);
    EXPECT_EQ(this->Property->GetViscosity()->GetValue(bone), 0.0);
    EXPECT_GT(this->Property->GetSurfaceStrength()->GetValue(bone), 1e3) << "impenetrable";
  }
  EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::HIGHER);
}

TEST_F(Presets, PhysicalHasThePublishedLiver)
{
  ASSERT_TRUE(this->Property->ApplyPreset("CT physical"));
  // 2 E a / (1 - nu^2) for a shear modulus of 1.8 kPa and a = 2 mm.
  EXPECT_NEAR(this->Property->GetStiffness()->GetValue(55.0), 28.0, 1.0);
  const double friction = this->Property->GetFriction()->GetValue(1000.0);
  EXPECT_TRUE(friction >= 0.29 && friction <= 0.36) << "bone on muscle";
}

TEST_F(Presets, EveryPresetMakesSense)
{
  vtkStringArray* const names = vtkHapticProperty::GetPresetNames();
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->LookupValue("CT contrast"), 0) << "the default comes first";
  EXPECT_GE(names->LookupValue("CT physical"), 0);
  EXPECT_GE(names->LookupValue("MRI"), 0);
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    SCOPED_TRACE(names->GetValue(i));
    vtkNew<vtkHapticProperty> used;
    used->SetSurfaceSideToLower();
    used->GetStiffness()->UseLogScaleOn();
    ASSERT_TRUE(this->Property->ApplyPreset(names->GetValue(i).c_str()));
    ASSERT_TRUE(used->ApplyPreset(names->GetValue(i).c_str()));
    EXPECT_EQ(used->GetSurfaceSide(), this->Property->GetSurfaceSide());
    for (double value = -1100.0; value < 3200.0; value += 7.0)
    {
      const double k = this->Property->GetStiffness()->GetValue(value);
      EXPECT_TRUE(k >= 0.0 && k <= 1000.0 + 1e-9) << value;
      EXPECT_EQ(used->GetStiffness()->GetValue(value), k) << "whatever was there before";
    }
    vtkPiecewiseFunction* const distinct = this->Property->GetDistinctness();
    EXPECT_EQ(distinct->GetValue(0.0), 0.0);
    EXPECT_EQ(distinct->GetValue(1e4), 1.0);
  }
  EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::BOTH) << "MRI came last";
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(Presets, UnknownNamesChangeNothing)
{
  this->Property->ApplyPreset("CT contrast");
  const vtkMTimeType before = this->Property->GetMTime();
  for (const char* const name : { "ct contrast", "", "CT", static_cast<const char*>(nullptr) })
  {
    this->Log.Errors.clear();
    EXPECT_FALSE(this->Property->ApplyPreset(name));
    EXPECT_EQ(this->Property->GetMTime(), before);
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find("\"CT physical\""), std::string::npos);
  }
}
