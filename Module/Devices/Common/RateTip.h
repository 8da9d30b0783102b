// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A virtual tip that is led by its speed, for devices that are pushed rather than moved.
 *
 * In the tip's frame x is to the right, y up and z towards the hand. The tip stays in a ball about
 * the origin, in which it begins.
 */
#ifndef RateTip_h
#define RateTip_h

#include "Devices/Common/HardwareExchange.h"

namespace VolumeHaptics
{

class RateTip
{
public:
  static constexpr double FullSpeed = 0.1; ///< m/s, of the tip at a full push
  static constexpr double FullTurn = 1.0;  ///< rad/s, at a full turn
  static constexpr double Radius = 0.1;    ///< m: of the ball in which the tip stays

  /** To the origin, at rest. */
  void Begin(HardwareExchange& exchange) noexcept;
  /**
   * Moves it by the time since the last call, and tells where it is. Pushes and turns are of norm 0
   * to 1 each. A device that is let go may say nothing: where the tip stays is known all the same,
   * since nothing but this moves it.
   */
  void Move(HardwareExchange& exchange, const Vector3& push, const Vector3& turn,
    std::uint32_t buttons) noexcept;

private:
  DeviceSample Told; ///< the last one
  std::int64_t LastRound = 0;
};

} // namespace VolumeHaptics

#endif
