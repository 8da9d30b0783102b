// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets a thread act when it crashes.
 *
 * A handler of a stack overflow runs only if the thread has an alternate stack. What the handler
 * has to do for this thread, such as ending the force of its device, is registered here, because a
 * thread that has crashed does no more work.
 */
#ifndef CrashGuard_h
#define CrashGuard_h

#include <cstddef>

namespace VolumeHaptics
{

class CrashGuard
{
public:
  /** A function to be called in a crash. It must use neither locks nor memory from the heap. */
  using Act = void (*)(void*) noexcept;

  /**
   * Sets an alternate stack for the calling thread while this lives, unless the thread has one, and
   * registers an act for it. The object must be destroyed by the same thread. At most 64 acts are
   * registered at a time in a process; more are ignored.
   */
  explicit CrashGuard(Act act = nullptr, void* object = nullptr) noexcept;
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

  /** Runs the act of the calling thread, once. A handler of a crash calls it. */
  static void RunAct() noexcept;

private:
  void* Memory = nullptr; // the alternate stack, if it is this object's
  std::size_t Size = 0;
  int Slot = -1;
};

} // namespace VolumeHaptics

#endif
