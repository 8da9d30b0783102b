// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The guard as a separate process: finds it, starts it, and waits for it.
 */
#ifndef GuardProcess_h
#define GuardProcess_h

#include "Devices/Guard/GuardMemory.h"

#include <sys/types.h>

#include <vector>

namespace VolumeHaptics
{

/**
 * Finds the guard's program: the one in the environment variable VOLUMEHAPTICS_GUARD, else the one
 * near this library. If there is none, returns an empty path and writes the reason and the cure to
 * `error`.
 */
std::string FindGuardProgram(std::string& error);
/**
 * Searches volumehaptics-guard in and above the folder of a file, and in a folder "bin" there. The
 * guard runs with all rights of the user, so a program that another user could have written is
 * skipped. The obstacle then receives the reason, unless it has a text already.
 */
std::string FindGuardNear(const std::string& file, std::string& obstacle);

class GuardProcess
{
public:
  GuardProcess() = default;
  /** Ends the process. */
  ~GuardProcess();
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  /**
   * Starts the process, waits until it has the device, and writes the device's readable name to
   * `name`. If this fails, returns false and writes the reason and the cure to `error`. The guard
   * makes the driver of the device from the words.
   */
  bool Start(GuardMemory& memory, const std::vector<std::string>& device, std::string& name,
    std::string& error);

  /** Returns whether the process has ended; waits at most a time (ms) for the end. */
  bool HasEnded(int time) const noexcept;
  /** Returns whether a signal has stopped the process since the last call. */
  bool HasStopped() const noexcept;
  /**
   * Kills the process if it still runs. Returns whether the process had ended by itself, as it does
   * on request; `how` receives how it ended.
   */
  bool End(std::string& how);
  /** Lets go of the guard without ending it, in a forked child: the parent owns the guard. */
  void Abandon() noexcept;

private:
  bool Spawn(
    GuardMemory& memory, const std::vector<std::string>& device, int itsLink, std::string& error);
  bool ReadAnswer(std::string& name, std::string& error);

  pid_t Process = -1;
  int Link = -1;
};

} // namespace VolumeHaptics

#endif
