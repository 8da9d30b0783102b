// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs a child process in which a device's thread overflows its stack while force acts. The parent
 * emulates the device, so the device outlives the child.
 */
#ifndef OverflowRig_h
#define OverflowRig_h

#include "PhantomRig.h"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <set>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace emulated
{

/// Calls itself until the stack overflows.
#if defined(__GNUC__)
__attribute__((noinline, no_sanitize("address", "undefined")))
#endif
inline int
Overflow(int depth)
{
  volatile char room[512];
  room[depth % 512] = static_cast<char>(depth);
  return depth < 0 ? 0 : Overflow(depth + 1) + room[(depth + 1) % 512];
}

inline std::set<int> ListThreads()
{
  std::set<int> threads;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
  {
    threads.insert(std::atoi(task.path().filename().c_str()));
  }
  return threads;
}

/// Returns the first thread that has started since `before` was listed.
inline int FindNewThread(const std::set<int>& before)
{
  int thread = 0;
  for (const int one : ListThreads())
  {
    thread = thread == 0 && before.count(one) == 0 ? one : thread;
  }
  return thread;
}

/**
 * Opens the device `id` in a child process, and overflows its thread's stack as soon as a force
 * acts. Calls `lead`, which moves the hand into the face (true) or out of it, until the child has
 * ended. Returns the number of the signal that ended the child, or a negative number that
 * identifies the failed step.
 */
template <typename Lead>
int OverflowDeviceThread(PhantomHand& hand, const std::string& id, Lead&& lead)
{
  void* const shared = mmap(
    nullptr, sizeof(std::atomic<bool>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto* const isArmed = new (shared) std::atomic<bool>{ false };
  const pid_t child = fork();
  if (child == 0)
  {
    const rlimit none{ 0, 0 };
    setrlimit(RLIMIT_CORE, &none);
    // Overflow the stack of the device's thread. SIGTRAP is a crash signal: the thread blocks all
    // other signals.
    std::signal(SIGTRAP, [](int) { std::_Exit(Overflow(0)); });
    const std::set<int> before = ListThreads();
    if (!hand.Device->Open(id.c_str()))
    {
      std::_Exit(1);
    }
    const int thread = FindNewThread(before);
    if (!hand.Device->Start())
    {
      std::_Exit(2);
    }
    // On a busy machine, the servo may pause, after which the force starts again from zero, so
    // retry.
    bool isFelt = false;
    for (int attempt = 0; attempt < 5 && !isFelt; ++attempt)
    {
      *isArmed = false;
      if (attempt > 0)
      {
        hand.Device->Home();
      }
      if (hand.WaitFor(vtkHapticDevice::READY))
      {
        hand.Device->Arm();
        *isArmed = true;
        hand.Wait(
          [&]
          {
            isFelt = Length(hand.Device->GetState()->GetForce()) > 0.02;
            return isFelt || hand.Device->GetStatus() == vtkHapticDevice::FAULT;
          });
      }
    }
    if (!isFelt)
    {
      std::_Exit(3);
    }
    syscall(SYS_tgkill, getpid(), thread, SIGTRAP);
    Eventually([] { return false; });
    std::_Exit(4);
  }
  int status = 0;
  int looks = 0;
  bool hasEnded = false;
  for (int i = 0; i < 5 && !hasEnded; ++i)
  {
    hasEnded = Eventually(
      [&]
      {
        // A hand that is armed inside the face feels no force, so move it out of the face and in
        // again.
        lead(*isArmed && ++looks % 1000 > 300);
        return waitpid(child, &status, WNOHANG) == child;
      });
  }
  munmap(shared, sizeof(std::atomic<bool>));
  if (!hasEnded)
  {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return -5;
  }
  return WIFSIGNALED(status) ? WTERMSIG(status) : -WEXITSTATUS(status);
}

} // namespace emulated

#endif
