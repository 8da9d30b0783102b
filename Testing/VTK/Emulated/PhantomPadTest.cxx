// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests an application on the phantom with a gamepad. Contact must cause vibration, rest must not,
 * and the texts must mention vibration instead of force.
 */

#include "Emulators/EmulatedEvdev.h"
#include "Emulators/ModelClock.h"
#include "PhantomRig.h"

#include <vtkHapticHeadUpDisplay.h>

using namespace emulated;

TEST(PhantomPad, TheFaceIsFeltAsVibrationAndRestIsSilent)
{
  const Phantom phantom;
  PadModel pad(PadModel::Kind::Xbox);
  EmulatedEvdev evdev(pad);
  ModelClock clock([&] { pad.Step(); });
  const auto isStill = [&pad] { return pad.IsStill(); };
  PhantomHand hand(phantom, 2, 1.0);
  vtkHapticDevice* const device = hand.Device;
  ASSERT_TRUE(device->Open("vibration:pad"));
  EXPECT_EQ(device->GetMaximumForce(), 4.0);
  EXPECT_TRUE(device->GetCalibrationText().empty()) << "it has no newtons of its own";
  EXPECT_TRUE(device->GetSignsConfirmed()) << "and no signs";
  ASSERT_TRUE(device->Start());
  ASSERT_TRUE(hand.WaitFor(vtkHapticDevice::READY)) << device->GetStatusText();
  EXPECT_TRUE(hand.Says("vibration:pad (vibration, not force)")) << device->GetStatusText();
  device->Arm();
  // Move the tip towards the hand, and then back into the face.
  pad.Move(ABS_RY, 1.0);
  EXPECT_TRUE(
    hand.Wait([&] { return phantom.DepthOf(device->GetState()->GetTipPosition()) < -20.0; }));
  pad.Move(ABS_RY, 0.0);
  EXPECT_TRUE(Eventually(isStill));
  pad.ForgetHistory();
  EXPECT_TRUE(hand.WaitTicks(100));
  EXPECT_TRUE(pad.GetHistory().empty()) << "the air";
  pad.Move(ABS_RY, -1.0);
  EXPECT_TRUE(hand.Wait([&] { return Length(device->GetState()->GetForce()) > 1.5; }));
  EXPECT_TRUE(Eventually([&] { return !isStill(); }));
  EXPECT_GT(phantom.DepthOf(device->GetState()->GetTipPosition()), 0.0);
  pad.Move(ABS_RY, 0.0);
  EXPECT_TRUE(hand.Says("Active: vibration:pad (vibration, not force)."))
    << device->GetStatusText();
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(device);
  EXPECT_EQ(display->GetText().find("Active: vibration:pad (vibration, not force).\n"), 0U)
    << display->GetText();
  EXPECT_TRUE(Eventually(isStill)) << "the tip rests";
  EXPECT_GT(Length(device->GetState()->GetForce()), 0.5);

  evdev.Unplug();
  EXPECT_TRUE(hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(hand.WaitTicks(5));
  EXPECT_EQ(Length(device->GetState()->GetForce()), 0.0);
  EXPECT_TRUE(hand.Says("is gone: unplugged, switched off or out of reach"))
    << device->GetStatusText();
  device->Stop();
  device->Close();
  EXPECT_TRUE(Eventually(isStill));
}
