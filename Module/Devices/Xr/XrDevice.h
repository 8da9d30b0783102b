// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A controller of a headset, "vibration:xr", whose tip the program leads and which the program
 * makes vibrate.
 *
 * Only the program that draws for a headset has the places of its controllers, and can make them
 * vibrate. So it leads the tip as with the virtual device, and reads the amplitude in each frame. A
 * frame lasts about ten ticks: their largest amplitude counts, so that no short touch is lost.
 *
 * A controller has one motor where a gamepad has two: it gets the larger of the levels in
 * Vibration.h.
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
  /** If the servo has given no force for this long (s), it stands still, and nothing vibrates. */
  static constexpr double LongestSilence = 0.1;

  XrDevice();

  std::string GetName() const override { return "A controller of a headset, vibration, not force"; }
  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override;

  /** Returns the largest amplitude since the last call, 0 to 1. Any one thread. */
  double DrainAmplitude() noexcept;

private:
  // Used by the servo only.
  Vibration Levels;
  double Elapsed = 0.0; ///< s, the time since the last Write

  std::atomic<double> Largest{ 0.0 }; ///< the largest amplitude since the last DrainAmplitude
  std::atomic<std::int64_t> WrittenAt{ 0 };
  std::atomic<bool> IsQuenched{ true };
};

} // namespace VolumeHaptics

#endif
