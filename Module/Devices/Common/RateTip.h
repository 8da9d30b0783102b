// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A virtual tip whose velocity is controlled by a device, for devices that are pushed rather than
 * moved.
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
  /** Angular velocity (rad/s) at a full turn of the device. */
  static constexpr double FullTurn = 1.0;
  static constexpr double Radius = 0.1; ///< radius of the ball (m)

  /** Places the tip at the origin, at rest. */
  void Begin(HardwareExchange& exchange) noexcept;
  /**
   * Moves the tip by the time since the last call, and reports it. The norms of `push` and `turn`
   * are from 0 to 1. Call this even if a released device sends nothing: the tip's position stays
   * known, because only this function moves it.
   */
  void Move(HardwareExchange& exchange, const Vector3& push, const Vector3& turn,
    std::uint32_t buttons) noexcept;

private:
  DeviceSample Told; ///< last reported sample
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
