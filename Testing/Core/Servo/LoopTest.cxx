// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests in which tick orders take effect, and that force flows only while it may.
 */

#include "Rigs/PlayedDevice.h"

using namespace servotest;

namespace
{
class Servo : public testing::Test
{
protected:
  /// Arms the loop on a ramp and waits until force flows.
  void Activate(RunningLoop& loop)
  {
    loop->Publish(this->Model);
    loop->Arm();
    ASSERT_TRUE(Eventually([this] { return this->Device.Force.load() > 0.5; }));
  }
  bool IsCut(RunningLoop& loop)
  {
    const std::uint64_t from = this->Device.Writes.load() + 2;
    return Eventually([&] { return this->Device.Writes.load() > from; }) &&
      this->StaysZero(loop, 3000);
  }
  /// Returns whether no force acts during the next `ticks` ticks, in which the path passes through
  /// contact.
  bool StaysZero(RunningLoop&, std::uint64_t ticks)
  {
    const std::uint64_t from = this->Device.Writes.load();
    return Eventually([&] { return this->Device.Writes.load() > from + ticks; }) &&
      this->Device.LastPush.load() <= from;
  }
  GateReason FaultOf(RunningLoop& loop)
  {
    loop->ReadState();
    return loop->GetState().GetFault();
  }

  TestVolume Volume = MakeRamp();
  std::shared_ptr<const HapticModel> Model = std::make_shared<HapticModel>(Describe(this->Volume));
  PlayedDevice Device;
};

/// A device that rests in the ramp. When the test asks for it, its samples stop; they return as
/// soon as the force falls.
class DozingDevice : public PlayedDevice
{
public:
  DeviceState Read(double period, DeviceSample& sample) noexcept override
  {
    const DeviceState state = PlayedDevice::Read(period, sample);
    this->Depth = std::min(0.002, this->Depth + (this->IsIn.load() ? 1e-6 : 0.0));
    sample.Tip = Vector3{ 0.012, 0.012, 0.010 + this->Depth };
    return state;
  }
  DeviceState Write(const Vector3& force) noexcept override
  {
    const double fall = this->LastForce - Norm(force);
    this->LastForce = Norm(force);
    this->LargestFall.store(std::max(this->LargestFall.load(), fall));
    if (fall > 0.0)
    {
      this->Frozen.store(false);
    }
    return PlayedDevice::Write(force);
  }

  std::atomic<bool> IsIn{ false };
  std::atomic<double> LargestFall{ 0.0 }; ///< N

private:
  double Depth = 0.0; // m
  double LastForce = 0.0;
};
} // namespace

TEST_F(Servo, AModelTakesEffectWithinTwoTicks)
{
  RunningLoop loop(this->Device);
  loop->SetRecording(true);
  ServoSnapshot s;
  for (int i = 0; i < 50; ++i)
  {
    const std::uint64_t generation = loop->Publish(i % 10 == 9 ? nullptr : this->Model);
    // The current tick may have begun with the old model, but the next tick must use the new one.
    const std::uint64_t underWay = loop->GetTickCount();
    const auto arrived = [&]
    {
      while (loop->Drain(s) && s.Generation != generation)
      {
      }
      return s.Generation == generation;
    };
    ASSERT_TRUE(Eventually(arrived)) << generation;
    EXPECT_LE(s.Tick, underWay + 1);
    EXPECT_GE(loop->GetAcknowledged(), generation);
  }
}

TEST_F(Servo, ForceFlowsOnlyWhileArmedAndNeverAtTheEnd)
{
  for (int round = 0; round < 5; ++round)
  {
    {
      RunningLoop loop(this->Device);
      loop->Publish(this->Model);
      EXPECT_TRUE(this->StaysZero(loop, 3500)) << "not armed";
      this->Activate(loop);
      loop->Disarm();
      EXPECT_TRUE(this->IsCut(loop)) << "disarmed";
      this->Activate(loop);
    }
    EXPECT_EQ(this->Device.Force.load(), 0.0) << "stopped";
  }
}

TEST_F(Servo, WithoutAModelThereIsNoForce)
{
  RunningLoop loop(this->Device);
  this->Activate(loop);
  // The force must be zero because the loop has received the change. The tip is still in contact.
  const std::uint64_t generation = loop->Publish(nullptr);
  EXPECT_TRUE(Eventually([&] { return loop->GetAcknowledged() >= generation; }));
  EXPECT_TRUE(this->IsCut(loop));
}

TEST_F(Servo, AFrozenDeviceGetsNoForceUntilItMovesAgain)
{
  SafetyLimits limits = QuickLimits();
  limits.WatchdogTime = 0.5;
  RunningLoop loop(this->Device, 5000.0, limits);
  this->Activate(loop);
  this->Device.Frozen.store(true);
  // The force must be zero because the tip has not been measured for too long. The tip is still in
  // contact.
  EXPECT_TRUE(Eventually(
    [&]
    {
      loop->ReadState();
      return loop->GetState().Stale && this->Device.Force.load() == 0.0;
    }));
  EXPECT_TRUE(this->StaysZero(loop, 1000));
  EXPECT_EQ(this->FaultOf(loop), GateReason::None);
  EXPECT_TRUE(loop->GetState().Stale);
  this->Device.Frozen.store(false);
  EXPECT_TRUE(Eventually([this] { return this->Device.Force.load() > 0.5; }));
}

TEST_F(Servo, SamplesThatComeBackWhileTheForceFallsMakeNoStepAndBeginFromTheTip)
{
  DozingDevice device;
  SafetyLimits limits = QuickLimits();
  limits.WatchdogTime = 0.3;
  limits.MaximumForceRate = 500.0;
  RunningLoop loop(device, 5000.0, limits);
  loop->Publish(this->Model);
  loop->Arm();
  ASSERT_TRUE(Eventually(
    [&] { return loop->ReadState() && loop->GetState().IsArmed() && device.Reads > 200; }));
  device.IsIn.store(true);
  ASSERT_TRUE(Eventually([&] { return device.Force.load() >= 0.99; })); // N: 500 N/m times 2 mm
  device.Frozen.store(true);
  ASSERT_TRUE(Eventually([&] { return device.Force.load() == 0.0; }));
  EXPECT_LE(device.LargestFall.load(), limits.MaximumForceRate / 5000.0 * (1.0 + 1e-9));
  device.LargestForce.store(0.0);
  const std::uint64_t end = device.Writes.load() + 500;
  ASSERT_TRUE(Eventually([&] { return device.Writes.load() > end; }));
  EXPECT_EQ(device.LargestForce.load(), 0.0) << "the proxy is on the tip";
}

TEST_F(Servo, ArmChangesNothingWhereForceFlows)
{
  DozingDevice device;
  RunningLoop loop(device);
  loop->Publish(this->Model);
  loop->Arm();
  ASSERT_TRUE(Eventually(
    [&] { return loop->ReadState() && loop->GetState().IsArmed() && device.Reads > 200; }));
  device.IsIn.store(true);
  ASSERT_TRUE(Eventually([&] { return device.Force.load() >= 0.99; }));
  for (int i = 0; i < 3; ++i)
  {
    loop->Arm();
    const std::uint64_t end = device.Writes.load() + 100;
    ASSERT_TRUE(Eventually([&] { return device.Writes.load() > end; }));
  }
  EXPECT_LT(device.LargestFall.load(), 1e-9);
  EXPECT_GE(device.Force.load(), 0.99);
}

TEST_F(Servo, ADeviceThatIsLostInReadOrWriteStaysCutUntilArmed)
{
  for (std::atomic<bool>* lost : { &this->Device.ReadLost, &this->Device.WriteLost })
  {
    RunningLoop loop(this->Device);
    this->Activate(loop);
    lost->store(true);
    EXPECT_TRUE(this->IsCut(loop)) << (lost == &this->Device.ReadLost ? "Read" : "Write");
    EXPECT_EQ(this->FaultOf(loop), GateReason::DeviceLost);
    lost->store(false);
    EXPECT_TRUE(this->StaysZero(loop, 3500)) << "it must not resume by itself";
    this->Activate(loop);
  }
}
