// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a gamepad's sticks and buttons, and the motion of the tip that they cause.
 */
#ifndef PadState_h
#define PadState_h

#include "Core/Math/Vector3.h"

#include <cstdint>

namespace VolumeHaptics
{

/** Bits of PadState::Buttons, named after the buttons' positions on the pad. */
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
  PadLeftStick = 1U << 8,  ///< pressing the left stick
  PadRightStick = 1U << 9, ///< pressing the right stick
  PadMode = 1U << 10       ///< the button with the maker's logo
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
 * right stick moves it forward and back, as do the triggers (right: forward, left: back). Moving
 * the right stick sideways rotates the volume. While the left shoulder button is held, everything
 * moves at a fifth of the speed. The right shoulder button is the clutch: while it is held, the tip
 * stays in place.
 */
PadMotion Steer(const PadState& state) noexcept;

///@{
/**
 * Map a reported value between two ends to -1 to 1 for a stick, or to 0 to 1 for a trigger. The
 * result is 0 in a dead zone around the rest position, and continuous at the zone's border. The
 * zone is 12 % of half a stick's range or 5 % of a trigger's, or the driver's own dead zone `flat`
 * if that is larger. Return 0 if the ends are equal or reversed.
 */
double ScaleStick(int value, int least, int most, int flat = 0) noexcept;
double ScaleTrigger(int value, int least, int most, int flat = 0) noexcept;
///@}

} // namespace VolumeHaptics

#endif
