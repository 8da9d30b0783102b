// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Moves a hand on an arm of a simulated Inverse service. Positions and forces are sent over real
 * WebSockets of this computer. The service is written from Haply's documentation (see
 * Emulators/HaplyService.h). On the floor, the hand's spring and the floor's spring must balance.
 */

#include "HaplyRig.h"

using namespace emulated;

namespace
{
class HaplySessions : public HaplyTest
{
protected:
  void FeelAndEnd(HaplyShape shape, double rate = 1000.0)
  {
    shape.NumberScale = Numbered().NumberScale;
    this->Serve(shape);
    ASSERT_NO_FATAL_FAILURE(this->Open());
    ASSERT_NO_FATAL_FAILURE(this->Feel(rate));
    this->Bench.Stop();
    EXPECT_TRUE(Eventually([&] { return this->CountBehind() < 1.5; })) << "each one has its state";
    this->Bench.Device->Close();
    EXPECT_TRUE(Eventually([&] { return Size(this->LastForce()) == 0.0; })) << "the last one";
    const HaplySession session = this->LastSession();
    EXPECT_EQ(session.Refused, 0) << "all messages are as this version takes them";
    ASSERT_FALSE(session.Forces.empty());
    EXPECT_EQ(Size(session.Forces.front()), 0.0) << "the first one";
    for (const Triple& force : session.Forces)
    {
      EXPECT_LE(Size(force), 2.0 + 1e-9);
    }
  }
};
} // namespace

TEST_F(HaplySessions, AFloorIsFelt)
{
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd({}));
  EXPECT_NE(this->LastSession().Greeting.find("\"profile\""), std::string::npos);
  EXPECT_TRUE(Eventually([&] { return !this->LastSession().IsOpen; }));
}

TEST_F(HaplySessions, InAxesThatTheHubRemembersOtherwise)
{
  for (const char* const basis : { "YZX", "X-YZ" })
  {
    HaplyShape shape;
    shape.Basis = basis;
    ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape)) << basis;
  }
}

TEST_F(HaplySessions, AtFourKilohertz)
{
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd({}, 4000.0));
}

TEST_F(HaplySessions, WithAnOldService)
{
  HaplyShape shape;
  shape.Version = "3.0.7";
  shape.HasMaps = true;
  shape.HasEvents = false;
  shape.HasOwnHttp = true;
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape));
  EXPECT_EQ(this->LastSession().Greeting.find("\"session\""), std::string::npos);
  EXPECT_EQ(ListDevices().size(), 2U);
}

TEST_F(HaplySessions, WithAServiceOfThreeOne)
{
  HaplyShape shape;
  shape.Version = "3.1.1";
  shape.HasOwnHttp = true;
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape));
  EXPECT_EQ(ListDevices().size(), 2U);
}

TEST_F(HaplySessions, WithOmittedDefaultsInAnotherOrder)
{
  HaplyShape shape;
  shape.OmitsDefaults = true;
  shape.IsReordered = true;
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape));
}

TEST_F(HaplySessions, ItIsListedByItsNameAndHand)
{
  this->Serve();
  std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].Id, "haply:049D");
  EXPECT_EQ(all[0].Name, "Haply Inverse3 (049D, right-handed)");
  EXPECT_EQ(all[0].State, "available");
  EXPECT_EQ(all[0].Identity, "haply:049D");
  EXPECT_EQ(all[1].Id, "haply:04BA");
  this->Service->SetCalibrated(false);
  EXPECT_TRUE(Has(ListDevices()[0].State, "not calibrated"));
  this->Service->SetCalibrated(true);
  ASSERT_NO_FATAL_FAILURE(this->Open("haply:049D"));
  EXPECT_EQ(this->Bench.Device->GetName(), "Haply Inverse3 (049D, right-handed)");
  EXPECT_EQ(this->Bench.Device->GetIdentity(), "haply:049D");
  EXPECT_EQ(this->Bench.Device->GetLimits().MaximumForce, 2.0);
  EXPECT_EQ(this->Bench.Device->GetLimits().WorkspaceRadius, 0.10);
}

TEST_F(HaplySessions, AFloorIsFeltWithAMinverse)
{
  HaplyShape shape;
  shape.Type = shape.Family = "minverse";
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape));
}

TEST_F(HaplySessions, AMinverseHasASmallerWorkspace)
{
  HaplyShape shape;
  shape.Type = shape.Family = "minverse";
  this->Serve(shape);
  ASSERT_NO_FATAL_FAILURE(this->Open());
  EXPECT_EQ(this->Bench.Device->GetName(), "Haply Minverse (049D, right-handed)");
  EXPECT_EQ(this->Bench.Device->GetLimits().WorkspaceRadius, 0.04);
}

TEST_F(HaplySessions, TheGripTurnsTheStylusAndHasAButton)
{
  this->Serve();
  ASSERT_NO_FATAL_FAILURE(this->Open());
  // Rotate the grip by 90 degrees about the vertical, which is the device's y.
  const double half = std::sqrt(0.5);
  this->Service->SetGrip({ half, 0.0, 0.0, half }, true);
  DeviceSample sample;
  EXPECT_TRUE(Eventually(
    [&]
    {
      return this->Bench.Device->Read(1e-3, sample) == DeviceState::Running &&
        sample.Buttons == 1U && std::abs(sample.Orientation.Y - half) < 1e-6;
    }));
  EXPECT_TRUE(sample.HasOrientation);
  EXPECT_NEAR(sample.Orientation.W, half, 1e-6);
  EXPECT_NEAR(sample.Orientation.X, 0.0, 1e-9);
  EXPECT_NEAR(sample.Orientation.Z, 0.0, 1e-9);
}

TEST_F(HaplySessions, ItIsReadyWhenItIsCalibrated)
{
  this->Serve();
  this->Service->SetCalibrated(false);
  ASSERT_TRUE(this->Bench.Open("haply")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("is not calibrated"));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  this->Service->SetCalibrated(true);
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Text(), "");
}

TEST_F(HaplySessions, ItIsReadyOnlyIfThatIsTold)
{
  HaplyShape shape;
  shape.OmitsFalseFlags = true;
  this->Serve(shape);
  this->Service->SetCalibrated(false);
  EXPECT_TRUE(Has(ListDevices().at(0).State, "not calibrated"));
  ASSERT_TRUE(this->Bench.Open("haply")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("is not calibrated"));
  this->Service->SetReady(false);
  this->Service->SetCalibrated(true);
  this->Bench.Device->Home(); // requests a new inventory
  ASSERT_TRUE(this->Bench.WaitForText("is not ready"));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  this->Service->SetReady(true);
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(HaplySessions, TheInventoryTellsFlagsThatStatesLeaveOut)
{
  HaplyShape shape;
  shape.HasStatus = false;
  ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape));
}

TEST_F(HaplySessions, HomeWaitsUntilTheServiceHasDroppedTheSession)
{
  HaplyShape shape;
  shape.DropTime = 200;
  this->Serve(shape);
  ASSERT_NO_FATAL_FAILURE(this->Open());
  this->Service->SetCalibrated(false);
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Lost));
  this->Service->SetCalibrated(true);
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(HaplySessions, ASecondClientIsToldThatItIsInUse)
{
  this->Serve();
  ASSERT_NO_FATAL_FAILURE(this->Open());
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_TRUE(Has(ErrorOf("haply"), "is in use by another program"));
  EXPECT_TRUE(this->Bench.Press([] {}, [] {}, [&] { return this->IsHeld(); })) << "undisturbed";
}

TEST_F(HaplySessions, TwoClientsEachHaveAnArm)
{
  this->Serve();
  ASSERT_NO_FATAL_FAILURE(this->Open("haply:049D"));
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  DeviceBench second;
  ASSERT_TRUE(second.Open("haply:04BA")) << second.Error;
  ASSERT_TRUE(second.WaitFor(DeviceStage::Ready)) << second.Text();
  EXPECT_TRUE(this->Bench.Press([] {}, [] {}, [&] { return this->IsHeld(); })) << "undisturbed";
  second.Device->Close();
  std::vector<HaplySession> sessions = this->Service->GetSessions();
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[0].Arm, HaplyService::Id);
  EXPECT_EQ(sessions[1].Arm, HaplyService::Other);
  EXPECT_TRUE(this->Bench.Press([] {}, [] {}, [&] { return this->IsHeld(); })) << "still";
}

TEST_F(HaplySessions, APresetThatIsNotTakenLeavesTheOriginAtTheBase)
{
  for (const char* const preset : { "defaults", "arm_front" })
  {
    HaplyShape shape;
    shape.TakesPresets = false;
    shape.Preset = preset;
    ASSERT_NO_FATAL_FAILURE(this->FeelAndEnd(shape)) << preset;
  }
}

TEST_F(HaplySessions, APresetOfUnknownAxesIsRefusedWithItsCure)
{
  HaplyShape shape;
  shape.TakesPresets = false;
  shape.Preset = "led_front_centered";
  this->Serve(shape);
  ASSERT_TRUE(this->Bench.Open("haply")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("has the preset led_front_centered")) << this->Bench.Text();
  EXPECT_TRUE(Has(this->Bench.Text(), "whose axes are not known here. Choose arm_front_centered"))
    << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);
}

TEST_F(HaplySessions, AnOriginThatIsNotToldKeepsTheArmFromBeingReady)
{
  HaplyShape shape;
  shape.TellsConfig = false;
  this->Serve(shape);
  ASSERT_TRUE(this->Bench.Open("haply")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("does not report its origin")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
}
