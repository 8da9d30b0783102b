// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A virtual tip whose velocity a device controls, for devices that are pushed rather than moved.
 *
 * In the tip's frame, x points to the right, y up and z towards the hand. The tip begins at the
 * origin and stays in a ball around it.
 */
#ifndef RateTip_h
#define RateTip_h

#include "Devices/Common/HardwareExchange.h"

namespace VolumeHaptics
{

class RateTip
{
public:
  static constexpr double FullSpeed = 0.1; ///< speed of the tip at a full push (m/s)
  /** Angular velocity of the view while the device is turned fully (rad/s). */
  static constexpr double FullTurn = 1.0;
  static constexpr double Radius = 0.1; ///< radius of the ball (m)

  /** Places the tip at the origin, at rest. */
  void Begin(HardwareExchange& exchange) noexcept;
  /**
   * Moves the tip by the time since the last call, and reports it. The norms of `push` and `turn`
   * are from 0 to 1. If a released device sends nothing, the tip's position is still known, because
   * only this function moves the tip.
   */
  void Move(HardwareExchange& exchange, const Vector3& push, const Vector3& turn,
    std::uint32_t buttons) noexcept;

private:
  DeviceSample Told; ///< the last sample
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
