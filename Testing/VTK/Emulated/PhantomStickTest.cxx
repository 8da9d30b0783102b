// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests applications on the phantom with devices of fewer axes: a force-feedback stick, and a
 * SpaceMouse, which has no force. Also tests the first arming of a stick with two motors.
 */

#include "DevicesFile.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"
#include "Emulators/SpaceMouseModel.h"
#include "PhantomRig.h"
#include "Rigs/TemporaryFolder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace emulated;

namespace
{
/// A stick with two motors, at rest in front of the face, before its first arming.
class PhantomJoystick : public testing::Test
{
protected:
  PhantomJoystick()
  {
    this->Memory.Clear();
    this->Hand.Device->SetNewtonsPerFullScale(FfbHandle::FullScale, FfbHandle::FullScale);
  }
  /// Arms the device, and waits until its signs are confirmed or refused. Returns the largest force
  /// (N) until then along each axis of the device.
  void Arm(double largest[3])
  {
    vtkHapticDevice* const device = this->Hand.Device;
    ASSERT_TRUE(device->Open("pid:1209:ffb0"));
    ASSERT_FALSE(device->GetSignsConfirmed());
    ASSERT_TRUE(device->Start());
    this->Stick.SetGoal(-0.02, 0.0);
    ASSERT_TRUE(Eventually([this] { return this->Stick.GetTip()[0] < -0.019; }));
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << device->GetStatusText();
    device->Arm();
    EXPECT_TRUE(this->Hand.Wait(
      [&]
      {
        // The device's -x axis points out of the face, which is -y in the world; see
        // Phantom::Place().
        const double* const force = device->GetState()->GetForce();
        largest[0] = std::max(largest[0], std::abs(force[1]));
        largest[1] = std::max(largest[1], std::abs(force[2]));
        largest[2] = std::max(largest[2], std::abs(force[0]));
        return device->GetSignsConfirmed() || device->GetStatus() == vtkHapticDevice::FAULT;
      }));
  }
  std::string ReadMemory() const
  {
    std::ifstream file(this->Memory.Path);
    return { std::istreambuf_iterator<char>(file), {} };
  }

  const DevicesFile Memory;
  const Phantom Face;
  OpenFfboardModel Stick{ OpenFfboardModel::Kind::Joystick };
  EmulatedHid Hid{ this->Stick };
  ModelClock Clock{ [this] { this->Stick.Step(); } };
  PhantomHand Hand{ this->Face, 0, -1.0 };
};
} // namespace

TEST_F(PhantomJoystick, IsPushedAlongItsTwoAxesAndConfirmed)
{
  double largest[3] = {};
  ASSERT_NO_FATAL_FAILURE(this->Arm(largest));
  EXPECT_TRUE(this->Hand.Device->GetSignsConfirmed()) << this->Hand.Device->GetStatusText();
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_GT(largest[axis], 0.02) << axis;
    EXPECT_LE(largest[axis], 0.1 * FfbHandle::FullScale + 1e-9) << axis;
  }
  EXPECT_LT(largest[2], 1e-9) << "it has no third motor";
  EXPECT_NE(this->ReadMemory().find("confirmed="), std::string::npos) << this->ReadMemory();
}

TEST_F(PhantomJoystick, ASecondMotorTheOtherWayRoundIsAFault)
{
  this->Stick.SecondSign = -1.0;
  double largest[3] = {};
  ASSERT_NO_FATAL_FAILURE(this->Arm(largest));
  EXPECT_EQ(this->Hand.Device->GetStatus(), vtkHapticDevice::FAULT);
  EXPECT_TRUE(this->Hand.Says("against the force on axis y")) << this->Hand.Device->GetStatusText();
  EXPECT_EQ(this->ReadMemory().find("confirmed="), std::string::npos) << this->ReadMemory();
}

TEST(PhantomStick, IsFelt)
{
  const Phantom phantom;
  OpenFfboardModel stick;
  EmulatedHid hid(stick);
  ModelClock clock([&] { stick.Step(); });
  // The face is on the right of the stick, and the hand on the left.
  PhantomHand hand(phantom, 0, -1.0);
  vtkHapticDevice* const device = hand.Device;
  device->SetNewtonsPerFullScale(FfbHandle::FullScale, 0.0);
  ASSERT_TRUE(device->Open("pid:1209:ffb0"));
  EXPECT_EQ(device->GetMaximumForce(), 0.5 * FfbHandle::FullScale);
  ASSERT_TRUE(device->Start());
  stick.SetGoal(-0.01, 0.0);
  ASSERT_TRUE(hand.WaitFor(vtkHapticDevice::READY)) << device->GetStatusText();
  device->Arm();
  bool felt = false;
  // On a busy machine, the servo may pause, after which the force starts again from zero, so retry.
  for (int attempt = 0; attempt < 5 && !felt; ++attempt)
  {
    stick.SetGoal(-0.01, 0.0);
    ASSERT_TRUE(Eventually([&] { return stick.GetTip()[0] < -0.008; }));
    stick.SetGoal(0.006, 0.0);
    for (int i = 0; i < 2000 && !felt; ++i)
    {
      hand.WaitTicks(1);
      const double force = -device->GetState()->GetForce()[1];
      felt = force > 0.1 && std::abs(stick.GetForce()[0] + force) < 0.05;
    }
  }
  EXPECT_TRUE(felt) << stick.GetForce()[0] << " N, told " << device->GetState()->GetForce()[1];
  EXPECT_TRUE(hand.WaitTicks(5000));
  hid.Unplug();
  EXPECT_TRUE(hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(hand.WaitTicks(5));
  EXPECT_EQ(Length(device->GetState()->GetForce()), 0.0);
}

TEST(PhantomStick, AWheelWithoutASecondMotorAsksForTheSecondNumber)
{
  const Phantom phantom;
  OpenFfboardModel wheel;
  EmulatedHid hid(wheel);
  ModelClock clock([&] { wheel.Step(); });
  PhantomHand hand(phantom, 0, -1.0);
  vtkHapticDevice* const device = hand.Device;
  device->SetNewtonsPerFullScale(FfbHandle::FullScale, FfbHandle::FullScale);
  ASSERT_TRUE(device->Open("pid:1209:ffb0"));
  device->ForgetConfirmation();
  ASSERT_TRUE(device->Start());
  ASSERT_TRUE(hand.WaitFor(vtkHapticDevice::READY)) << device->GetStatusText();
  device->Arm();
  ASSERT_TRUE(hand.WaitFor(vtkHapticDevice::FAULT)) << device->GetStatusText();
  EXPECT_TRUE(hand.Says("did not move the tip along axis y")) << device->GetStatusText();
  EXPECT_TRUE(hand.Says("--newtons 2.5,0")) << device->GetStatusText();
}

TEST(PhantomSpaceMouse, PushesTheTipAgainstTheFaceAndTurnsTheVolume)
{
  const Phantom phantom;
  SpaceMouseModel mouse(false);
  EmulatedHid hid(mouse);
  ModelClock clock([&] { mouse.Step(); });
  PhantomHand hand(phantom, 2, 1.0);
  vtkHapticDevice* const device = hand.Device;
  ASSERT_TRUE(device->Open("spacemouse"));
  EXPECT_EQ(device->GetMaximumForce(), 0.0) << "nothing can be felt";
  ASSERT_TRUE(device->Start());
  ASSERT_TRUE(hand.WaitFor(vtkHapticDevice::READY)) << device->GetStatusText();
  device->Arm();
  // The device's y axis points towards the hand. Move the tip out of the face, and then back into
  // it.
  mouse.Push({ 0, 350, 0, 0, 0, 0 });
  EXPECT_TRUE(
    hand.Wait([&] { return phantom.DepthOf(device->GetState()->GetTipPosition()) < -20.0; }));
  mouse.Push({ 0, -350, 0, 0, 0, 0 });
  EXPECT_TRUE(
    hand.Wait([&] { return phantom.DepthOf(device->GetState()->GetTipPosition()) > 1.0; }));
  mouse.Push({ 0, 0, 0, 0, 0, 175 });
  EXPECT_TRUE(hand.Wait([&] { return device->GetState()->GetContact() != 0; }))
    << "the proxy stays at the skin";
  EXPECT_LT(phantom.DepthOf(device->GetState()->GetProxyPosition()),
    phantom.DepthOf(device->GetState()->GetTipPosition()));
  EXPECT_EQ(Length(device->GetState()->GetForce()), 0.0);
  // The device's z axis points down, so a rotation about z has the opposite sense about the world's
  // vertical axis.
  EXPECT_TRUE(hand.Wait([&] { return device->GetState()->GetTurnRate()[1] < -0.4; }));
  mouse.Push({});
  EXPECT_TRUE(hand.Wait([&] { return Length(device->GetState()->GetTurnRate()) == 0.0; }));
}
