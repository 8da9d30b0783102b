// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A headset's controller, "vibration:xr". The program moves its tip, and makes it vibrate.
 *
 * Only the program that renders for a headset receives the positions of its controllers and can
 * make them vibrate. Therefore the program moves the tip as with the virtual device, and reads the
 * amplitude in each frame. A frame lasts about ten ticks, of which the largest amplitude is
 * returned, so that no short touch is lost.
 *
 * A controller has one motor instead of a gamepad's two, so the amplitude is the larger of the two
 * levels in Vibration.h.
 */
#ifndef XrDevice_h
#define XrDevice_h

#include "Devices/Pad/Vibration.h"
#include "Devices/Virtual/VirtualDevice.h"

#include <atomic>

namespace VolumeHaptics
{

class XrDevice final : public VirtualDevice
{
public:
  /**
   * Time (s) without a force from the servo after which the amplitude is zero, because the servo
   * has stopped.
   */
  static constexpr double LongestSilence = 0.1;

  XrDevice();

  std::string GetName() const override { return "A controller of a headset, vibration, not force"; }
  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override;

  /** Returns the largest amplitude since the last call, 0 to 1. May be called on any one thread. */
  double DrainAmplitude() noexcept;

private:
  // Members that only the servo uses.
  Vibration Levels;
  double Elapsed = 0.0; ///< time since the last Write() (s)

  std::atomic<double> Largest{ 0.0 }; ///< largest amplitude since the last DrainAmplitude()
  std::atomic<std::int64_t> WrittenAt{ 0 };
  std::atomic<bool> IsQuenched{ true };
};

} // namespace VolumeHaptics

#endif
