// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Registers a function that is called if a thread crashes.
 *
 * The handler of a stack overflow can only run if the thread has an alternate stack. The function
 * ends the force of the thread's device, for example, because a crashed thread does no more work.
 */
#ifndef CrashGuard_h
#define CrashGuard_h

#include <cstddef>

namespace VolumeHaptics
{

class CrashGuard
{
public:
  /** A function that is called in a crash. It must neither lock nor allocate. */
  using Act = void (*)(void*) noexcept;

  /**
   * Registers an act for the calling thread, and sets an alternate stack unless the thread has one.
   * Both end with this object, which must be destroyed by the same thread. A process can register
   * at most 64 acts at a time; further ones are ignored.
   */
  explicit CrashGuard(Act act = nullptr, void* object = nullptr) noexcept;
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;

  /** Runs the act of the calling thread, once. Crash handlers call this. */
  static void RunAct() noexcept;

private:
  void* Memory = nullptr; // the alternate stack, if it is this object's
  std::size_t Size = 0;
  int Slot = -1;
};

} // namespace VolumeHaptics

#endif
