// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the sticks and buttons of gamepads, and the motion of the tip that they cause. */

#include "Devices/Pad/PadState.h"

#include <gtest/gtest.h>

#include <climits>
#include <cmath>

using namespace VolumeHaptics;

TEST(PadState, NothingJumpsAtTheDeadZone)
{
  EXPECT_EQ(ScaleStick(0, -32768, 32767), 0.0);
  EXPECT_EQ(ScaleStick(32767, -32768, 32767), 1.0);
  EXPECT_EQ(ScaleStick(-32768, -32768, 32767), -1.0);
  EXPECT_EQ(ScaleStick(127, 0, 255), 0.0);
  EXPECT_EQ(ScaleStick(128, 0, 255), 0.0);
  EXPECT_EQ(ScaleStick(255, 0, 255), 1.0);
  EXPECT_NEAR(ScaleStick(50, -100, 100), (0.5 - 0.12) / 0.88, 1e-12);
  EXPECT_NEAR(ScaleStick(50, -100, 100, 30), (0.5 - 0.3) / 0.7, 1e-12) << "the driver's own";
  for (int value = -100; value < 100; ++value)
  {
    const double step = ScaleStick(value + 1, -100, 100) - ScaleStick(value, -100, 100);
    EXPECT_GE(step, 0.0);
    EXPECT_LE(step, 0.01 / 0.88 + 1e-12);
    EXPECT_EQ(ScaleStick(-value, -100, 100), -ScaleStick(value, -100, 100));
  }
  EXPECT_EQ(ScaleTrigger(0, 0, 255), 0.0);
  EXPECT_EQ(ScaleTrigger(12, 0, 255), 0.0);
  EXPECT_EQ(ScaleTrigger(255, 0, 255), 1.0);
  EXPECT_NEAR(ScaleTrigger(50, 0, 100), 0.45 / 0.95, 1e-12);
}

TEST(PadState, RangesThatAreNoneAreRest)
{
  for (const int value : { INT_MIN, -1, 0, 7, INT_MAX })
  {
    EXPECT_EQ(ScaleStick(value, 5, 5), 0.0);
    EXPECT_EQ(ScaleStick(value, 7, -7), 0.0);
    EXPECT_EQ(ScaleTrigger(value, 5, 5), 0.0);
    const double stick = ScaleStick(value, INT_MIN, INT_MAX, INT_MAX);
    EXPECT_LE(std::abs(stick), 1.0);
    EXPECT_LE(std::abs(ScaleStick(value, 0, 255, INT_MAX)), 1.0);
  }
}

TEST(PadState, TheLeftStickIsAcrossAndTheRightOneAlong)
{
  PadState state;
  state.LeftX = 0.5;
  EXPECT_EQ(Steer(state).Push.X, 0.5) << "to the right";
  state = {};
  state.LeftY = -1.0;
  EXPECT_EQ(Steer(state).Push.Y, 1.0) << "a stick that is pushed away reports less, and is up";
  state = {};
  state.RightY = -1.0;
  EXPECT_EQ(Steer(state).Push.Z, -1.0) << "away from the hand";
  state = {};
  state.RightTrigger = 0.5;
  EXPECT_EQ(Steer(state).Push.Z, -0.5) << "it presses";
  state.LeftTrigger = 1.0;
  EXPECT_EQ(Steer(state).Push.Z, 0.5);
  state = {};
  state.RightX = 0.25;
  EXPECT_EQ(Steer(state).Turn.Y, 0.25);
  EXPECT_EQ(Norm(Steer(state).Push), 0.0);
}

TEST(PadState, CornersAreNoFasterAndShouldersAreSlowAndStill)
{
  PadState state;
  state.LeftX = state.LeftY = state.RightY = 1.0;
  EXPECT_NEAR(Norm(Steer(state).Push), 1.0, 1e-12);
  state.Buttons = PadLeftShoulder;
  EXPECT_NEAR(Norm(Steer(state).Push), 0.2, 1e-12);
  state.Buttons = PadRightShoulder;
  state.RightX = 1.0;
  EXPECT_EQ(Norm(Steer(state).Push) + Norm(Steer(state).Turn), 0.0);
}
