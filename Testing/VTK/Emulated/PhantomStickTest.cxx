// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Applications on the phantom with devices of fewer directions: a force-feedback stick, and a
 * SpaceMouse, without any.
 */

#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"
#include "Emulators/SpaceMouseModel.h"
#include "PhantomRig.h"

using namespace emulated;

TEST(PhantomStick, IsFelt)
{
  const Phantom phantom;
  OpenFfboardModel stick;
  EmulatedHid hid(stick);
  ModelClock clock([&] { stick.Step(); });
  // The face is to the right: its outside is to the left.
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
  // A busy machine may leave the device unwatched for a moment, and the force begins anew.
  for (int attempt = 0; attempt < 5 && !felt; ++attempt)
  {
    stick.SetGoal(-0.01, 0.0);
    ASSERT_TRUE(Eventually([&] { return stick.GetTip()[0] < -0.008; }));
    stick.SetGoal(0.006, 0.0);
    for (int i = 0; i < 2000 && !felt; ++i)
    {
      hand.WaitTicks(1);
      const double force = -device->GetForce()[1];
      felt = force > 0.1 && std::abs(stick.GetForce()[0] + force) < 0.05;
    }
  }
  EXPECT_TRUE(felt) << stick.GetForce()[0] << " N, told " << device->GetForce()[1];
  EXPECT_TRUE(hand.WaitTicks(5000));
  hid.Unplug();
  EXPECT_TRUE(hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(hand.WaitTicks(5));
  EXPECT_EQ(Length(device->GetForce()), 0.0);
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
  // The device's y is towards the hand: out of the face, and back into it.
  mouse.Push({ 0, 350, 0, 0, 0, 0 });
  EXPECT_TRUE(hand.Wait([&] { return phantom.DepthOf(device->GetTipPosition()) < -20.0; }));
  mouse.Push({ 0, -350, 0, 0, 0, 0 });
  EXPECT_TRUE(hand.Wait([&] { return phantom.DepthOf(device->GetTipPosition()) > 1.0; }));
  mouse.Push({ 0, 0, 0, 0, 0, 175 });
  EXPECT_TRUE(hand.Wait([&] { return device->GetContact() != 0; }))
    << "the proxy stays at the skin";
  EXPECT_LT(phantom.DepthOf(device->GetProxyPosition()), phantom.DepthOf(device->GetTipPosition()));
  EXPECT_EQ(Length(device->GetForce()), 0.0);
  // About its z, which points down: what is up for the hand turns the other way.
  EXPECT_TRUE(hand.Wait([&] { return device->GetTurnRate()[1] < -0.4; }));
  mouse.Push({});
  EXPECT_TRUE(hand.Wait([&] { return Length(device->GetTurnRate()) == 0.0; }));
}
