// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests faults of a WoodenHaptics while it touches a floor: the force becomes zero, and the text
 * contains the reason.
 */

#include "Rigs/ReadTimes.h"
#include "WoodenRig.h"

using namespace emulated;

namespace
{
class WoodenFaults : public Wooden
{
protected:
  void Break(WoodenFault fault, const char* text)
  {
    ASSERT_TRUE(this->Bench.Open("wooden:0")) << this->Bench.Error;
    ASSERT_NO_FATAL_FAILURE(this->Feel());
    this->Model.Fault = fault;
    this->Bench.ExpectLost(text);
  }
  bool IsQuiet()
  {
    return Eventually([&] { return Size(this->Model.GetForce()) == 0.0; });
  }
  /// Moves the arm into its rest pose: upper arm upright, forearm level.
  bool GoToRest()
  {
    const Triple rest{ 0.245 - 0.22, 0.0, 0.205 };
    this->Model.SetGoal(rest);
    return Eventually([&] { return IsNear(this->Model.GetTip(), rest, 1e-4); });
  }
  /// Arms the device with the hand outside the floor, and moves the hand into the floor.
  void FeelAgain()
  {
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    ASSERT_TRUE(this->Bench.WaitForTicks(50));
    EXPECT_EQ(Size(this->Model.GetForce()), 0.0) << "not before it is armed";
    this->Model.SetGoal({ 0.0, 0.0, Height + 0.005 });
    ASSERT_TRUE(Eventually([&] { return this->Model.GetTip()[2] > Height + 0.004; }));
    this->Bench->Arm();
    this->Model.SetGoal({ 0.0, 0.0, Height - 0.01 });
    EXPECT_TRUE(Eventually([&] { return this->Model.GetForce()[2] > 1.5; }));
  }
};
} // namespace

TEST_F(WoodenFaults, ShortReport)
{
  this->Break(WoodenFault::ShortReport, "sent a packet of a wrong size");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(WoodenFaults, SilenceAndBackByHoming)
{
  this->Break(WoodenFault::Silence, "does not answer");
  EXPECT_TRUE(this->IsQuiet());
  this->Model.Fault = WoodenFault::None;
  this->Bench.Device->Home();
  // The device may have lost power unnoticed, so it must be calibrated again.
  ASSERT_TRUE(this->Bench.WaitForText("needs to know where its arm is")) << this->Bench.Text();
  ASSERT_TRUE(this->GoToRest());
  this->Bench.Device->Home();
  this->FeelAgain();
  EXPECT_EQ(this->Model.GetPresets(), 2);
}

TEST_F(WoodenFaults, ADeviceThatHangsFallsSilentAtOnce)
{
  ASSERT_TRUE(this->Bench.Open("wooden:0")) << this->Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Bench.Stop();
  devicetest::ReadTimes times(*this->Bench.Device);
  times.Run(0.5);
  EXPECT_GT(times.Fresh, 10);
  EXPECT_EQ(times.Signs, 0) << "it reports at rest, too";
  EXPECT_GT(times.Timing.GetRoundTrip(), 0.0);
  this->Model.Fault = WoodenFault::Silence;
  EXPECT_TRUE(times.FallsSilent(1.0, 0.05));
}

TEST_F(WoodenFaults, WriteErrorLeavesItToTheFirmware)
{
  this->Break(WoodenFault::WriteError, "does not accept what is sent to it");
  // Packets would keep the watchdog from acting. Without them, the currents become zero half a
  // second later.
  this->Model.Fault = WoodenFault::None;
  const int packets = this->Model.GetPackets();
  EXPECT_TRUE(this->Bench.WaitForTicks(100));
  EXPECT_EQ(this->Model.GetPackets(), packets);
  this->Model.PassTime(0.5);
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
}

TEST_F(WoodenFaults, AJumpOfAnEncoderAsksForTheZero)
{
  this->Break(WoodenFault::Jump, "a jump of its arm that no hand can make");
  EXPECT_TRUE(this->IsQuiet());
  this->Model.Fault = WoodenFault::None;
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("needs to know where its arm is")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
}

TEST_F(WoodenFaults, ALostZeroIsToldAnew)
{
  this->Break(WoodenFault::LostZero, "has lost the zero of its encoders");
  EXPECT_TRUE(this->IsQuiet());
  this->Model.PowerUp();
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("needs to know where its arm is")) << this->Bench.Text();
  this->Bench.Device->Home();
  this->FeelAgain();
  EXPECT_EQ(this->Model.GetPresets(), 2);
}

TEST_F(WoodenFaults, ItsCalibrationButtonCutsTheForceUntilItIsCalibrated)
{
  ASSERT_TRUE(this->Bench.Open("wooden:0")) << this->Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  this->Model.Button = true;
  this->Bench.ExpectLost("its calibration button was pressed");
  EXPECT_TRUE(this->IsQuiet());
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitForText("needs to know where its arm is")) << this->Bench.Text();
  ASSERT_TRUE(this->GoToRest());
  this->Bench.Device->Home();
  this->FeelAgain();
  EXPECT_FALSE(this->Model.Button);
}

TEST_F(WoodenFaults, AZeroThatIsNotTakenIsAskedForAgain)
{
  this->Model.IgnoresPresets = true;
  ASSERT_TRUE(this->Bench.Open("wooden")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("rest pose"));
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("did not accept the pose of its arm")) << this->Bench.Text();
  // Expect these bytes: no currents, command 1, encoders 0, 0, 6000.
  EXPECT_EQ(this->Model.GetLastPreset(),
    (std::vector<std::uint8_t>{ 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0x70, 0x17 }));
  this->Model.IgnoresPresets = false;
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
}

TEST_F(WoodenFaults, ForcesThatAreNotRenewedFadeAndQuenchIsAtOnce)
{
  ASSERT_TRUE(this->Bench.Open("wooden")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("rest pose"));
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  const auto push = [&]
  {
    DeviceSample sample;
    this->Bench.Device->Read(0.001, sample);
    this->Bench.Device->Write({ 0.0, 0.5, 0.0 });
    return Size(this->Model.GetForce()) > 0.4;
  };
  EXPECT_TRUE(Eventually(push));
  EXPECT_TRUE(this->IsQuiet()) << "the servo fell silent";
  EXPECT_TRUE(Eventually(push));
  this->Bench.Device->Quench();
  const int packets = this->Model.GetPackets();
  EXPECT_TRUE(Eventually([&] { return this->Model.GetPackets() > packets + 2; }));
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
}
