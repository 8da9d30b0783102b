// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests a device's status, its status text, and the conditions for force. */

#include "Rigs/DeviceRig.h"

using namespace devicetest;

namespace
{
class DeviceStatus : public DeviceTest
{
protected:
  bool Says(const char* words)
  {
    return this->Device->GetStatusText().find(words) != std::string::npos;
  }
};
} // namespace

TEST_F(DeviceStatus, GoesFromClosedToActiveAndBack)
{
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::CLOSED);
  EXPECT_TRUE(this->Says("Open()"));
  ASSERT_TRUE(this->Device->Open("virtual"));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
  EXPECT_TRUE(this->Says("Start()"));
  this->Begin();
  EXPECT_TRUE(this->Device->IsRunning());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
  EXPECT_TRUE(this->Says("Arm()"));
  this->Device->Arm();
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::ACTIVE; }));
  EXPECT_TRUE(this->Says("Real-time priority"));
  EXPECT_TRUE(this->Wait([this] { return this->Says(" 100 % of the force passes."); }));
  EXPECT_TRUE(this->Says("locking of the servo's own memory"));
  EXPECT_TRUE(this->Wait(
    [this]
    {
      return this->Says("of the samples around the tip granted.") ||
        this->Says("of the samples around the tip refused");
    }));
  this->Device->Disarm();
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::READY; }));
  EXPECT_TRUE(this->Says(" 0 % of the force passes (not armed)"));
  this->Device->Stop();
  EXPECT_FALSE(this->Device->IsRunning());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY);
  this->Device->Close();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::CLOSED);
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(DeviceStatus, StartNeedsADeviceAndAnImage)
{
  EXPECT_FALSE(this->Device->Start());
  this->ExpectError("Open");
  EXPECT_FALSE(this->Device->IsRunning());
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Filter->SetInputData(0, nullptr);
  EXPECT_FALSE(this->Device->Start());
  EXPECT_EQ(this->FilterLog.Errors.size(), 1U);
  EXPECT_FALSE(this->Device->IsRunning());
  this->Device->SetVolumeHaptics(nullptr);
  EXPECT_TRUE(this->Device->Start()) << "without a filter the tip just moves";
  EXPECT_TRUE(this->Lead(1.0, 2.0, 3.0));
}

TEST_F(DeviceStatus, ForceFlowsOnlyWhileArmed)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  ASSERT_TRUE(this->WaitTicks(50));
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[2], -1.5, 1e-6) << "500 N/m, 3 mm deep";
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 5.0, 1e-6);
  EXPECT_EQ(this->Device->GetState()->GetContact(), 1);
  // The proxy starts at the tip, so a hand that is armed inside the ramp feels no force until it
  // moves.
  this->BeginWayHere();
  ASSERT_TRUE(this->ArmFully());
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 8.0, 1e-6);
  ASSERT_TRUE(this->LeadInto(11.0));
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetState()->GetForce()[2] < -1.49; }));
  this->Device->Disarm();
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  this->Device->Stop();
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
}

TEST_F(DeviceStatus, ASurfaceThatWasPressedDuringTheRampIsCalledSoft)
{
  this->Begin();
  bool isSoft = false;
  // On a busy machine, the press may miss the ramp of half a second, or start a new contact after a
  // pause, so retry.
  for (int attempt = 0; attempt < 10 && !isSoft; ++attempt)
  {
    this->Device->Disarm();
    this->BeginWayHere();
    ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0));
    this->Device->Arm();
    ASSERT_TRUE(this->Wait([this] { return IsRising(this->Device); }));
    ASSERT_TRUE(this->LeadInto(8.0));
    this->BeginWayHere();
    ASSERT_TRUE(this->WaitFullyArmed());
    isSoft = this->Says("feels soft");
  }
  ASSERT_TRUE(isSoft);
  EXPECT_GT(this->Device->GetState()->GetForce()[2], -1.4);
  ASSERT_TRUE(this->PressAgain());
  EXPECT_FALSE(this->Says("feels soft"));
}

TEST_F(DeviceStatus, ArmClearsAFaultAtOnce)
{
  this->Begin();
  this->Device->Arm();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::ACTIVE; }));
  this->Device->GetVirtualHand()->Place(500.0, 7.0, 5.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::FAULT; }));
  EXPECT_TRUE(this->Device->IsArmOrdered());
  this->Device->Arm();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ARMED) << "before the servo has seen it";
  EXPECT_TRUE(this->Says("cleared"));
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::ACTIVE; }));
}

TEST_F(DeviceStatus, ArmedBeforeStartIsArmedAfterIt)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->Arm();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->WaitFullyArmed());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  EXPECT_TRUE(this->WaitForce());
  this->Device->Stop();
  this->Device->Start();
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY) << "Stop disarms";
  this->Device->Stop();
  this->Device->Arm();
  this->Begin();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY) << "another device is not armed";
}

TEST_F(DeviceStatus, PublishingWhatCannotBeTouchedKeepsWhatIsTouched)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  this->Filter->SetInputData(0, nullptr);
  EXPECT_FALSE(this->Device->Publish());
  EXPECT_EQ(this->FilterLog.Errors.size(), 1U);
  vtkNew<vtkMatrix4x4> shear;
  shear->SetElement(0, 1, 0.5);
  this->Filter->SetInputData(0, this->Image);
  this->Device->SetDeviceToWorld(shear);
  EXPECT_FALSE(this->Device->Publish());
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[2], -1.5, 1e-6);
}
