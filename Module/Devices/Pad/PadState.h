// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sticks and buttons of a gamepad, and how they move the tip.
 */
#ifndef PadState_h
#define PadState_h

#include "Core/Math/Vector3.h"

#include <cstdint>

namespace VolumeHaptics
{

/** Bits of PadState::Buttons, named by the buttons' places on the pad. */
enum PadButton : std::uint32_t
{
  PadSouth = 1U << 0, ///< the button A, or the cross
  PadEast = 1U << 1,
  PadWest = 1U << 2,
  PadNorth = 1U << 3,
  PadLeftShoulder = 1U << 4,  ///< the button above the left trigger
  PadRightShoulder = 1U << 5, ///< the button above the right trigger
  PadSelect = 1U << 6,
  PadStart = 1U << 7,
  PadLeftStick = 1U << 8,  ///< the left stick, pressed
  PadRightStick = 1U << 9, ///< the right stick, pressed
  PadMode = 1U << 10       ///< the maker's own button
};

struct PadState
{
  ///@{
  /** Positions of the sticks, -1 to 1. Right and down are positive, as drivers report them. */
  double LeftX = 0.0;
  double LeftY = 0.0;
  double RightX = 0.0;
  double RightY = 0.0;
  ///@}
  ///@{
  /** Positions of the triggers, 0 to 1. */
  double LeftTrigger = 0.0;
  double RightTrigger = 0.0;
  ///@}
  std::uint32_t Buttons = 0;
};

/** Speeds as fractions of the largest ones, in the tip's frame: right, up, towards the hand. */
struct PadMotion
{
  Vector3 Push;
  Vector3 Turn;
};

/**
 * Returns the motion for a state. The left stick moves the tip left and right, up and down. The
 * right stick moves it forward and back, and so do the triggers: the right one moves it forward,
 * and the left one back. The right stick also rotates the volume sideways. While the left shoulder
 * is held, everything moves at a fifth of the speed. The right shoulder is the clutch: while it is
 * held, the tip stays.
 */
PadMotion Steer(const PadState& state) noexcept;

///@{
/**
 * Map a reported value between two ends to -1 to 1 for a stick, or to 0 to 1 for a trigger. In a
 * dead zone around the rest position the result is 0, and it is continuous at the zone's border.
 * The zone is 12 % of a stick's half or 5 % of a trigger, or `flat`, the driver's own dead zone, if
 * that is larger. Return 0 if the ends are no range.
 */
double ScaleStick(int value, int least, int most, int flat = 0) noexcept;
double ScaleTrigger(int value, int least, int most, int flat = 0) noexcept;
///@}

} // namespace VolumeHaptics

#endif
