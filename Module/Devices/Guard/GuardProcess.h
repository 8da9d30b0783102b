// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The guard as a separate process: finds it, starts it, and waits for it.
 */
#ifndef GuardProcess_h
#define GuardProcess_h

#include "Devices/Common/HardwareDevice.h"
#include "Devices/Guard/GuardMemory.h"

#include <sys/types.h>

#include <vector>

namespace VolumeHaptics
{

/**
 * Finds the guard's program: the one in the environment variable VOLUMEHAPTICS_GUARD, otherwise the
 * one near this library. If there is none, returns an empty path and writes the reason and the cure
 * to `error`.
 */
std::string FindGuardProgram(std::string& error);

class GuardProcess
{
public:
  GuardProcess() = default;
  /** Ends the process. */
  ~GuardProcess();
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  /**
   * Starts the process, which makes the driver from the words `device`, and waits until it has
   * opened the device. Writes the device's name and identity to `facts`. On failure, returns false
   * and writes the reason and the cure to `error`.
   */
  bool Start(GuardMemory& memory, const std::vector<std::string>& device, DriverFacts& facts,
    std::string& error);

  /** Returns whether the process has ended. Waits for this at most `time` (ms). */
  bool HasEnded(int time) const noexcept;
  /** Returns whether a signal has stopped the process since the last call. */
  bool HasStopped() const noexcept;
  /**
   * Kills the process if it still runs. Returns whether it had ended by itself, as it does on
   * request. `how` receives a description of how it ended.
   */
  bool End(std::string& how);
  /**
   * Releases the guard without ending it. Called in a forked child, because the guard belongs to
   * the parent.
   */
  void Abandon() noexcept;

private:
  bool Spawn(
    GuardMemory& memory, const std::vector<std::string>& device, int itsLink, std::string& error);
  bool ReadAnswer(DriverFacts& facts, std::string& error);

  pid_t Process = -1;
  int Link = -1;
};

} // namespace VolumeHaptics

#endif
