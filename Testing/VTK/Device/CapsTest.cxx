// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that stiffness and damping never exceed the limits of the device and of the sampled loop.
 */

#include "Rigs/RecordingRig.h"

#include "Core/Safety/DeviceBackend.h"

using namespace devicetest;

namespace
{
class Caps : public Recording
{
protected:
  /// Starts the servo on a device with limits of stiffness (N/m) and damping (N s/m), and with
  /// viscous friction (N s/m). The tip is in front of the ramp.
  void BeginWith(double stiffness, double damping, double friction)
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetLimits(8.0, stiffness, damping, friction);
    this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
  }
  /// Expects this computed force (N) along z after a press of 2 mm into a material with 500 N/m.
  void ExpectComputed(double force)
  {
    SetConstant(this->Filter->GetProperty()->GetFriction(), 0.0);
    SetConstant(this->Filter->GetProperty()->GetViscosity(), 0.0);
    ASSERT_TRUE(this->Device->Publish());
    ASSERT_TRUE(this->Lead(7.0, 7.0, 7.0));
    EXPECT_NEAR(this->Device->GetState()->GetComputedForce()[2], force, 1e-6);
  }
};
} // namespace

TEST(CapsOf, TakesTheTighterOfTheDevicesLimitAndTheSampledOne)
{
  using namespace VolumeHaptics;
  DeviceLimits limits;
  EXPECT_EQ(CapsOf(limits, 1e-3).Stiffness, 0.0);
  EXPECT_EQ(CapsOf(limits, 1e-3).Damping, 0.0);
  limits.Damping = 0.25;
  EXPECT_EQ(CapsOf(limits, 1e-3).Stiffness, 500.0) << "2 b / T";
  EXPECT_EQ(CapsOf(limits, 0.5e-3).Stiffness, 1000.0);
  limits.MaximumStiffness = 300.0;
  EXPECT_EQ(CapsOf(limits, 1e-3).Stiffness, 300.0);
  EXPECT_EQ(CapsOf(limits, 2e-3).Stiffness, 250.0);
  limits.MaximumDamping = 20.0;
  EXPECT_EQ(CapsOf(limits, 1e-3).Damping, 20.0);
}

TEST_F(Caps, AreRaisedByTheGainOnceTheRoundTripIsKnownAndNothingIsFelt)
{
  // With a friction b of 0.15 N s/m and a period T of 1 ms, 2 b / T is 300 N/m. The gain of 5
  // increases the cap to 1500 N/m.
  this->Device->SetStiffnessGain(5.0);
  EXPECT_EQ(this->Device->GetStiffnessGain(), 5.0);
  this->BeginWith(0.0, 0.0, 0.15);
  ASSERT_TRUE(this->Wait([&] { return this->Device->GetStiffnessCap() == 1500.0; }));
  this->ExpectComputed(-1.0);
  EXPECT_NE(std::string(this->Device->GetStatusText()).find("at most 1500 N/m"), std::string::npos);
  // A smaller gain must take effect at once, even in contact.
  this->Device->SetStiffnessGain(1.0);
  const auto isComputed = [this](double force)
  { return std::abs(this->Device->GetState()->GetComputedForce()[2] - force) < 1e-6; };
  ASSERT_TRUE(this->Wait([&] { return isComputed(-0.6); }));
  EXPECT_EQ(this->Device->GetStiffnessCap(), 300.0);
  // A larger gain must take effect only after the tip has left the wall.
  this->Device->SetStiffnessGain(2.0);
  ASSERT_TRUE(this->WaitTicks(50));
  EXPECT_EQ(this->Device->GetStiffnessCap(), 300.0);
  ASSERT_TRUE(this->Lead(7.0, 7.0, 5.0));
  EXPECT_TRUE(this->Wait([&] { return this->Device->GetStiffnessCap() == 600.0; }));
}

TEST_F(Caps, OfTheDevicesStiffness)
{
  this->BeginWith(300.0, 0.0, 0.0);
  this->ExpectComputed(-0.6);
}

TEST_F(Caps, OfASampledSpring)
{
  this->BeginWith(300.0, 0.0, 0.1);
  this->ExpectComputed(-0.4);
}

TEST_F(Caps, LeaveAloneWhatTheDeviceCanHold)
{
  this->BeginWith(3000.0, 20.0, 2.0);
  EXPECT_EQ(this->Device->GetMaximumForce(), 4.0) << "half of the device's";
  this->ExpectComputed(-1.0);
}

TEST_F(Caps, OfTheStiffnessAreReplayed)
{
  this->BeginWith(300.0, 0.0, 0.0);
  this->StartRecording();
  this->Wander(40);
  this->ExpectSame(0.3);
  EXPECT_EQ(this->Recorded->GetPointData()->GetArray("Stiffness")->GetRange()[1], 300.0);
}

TEST_F(Caps, OfTheDampingAreFeltAndReplayed)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.0);
  this->Filter->SetForceFieldDamping(50.0);
  this->BeginWith(0.0, 20.0, 0.0);
  this->StartRecording();
  this->Wander(40);
  this->ExpectSame(0.01);
  vtkPointData* const data = this->Recorded->GetPointData();
  vtkDataArray* const tips = data->GetArray("DeviceTip");
  for (vtkIdType i = 1; i < tips->GetNumberOfTuples(); ++i)
  {
    double way[3];
    for (int c = 0; c < 3; ++c)
    {
      way[c] = tips->GetComponent(i, c) - tips->GetComponent(i - 1, c);
    }
    ASSERT_NEAR(data->GetArray("DragForce")->GetComponent(i, 0), 20.0 * Length(way) / 1e-3, 1e-9)
      << "tick " << i;
  }
}

TEST_F(Caps, FollowTheMeasuredRoundTrip)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  EXPECT_EQ(this->Device->GetRoundTripTime(), 0.0);
  EXPECT_EQ(this->Device->GetStiffnessCap(), 0.0);
  this->Device->GetVirtualHand()->SetLimits(8.0, 0.0, 20.0, 0.1);
  this->Device->GetVirtualHand()->SetDynamics(0.0, 0.0, 0.0, 0.0, 2);
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->WaitTicks(40));
  this->Device->UpdateState();
  EXPECT_NEAR(this->Device->GetReportPeriod(), 1e-3, 1e-9);
  EXPECT_NEAR(this->Device->GetRoundTripTime(), 5e-3, 1e-9) << "two ticks of delay, twice";
  EXPECT_NEAR(this->Device->GetStiffnessCap(), 40.0, 1e-6) << "2 b / T";
  EXPECT_NEAR(this->Device->GetDampingCap(), 4.0, 1e-6);
  EXPECT_NE(this->Device->GetStatusText().find("round trip 5.0 ms. Stiffness is at most 40 N/m."),
    std::string::npos)
    << this->Device->GetStatusText();
  this->ExpectComputed(-0.08);
  EXPECT_NEAR(this->Device->GetStiffnessCap(), 40.0, 1e-6) << "after Publish(), too";
}

TEST_F(Caps, ThatChangeDuringARecordingAreReplayed)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetLimits(8.0, 0.0, 0.0, 0.1);
  this->Device->GetVirtualHand()->SetDynamics(0.0, 0.0, 0.0, 0.0, 2);
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
  ASSERT_TRUE(this->Device->Start());
  EXPECT_NEAR(this->Device->GetStiffnessCap(), 200.0, 1e-6) << "nothing was measured yet";
  this->StartRecording();
  this->Wander(80);
  EXPECT_NEAR(this->Device->GetStiffnessCap(), 40.0, 1e-6);
  this->ExpectSame(0.05);
  EXPECT_EQ(this->Recorded->GetFieldData()->GetArray("Caps")->GetNumberOfTuples(),
    this->Recorded->GetFieldData()->GetArray("DeviceToWorld")->GetNumberOfTuples());
}

TEST_F(Caps, AreSetBetweenOpenAndStart)
{
  this->Device->GetVirtualHand()->SetLimits(8.0, 0.0, 0.0, 0.0);
  this->ExpectError("Open(\"virtual\")");
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetLimits(0.0, 0.0, 0.0, 0.0);
  this->ExpectError("above 0");
  this->Device->GetVirtualHand()->SetLimits(8.0, std::nan(""), 0.0, 0.0);
  this->ExpectError("finite");
  ASSERT_TRUE(this->Device->Start());
  this->Device->GetVirtualHand()->SetLimits(8.0, 0.0, 0.0, 0.0);
  this->ExpectError("Start()");
}
