// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Drives the motors of a gamepad through the kernel's force feedback (ff.rst of its documentation
 * of input).
 *
 * An effect lasts for ReplayLength and is renewed after Vibration::RenewTime, so that the motors
 * stop if this process stops. If the node is closed, for example because the process ends, the
 * kernel erases the effect, which stops the motors (evdev_release or, before Linux 5.7,
 * evdev_flush, then flush_effects in ff-core.c).
 *
 * Each change of the levels restarts the effect at once, because only a start marks the effect as
 * playing in the kernel. If an effect were changed without a start, and then stopped or erased
 * before the kernel's next timer tick, the motors would stay on (ml_ff_upload and ml_ff_playback in
 * ff-memless.c).
 */
#ifndef EvdevRumble_h
#define EvdevRumble_h

#include "Devices/Pad/Vibration.h"

#include <cstdint>

namespace VolumeHaptics
{

class EvdevRumble
{
public:
  static constexpr int ReplayLength = static_cast<int>(Vibration::ReplayTime * 1e3 + 0.5); ///< ms
  /** Number of levels of a motor: the resolution of pads. */
  static constexpr int Steps = 255;

  /**
   * Prepares an open node, and sets the full gain. Returns false if the driver can't store an
   * effect.
   */
  bool Begin(int node) noexcept;
  ///@{
  /** Sets the levels. Returns false if the device refuses them. */
  bool Show(const VibrationLevels& levels) noexcept;
  bool Silence() noexcept;
  ///@}
  /** Stops the motors and erases the effect. Must be called before the node is closed. */
  void End() noexcept;

private:
  struct Pair
  {
    int Strong = 0;
    int Weak = 0;
  };
  bool Send(const Pair& pair) noexcept;
  bool Upload(const Pair& pair) noexcept;
  bool Play(bool isOn) const noexcept;

  int Node = -1;
  int Id = -1; ///< number of the effect in the kernel; -1 if there is none yet
  Pair Sent;
  std::int64_t SentAt = 0;
};

} // namespace VolumeHaptics

#endif
