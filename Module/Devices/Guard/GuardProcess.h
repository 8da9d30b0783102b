// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The guard as a process of its own: found, started, waited for.
 */
#ifndef GuardProcess_h
#define GuardProcess_h

#include "Devices/Guard/GuardMemory.h"

#include <sys/types.h>

#include <vector>

namespace VolumeHaptics
{

/**
 * The guard's program: what the environment variable VOLUMEHAPTICS_GUARD names, else the one near
 * this library. Empty, with the reason and the cure.
 */
std::string FindGuardProgram(std::string& error);
/**
 * volumehaptics-guard in or above the folder of a file, or in a folder "bin" there. It runs with
 * all rights of the user, so one that another user could have written is passed over: then the
 * obstacle says why, unless it says something already.
 */
std::string FindGuardNear(const std::string& file, std::string& obstacle);

class GuardProcess
{
public:
  GuardProcess() = default;
  /** Ends it. */
  ~GuardProcess();
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  /**
   * Starts it and waits until it has the device: then its name for people. False, with the reason
   * and the cure. The device is what the guard makes a driver of.
   */
  bool Start(GuardMemory& memory, const std::vector<std::string>& device, std::string& name,
    std::string& error);

  /** Whether it has ended; waits for that for a time (ms). */
  bool HasEnded(int time) const noexcept;
  /** Whether it was stopped by a signal since the last call. */
  bool HasStopped() const noexcept;
  /**
   * Kills it if it goes on. Whether it had ended by itself, as it does when it is asked to; and how
   * it ended, in words.
   */
  bool End(std::string& how);
  /** In a forked child: the process is the parent's. */
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
