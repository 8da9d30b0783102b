// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture for child processes with an armed device that receive a signal. */
#ifndef SignalsRig_h
#define SignalsRig_h

#include "Rigs/DeviceRig.h"

#include <atomic>
#include <csignal>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

namespace devicetest
{
inline vtkHapticDevice* Watched = nullptr;
inline std::atomic<int> Handled{ 0 };
inline std::atomic<int> ForceWhenHandled{ 0 };

/// Signal handler of the application, installed before the device's handler. Counts its calls, and
/// the calls during which the device still exerts force.
inline void OnSignal(int)
{
  Watched->UpdateState();
  ForceWhenHandled += Length(Watched->GetState()->GetForce()) > 0.0 ? 1 : 0;
  ++Handled;
}

class Signals : public DeviceTest
{
protected:
  /// Runs `body` in a child process. Returns its exit code, or minus the signal that ended it.
  template <typename F>
  static int InChild(F&& body)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      _exit(body());
    }
    return Wait(child);
  }
  static int Wait(pid_t child)
  {
    int status = 0;
    const bool ended = Eventually([&] { return waitpid(child, &status, WNOHANG) == child; });
    if (!ended)
    {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return 99;
    }
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  }
  /// Arms the device at a servo rate of 100 Hz, and waits until a force acts. With ticks of 10 ms,
  /// a test fails if the application's signal handler is called before the tick that cuts the
  /// force. Returns false if no force occurs.
  bool Activate()
  {
    Watched = this->Device;
    this->Device->SetServoRate(100.0);
    this->Begin();
    return this->ArmFully() && this->Lead(7.0, 7.0, 9.0) && this->WaitForce();
  }
};
} // namespace devicetest

#endif
