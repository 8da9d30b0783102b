// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Asks the system to run the servo on time, within the user's privileges.
 *
 *   ServoPriority priority;
 *   priority.Raise();          // on the servo's thread, before its first tick
 *   priority.AskRealtimeKit(); // on another thread, because it may take seconds
 *
 * 1. The kernel: a real-time class (SCHED_FIFO), if a privilege or the limit RLIMIT_RTPRIO allows
 *    it.
 * 2. RealtimeKit, if the kernel refuses: see RealtimeKit.h.
 * 3. In any case, settings that need no privilege: wake-ups that are not delayed to save energy,
 *    and short time slices. On Linux 6.12 and later, a thread with short slices that needs less
 *    than its fair part of a processor runs as soon as it wakes up. Otherwise it may have to wait
 *    milliseconds until the slice of a busy thread ends.
 *
 * On Windows, the real-time class is that of the multimedia service (MMCSS), and on macOS that of
 * threads with a deadline; neither needs a privilege.
 *
 * Measurements are in Documentation/devices.md.
 */
#ifndef ServoPriority_h
#define ServoPriority_h

#include "Core/Realtime/RealtimeKit.h"

#include <atomic>
#include <cstdint>

namespace VolumeHaptics
{

/** Whether the servo's thread has a real-time class. */
enum class RealTimeGrant : std::uint8_t
{
  Unknown,     ///< not requested yet
  Asked,       ///< the kernel has refused, and RealtimeKit has not answered yet
  Kernel,      ///< granted by the kernel
  RealtimeKit, ///< granted by RealtimeKit
  NoService,   ///< refused by the kernel; there is no RealtimeKit
  Refused      ///< refused by the kernel and by RealtimeKit
};

class ServoPriority
{
public:
  /**
   * Requests a real-time class for the calling thread, with a priority below the kernel's interrupt
   * threads. If the request is refused, applies the settings that need no privilege. Returns
   * whether the class was granted.
   */
  static bool RaiseThread() noexcept;
  /** Lowers the priority of the calling thread, which does background work. */
  static void LowerThread() noexcept;

  /** Calls RaiseThread() and stores the result. Must be called on the servo's thread. */
  void Raise() noexcept;
  /**
   * Waits for Raise() and, if the kernel has refused, asks RealtimeKit. Must be called on another
   * thread. Returns after RealtimeKit's answer, or soon after RequestStop().
   */
  void AskRealtimeKit() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }

  RealTimeGrant GetGrant() const noexcept { return this->Grant.load(std::memory_order_acquire); }

private:
  /** Settings from the environment, which the constructing thread reads. */
  const RealtimeKit::Wish Environment = RealtimeKit::ReadEnvironment();
  std::atomic<RealTimeGrant> Grant{ RealTimeGrant::Unknown };
  /** The kernel's number of the servo's thread; 0 before Raise(). */
  std::atomic<std::int64_t> Thread{ 0 };
  std::atomic<bool> StopRequested{ false };
};

} // namespace VolumeHaptics

#endif
