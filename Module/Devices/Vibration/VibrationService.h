// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A service or a device of an open protocol that vibrates: what its protocol has to do.
 *
 * One thread calls it (VibrationDriver.h), with one amplitude, the larger one of the two levels of
 * Vibration.h, since none of these protocols has two motors.
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
    Waiting, ///< connected, but it can't vibrate yet: GetText() asks for what it needs
    Gone     ///< disconnected: GetText() has the reason and the cure
  };

  VibrationService() = default;
  virtual ~VibrationService() = default;
  VibrationService(const VibrationService&) = delete;
  VibrationService& operator=(const VibrationService&) = delete;

  /** Returns the name for people; after Connect(), that of the device. */
  virtual std::string GetName() const = 0;
  /**
   * Connects, and stops earlier vibrations. Returns false and writes the reason and the cure to
   * `error` if this fails. Takes two seconds at most.
   */
  virtual bool Connect(std::string& error) = 0;
  /**
   * Vibrates with an amplitude, 0 to 1, until the next call, which comes within some milliseconds.
   * Returns at once.
   */
  virtual State Show(double amplitude) = 0;
  /** Returns a text to be read after the device's name. */
  virtual std::string GetText() const = 0;
  /**
   * Stops the vibration by a system call only, as the handler of a crash needs it. Does nothing if
   * the vibration ends by itself.
   */
  virtual void StopAtCrash() noexcept {}
  /** Stops the vibration, then closes the connection. */
  virtual void Disconnect() noexcept = 0;
};

} // namespace VolumeHaptics

#endif
