// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface to a vibrating service or device with an open protocol.
 *
 * One thread calls it (VibrationDriver.h). The amplitude is the larger of the two levels of
 * Vibration.h, because none of these protocols has two motors.
 */
#ifndef VibrationService_h
#define VibrationService_h

#include <string>

namespace VolumeHaptics
{

class VibrationService
{
public:
  enum class State
  {
    Ready,
    Waiting, ///< connected, but can't vibrate yet: GetText() returns what is required
    Gone     ///< disconnected: GetText() returns the reason and the cure
  };

  VibrationService() = default;
  virtual ~VibrationService() = default;
  VibrationService(const VibrationService&) = delete;
  VibrationService& operator=(const VibrationService&) = delete;

  /** Returns the readable name; after Connect(), that of the device. */
  virtual std::string GetName() const = 0;
  /**
   * Connects, and stops earlier vibrations. On failure, returns false and writes the reason and the
   * cure to `error`. Takes at most two seconds.
   */
  virtual bool Connect(std::string& error) = 0;
  /**
   * Vibrates with an amplitude, 0 to 1, until the next call, which follows within some
   * milliseconds. Returns at once.
   */
  virtual State Show(double amplitude) = 0;
  /** Returns a text that continues a sentence after the device's name. */
  virtual std::string GetText() const = 0;
  /**
   * Stops the vibration by a system call only, for a crash handler. Does nothing if the vibration
   * ends by itself.
   */
  virtual void StopAtCrash() noexcept {}
  /** Stops the vibration, then closes the connection. */
  virtual void Disconnect() noexcept = 0;
};

} // namespace VolumeHaptics

#endif
