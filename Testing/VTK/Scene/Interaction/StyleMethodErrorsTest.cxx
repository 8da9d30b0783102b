// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that the current method remains if the next method can't be used. */

#include "StyleRig.h"
#include "VTK/Scene/Display/DisplayProbe.h"

#include <vtkHapticHeadUpDisplay.h>

using namespace scenetest;

namespace
{
class StyleMethodErrors : public StyleTest
{
protected:
  /// Starts with a force field. The next method, Surface Proxy, has no surface at this isovalue.
  void Begin()
  {
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
    this->Filter->SetMethodToForceField();
    this->Filter->SetIsoValue(1e6);
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetPosition(0.0, 0.0, 28.0);
    ASSERT_TRUE(this->Device->Start());
    this->Run(5);
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  MessageLog FilterLog{ this->Filter };
};
} // namespace

TEST_F(StyleMethodErrors, TheMethodBeforeStays)
{
  this->Begin();
  const double force = this->Device->GetState()->GetComputedForce()[2];
  ASSERT_GT(force, 0.5);
  EXPECT_FALSE(this->Style->NextMethod());
  ASSERT_EQ(this->FilterLog.Errors.size(), 1U);
  EXPECT_NE(this->FilterLog.Errors[0].find("SetIsoValue()"), std::string::npos);
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  for (const char* words : { "Surface proxy can't be felt", "Force field goes on" })
  {
    EXPECT_NE(this->Log.Errors[0].find(words), std::string::npos) << this->Log.Errors[0];
    EXPECT_NE(this->Display->GetText().find(words), std::string::npos) << this->Display->GetText();
  }
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::FORCE_FIELD);
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "Force field");
  this->Run(5);
  EXPECT_EQ(this->Device->GetState()->GetComputedForce()[2], force);
  EXPECT_EQ(this->FilterLog.Errors.size(), 1U) << "one error is enough";
  EXPECT_NE(this->Display->GetText().find("goes on"), std::string::npos) << "still to be read";
}

TEST_F(StyleMethodErrors, IsNotToldAnyMoreWhenTheNextChangeIsFelt)
{
  this->Begin();
  this->Filter->SetCouplingStiffness(1.1 * this->Filter->GetCouplingStiffness()); // not published
  EXPECT_FALSE(this->Style->NextMethod());
  EXPECT_NE(std::string(this->Display->GetNotice()), "");
  this->Style->UpdateHaptics();
  EXPECT_STREQ(this->Display->GetNotice(), "");
}

TEST_F(StyleMethodErrors, IsPassedOverTheNextTimeAndTriedAgainLater)
{
  this->Begin();
  EXPECT_FALSE(this->Style->NextMethod());
  EXPECT_TRUE(this->Style->NextMethod());
  EXPECT_NE(this->Filter->GetMethod(), vtkVolumeHapticsFilter::FORCE_FIELD);
  EXPECT_NE(this->Filter->GetMethod(), vtkVolumeHapticsFilter::SURFACE_PROXY);
  EXPECT_STREQ(this->Display->GetNotice(), "");
  this->Filter->SetMethodToForceField();
  this->Filter->SetIsoValue(0.0);
  EXPECT_TRUE(this->Style->NextMethod());
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::SURFACE_PROXY);
}

TEST_F(StyleMethodErrors, CodeThatChoosesWhatCannotBeFeltDoesNotChangeTheTitle)
{
  this->Begin();
  this->Filter->SetMethodToSurfaceProxy();
  this->Style->UpdateHaptics();
  EXPECT_EQ(this->FilterLog.Errors.size(), 1U);
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "Force field")
    << "the servo goes on with it";
  EXPECT_FALSE(this->Filter->SetMethodByName("surface"));
  ASSERT_EQ(this->FilterLog.Errors.size(), 2U);
  EXPECT_NE(this->FilterLog.Errors[1].find("\"surface-proxy\""), std::string::npos);
  EXPECT_EQ(this->Filter->GetMethodName(), "surface-proxy");
}

TEST_F(StyleMethodErrors, WithoutAFilterThereIsNothingToChange)
{
  this->Device->SetVolumeHaptics(nullptr);
  EXPECT_FALSE(this->Style->NextMethod());
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("SetVolumeHaptics()"), std::string::npos);
  EXPECT_EQ(this->Device->GetMethodText(), "");
}
