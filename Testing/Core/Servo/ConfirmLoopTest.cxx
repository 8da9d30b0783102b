// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the loop with a device whose signs are not confirmed yet. The volume may be felt only after
 * the tip has moved in the direction of the force.
 */

#include "Rigs/HeldDevice.h"
#include "Rigs/PlayedDevice.h"

using namespace servotest;

namespace
{
signtest::Hand MakeHand()
{
  signtest::Hand hand;
  hand.Stiffness = 100.0;
  hand.Damping = 3.0;
  hand.TremorSize = 0.0;
  return hand;
}

/// A device that a simulated hand holds in the ramp, where the volume pushes. `sign` is the sign of
/// the device's x axis.
class HandheldDevice : public PlayedDevice
{
public:
  explicit HandheldDevice(double sign)
    : Held(MakeHand(), { sign, 1.0, 1.0 }, 1)
  {
  }
  DeviceState Read(double period, DeviceSample& sample) noexcept override
  {
    const DeviceState state = PlayedDevice::Read(period, sample);
    this->Held.Move({ this->Sent.X, this->Sent.Y, this->Sent.Z }, period);
    const signtest::Triple& x = this->Held.GetPlace();
    sample.Tip = Vector3{ 0.012 + x[0], 0.012 + x[1], 0.012 + x[2] };
    return state;
  }
  DeviceState Write(const Vector3& force) noexcept override
  {
    this->Sent = force;
    this->MostAcross.store(std::max(this->MostAcross.load(), std::hypot(force.Y, force.Z)));
    return PlayedDevice::Write(force);
  }
  std::atomic<double> MostAcross{ 0.0 }; ///< largest force (N) across x, without the pushes

private:
  signtest::HeldDevice Held;
  Vector3 Sent;
};

class Confirm : public testing::Test
{
protected:
  /// Arms the loop with the sign of x unconfirmed. Waits until the gate has confirmed the sign or
  /// has found a fault.
  ServoSnapshot Check(HandheldDevice& device, RunningLoop& loop)
  {
    loop->Publish(this->Model);
    loop->RequireConfirmation(1, 8.0);
    loop->Arm();
    EXPECT_TRUE(Eventually([&] { return this->Look(loop).Gate == GateState::Confirming; }));
    EXPECT_TRUE(Eventually([&] { return this->Look(loop).Gate != GateState::Confirming; }));
    static_cast<void>(device);
    return this->Look(loop);
  }
  const ServoSnapshot& Look(RunningLoop& loop)
  {
    loop->ReadState();
    return loop->GetState();
  }

  TestVolume Volume = MakeRamp();
  std::shared_ptr<const HapticModel> Model = std::make_shared<HapticModel>(Describe(this->Volume));
};
} // namespace

TEST_F(Confirm, TheVolumeIsFeltOnceTheTipMovedWithTheForce)
{
  HandheldDevice device(1.0);
  RunningLoop loop(device, 1000.0);
  const ServoSnapshot after = this->Check(device, loop);
  EXPECT_EQ(after.Signs.Result, SignResult::Confirmed);
  EXPECT_NE(after.Gate, GateState::Fault);
  EXPECT_TRUE(Eventually([&] { return this->Look(loop).Gate == GateState::Armed; }));
  // After the device has been armed again, its signs are not checked again.
  loop->Disarm();
  EXPECT_TRUE(Eventually([&] { return this->Look(loop).Gate == GateState::Disarmed; }));
  loop->Arm();
  EXPECT_TRUE(Eventually([&] { return this->Look(loop).Gate == GateState::Armed; }));
}

TEST_F(Confirm, AWrongSignIsAFaultAndOnlySmallPushesWereGiven)
{
  HandheldDevice device(-1.0);
  RunningLoop loop(device, 1000.0);
  const ServoSnapshot after = this->Check(device, loop);
  EXPECT_EQ(after.Signs.Result, SignResult::Wrong);
  EXPECT_EQ(after.Signs.Axis, 0);
  EXPECT_EQ(after.Gate, GateState::Fault);
  EXPECT_EQ(after.GetFault(), GateReason::WrongSign);
  EXPECT_EQ(device.MostAcross.load(), 0.0) << "the volume was never felt";
  EXPECT_LE(device.LargestForce.load(), 0.8);
  const std::uint64_t from = device.Writes.load() + 2;
  EXPECT_TRUE(Eventually([&] { return device.Writes.load() > from + 300; }));
  EXPECT_LE(device.LastPush.load(), from);
}
