// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The limits that are common to all gamepads.
 */
#ifndef PadLimits_h
#define PadLimits_h

#include "Devices/Common/RateTip.h"

namespace VolumeHaptics
{

/** Largest force (N) whose changes are rendered. A pad exerts no force. */
constexpr double MostPadForce = 8.0;

inline DeviceLimits MakePadLimits() noexcept
{
  DeviceLimits limits;
  limits.MaximumForce = MostPadForce;
  limits.WorkspaceRadius = RateTip::Radius;
  limits.MovesTip = false;
  limits.Vibrates = true;
  return limits;
}

} // namespace VolumeHaptics

#endif
