// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the limits that a user may set, and their effects.
 */

#include "Rigs/DeviceRig.h"

#include <vtkStringArray.h>

#include <limits>
#include <sstream>

using namespace devicetest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

class DeviceLimits : public DeviceTest
{
};
} // namespace

TEST_F(DeviceLimits, TheMaximumForceIsHalfTheDevicesAndAtMostTheDevices)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  const double half = this->Device->GetMaximumForce();
  EXPECT_GT(half, 0.0);
  this->Device->SetMaximumForce(1e9);
  EXPECT_EQ(this->Device->GetMaximumForce(), 2.0 * half);
  this->Device->SetMaximumForce(-1.0);
  EXPECT_EQ(this->Device->GetMaximumForce(), 0.0);
  this->Device->SetMaximumForce(1.0);
  this->Device->SetMaximumForce(NaN);
  EXPECT_EQ(this->Device->GetMaximumForce(), 0.0);
  EXPECT_EQ(this->Device->GetMaximumForceRate(), 500.0);
  this->Device->SetMaximumForceRate(NaN);
  EXPECT_EQ(this->Device->GetMaximumForceRate(), 1.0);
  this->Device->SetMaximumForceRate(0.0);
  EXPECT_EQ(this->Device->GetMaximumForceRate(), 1.0) << "no force may be held for ever";
  ASSERT_TRUE(this->Device->Open("virtual"));
  EXPECT_EQ(this->Device->GetMaximumForce(), 0.0) << "opening keeps what the user has set";
  this->Device->ResetMaximumForce();
  EXPECT_EQ(this->Device->GetMaximumForce(), half);
  this->Device->Open("virtual");
  EXPECT_EQ(this->Device->GetMaximumForce(), half) << "unless that was taken back";
}

TEST_F(DeviceLimits, TheForceIsClampedWhileTheServoRuns)
{
  this->BeginPressed();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetForce()[2] < -1.49; }));
  this->Device->SetMaximumForce(0.5);
  EXPECT_TRUE(this->Wait(
    [this] { return std::abs(Length(this->Device->GetState()->GetForce()) - 0.5) < 1e-9; }));
  EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[2], -1.5, 1e-6);
  this->Device->SetMaximumForce(0.0);
  EXPECT_TRUE(this->Wait([this] { return Length(this->Device->GetState()->GetForce()) == 0.0; }));
}

TEST_F(DeviceLimits, RatesStayInTheirRange)
{
  this->Device->SetServoRate(1.0);
  EXPECT_EQ(this->Device->GetServoRate(), 100.0);
  this->Device->SetServoRate(1e9);
  EXPECT_EQ(this->Device->GetServoRate(), 10000.0);
  this->Device->SetServoRate(NaN);
  EXPECT_TRUE(std::isfinite(this->Device->GetServoRate()));
}

TEST_F(DeviceLimits, TheVirtualDeviceRefusesNonsense)
{
  this->Device->GetVirtualHand()->SetPosition(1.0, 2.0, 3.0);
  this->ExpectError("Open(\"virtual\")");
  this->Device->GetVirtualHand()->SetDynamics(0.1, 0.5, 100.0, 0.0, 0);
  this->ExpectError("Open(\"virtual\")");
  this->Begin();
  this->Device->GetVirtualHand()->SetPosition(1.0, NaN, 3.0);
  this->ExpectError("finite");
  ASSERT_TRUE(this->WaitTicks(3));
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], 7.0, 1e-9);
  this->Device->GetVirtualHand()->SetDynamics(0.1, 0.5, 100.0, 0.0, 0);
  this->ExpectError("Start()");
}

TEST_F(DeviceLimits, AnOverspeedLatchesUntilArmed)
{
  this->BeginFast();
  this->Device->GetVirtualHand()->SetPosition(7.0, 600.0, 5.0);
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::FAULT; }));
  EXPECT_NE(this->Device->GetStatusText().find("faster"), std::string::npos);
  ASSERT_TRUE(this->WaitTicks(2000));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::FAULT);
  this->Device->Arm();
  EXPECT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::ACTIVE; }));
}

TEST_F(DeviceLimits, AFastHandAtItsOwnSpeedIsNoFault)
{
  this->Begin();
  this->Device->Arm();
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_TRUE(this->Lead(7.0, i % 2 ? 7.0 : 300.0, 5.0));
    ASSERT_NE(this->Device->GetStatus(), vtkHapticDevice::FAULT) << this->Device->GetStatusText();
  }
}

TEST_F(DeviceLimits, ListsAndPrintsItself)
{
  EXPECT_GE(vtkHapticDevice::EnumerateDevices()->LookupValue("virtual"), 0);
  std::ostringstream text;
  this->Device->Print(text);
  EXPECT_NE(text.str().find("MaximumForceRate: 500"), std::string::npos);
}

TEST_F(DeviceLimits, APulseAtTouchDownIsSentOnlyIfItIsWanted)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  EXPECT_EQ(this->Device->GetTransientGain(), 0.0);
  this->Device->SetMaximumForceRate(1e5);
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->ArmFully());
  vtkNew<vtkTable> states;
  this->Device->GetState()->Drain(states);
  for (const double gain : { 0.0, 1.0 })
  {
    this->Device->SetTransientGain(gain);
    double most = 0.0;
    // The pulse depends on the approach speed. A loop that pauses between approach and touch can't
    // measure this speed, so retry.
    for (int i = 0; i < 20 && !(gain > 0.0 && most > 0.1); ++i)
    {
      ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0));
      ASSERT_TRUE(this->WaitTicks(60));
      ASSERT_TRUE(this->WaitFullyArmed());
      ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
      ASSERT_TRUE(this->WaitTicks(20));
      this->Device->GetState()->Drain(states);
      auto* const computed = vtkDataArray::SafeDownCast(states->GetColumnByName("Force"));
      auto* const sent = vtkDataArray::SafeDownCast(states->GetColumnByName("Command"));
      ASSERT_TRUE(computed && sent);
      for (vtkIdType row = 0; row < states->GetNumberOfRows(); ++row)
      {
        most = std::max(most, Length(sent->GetTuple3(row)) - Length(computed->GetTuple3(row)));
      }
    }
    EXPECT_EQ(gain > 0.0, most > 0.1) << gain << ": " << most << " N";
  }
}
