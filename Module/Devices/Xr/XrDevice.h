// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A controller of a headset, "vibration:xr", whose tip the program leads and which the program
 * makes vibrate.
 *
 * Only the program that draws for a headset knows where its controllers are, and only it can make
 * them vibrate. So it leads the tip as that of the virtual device, and asks in each frame for the
 * amplitude. A frame lasts as long as ten ticks or so: the largest amplitude of all of them counts,
 * so that no short touch is lost.
 *
 * A controller has one motor where a gamepad has two: it gets the larger one of the levels of
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
  /** s: a servo that has given no force for so long stands still, and nothing vibrates. */
  static constexpr double LongestSilence = 0.1;

  XrDevice();

  std::string GetName() const override { return "A controller of a headset, vibration, not force"; }
  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override;

  /** Any one thread: the largest amplitude since the last call, 0 to 1. */
  double TakeAmplitude() noexcept;

private:
  // Used by the servo only.
  Vibration Levels;
  double Elapsed = 0.0; ///< s, since the last Write

  std::atomic<double> Largest{ 0.0 }; ///< since the last TakeAmplitude
  std::atomic<std::int64_t> WrittenAt{ 0 };
  std::atomic<bool> IsQuenched{ true };
};

} // namespace VolumeHaptics

#endif
