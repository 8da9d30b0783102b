// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests homing: the instructions to the user, the time limit, and repeated homing. */

#include "Rigs/FalconRig.h"

using namespace emulated;

class FalconHomes : public FalconTest
{
};

TEST_F(FalconHomes, StepByStep)
{
  ASSERT_TRUE(this->Open()) << this->Error;
  ASSERT_TRUE(this->IsAt(DeviceStage::Homing));
  EXPECT_TRUE(Eventually([&] { return Has(this->GetText(), "fully out"); })) << this->GetText();
  DeviceSample sample;
  EXPECT_EQ(this->Device->Read(0.001, sample), DeviceState::NotReady);
  this->LeadTo({ 0.0, 0.0, 0.1735 });
  this->LeadTo({ 0.0, 0.0, 0.08 });
  EXPECT_TRUE(Eventually([&] { return Has(this->GetText(), "Pull the grip out"); }))
    << this->GetText();
  EXPECT_EQ(this->Device->Read(0.001, sample), DeviceState::NotReady);
  EXPECT_TRUE(this->StaysAtZero(30)) << "whatever the servo gives";
  this->LeadTo(Rest);
  ASSERT_TRUE(this->IsAt(DeviceStage::Ready));

  ASSERT_TRUE(Eventually(
    [&] { return this->Device->Read(0.001, sample) == DeviceState::Running && sample.Fresh; }));
  EXPECT_NEAR(sample.Tip.X, 0.0, 1e-3);
  EXPECT_NEAR(sample.Tip.Z, 0.047, 2e-3) << "from the middle of the workspace";
}

TEST_F(FalconHomes, TheFirstSampleBegins)
{
  ASSERT_TRUE(this->Open()) << this->Error;
  this->Home();
  for (int round = 0; round < 2; ++round)
  {
    DeviceSample sample;
    const auto isFresh = [&]
    {
      sample = {};
      return this->Device->Read(0.001, sample) == DeviceState::Running && sample.Fresh;
    };
    ASSERT_TRUE(Eventually(isFresh));
    EXPECT_TRUE(sample.Begins);
    EXPECT_NEAR(sample.Tip.Z, this->Falcon.GetGrip()[2] - 0.125, 2e-3) << "not an old one";
    ASSERT_TRUE(Eventually(isFresh));
    EXPECT_FALSE(sample.Begins);
    this->Device->Home();
    ASSERT_TRUE(
      Eventually([&] { return this->Device->Read(0.001, sample) == DeviceState::NotReady; }));
    // The grip is already out and the encoders are homed, so the device is ready at once.
    ASSERT_TRUE(this->IsAt(DeviceStage::Ready)) << this->GetText();
  }
}

TEST_F(FalconHomes, TimeIsUp)
{
  this->Options.HomingTime = 1.0;
  ASSERT_TRUE(this->Open()) << this->Error;
  ASSERT_TRUE(this->IsAt(DeviceStage::Lost));
  EXPECT_TRUE(Has(this->GetText(), "in time")) << this->GetText();
  EXPECT_TRUE(Has(this->GetText(), "Home() to try again")) << this->GetText();
  EXPECT_TRUE(this->StaysAtZero(30));
  this->Device->Home();
  EXPECT_TRUE(this->IsAt(DeviceStage::Homing));
  EXPECT_TRUE(this->IsAt(DeviceStage::Lost)) << "its time is limited again";
}

TEST_F(FalconHomes, AgainWhileForceFlows)
{
  this->MakeReady();
  ASSERT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
  this->Device->Home();
  ASSERT_TRUE(this->IsAt(DeviceStage::Homing));
  EXPECT_TRUE(this->StaysAtZero(30));
  this->Home();
  EXPECT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
}
