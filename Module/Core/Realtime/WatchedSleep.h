// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file The servo's sleep between two ticks, and a second thread that ends the sleep if it gets too
 * long.
 *
 * A processor may keep a thread from running on time: the scheduler lets a busy thread continue,
 * the kernel is busy with interrupts off, or the host of a virtual machine has taken the processor
 * away. Such delays last milliseconds, and rarely affect two processors at the same time. After a
 * planned time, a watcher on another processor therefore checks whether the sleeper has woken up.
 * If it has not, the watcher moves it to its own processor and wakes it up there. This needs no
 * privilege.
 *
 *   WatchedSleep sleep(period);
 *   sleep.SleepUntil(time); // always the same thread
 *   sleep.Watch();          // on another thread, until RequestStop
 *
 * The sleep is a plain ServoClock::SleepUntil() if
 *
 * - there is no watcher,
 * - the sleeper may run on one processor only,
 * - the kernel does not allow threads to be moved, or has more than 1024 processors,
 * - the system is not Linux.
 *
 * A delay within a tick is not shortened.
 *
 * To move the sleeper, the watcher binds it to the watcher's processor. Both threads then restore
 * the sleeper's processors, unless someone else has changed them after the binding. Processors that
 * are added to the system later are not included.
 */
#ifndef WatchedSleep_h
#define WatchedSleep_h

#include <atomic>
#include <cstdint>

#if defined(__linux__)
#include <sched.h>
#endif

namespace VolumeHaptics
{

class WatchedSleep
{
public:
  /** @param period time between two ticks (ns) */
  explicit WatchedSleep(std::int64_t period) noexcept;

  /** Sleeps at least until `time`, as ServoClock::Now() counts it. */
  void SleepUntil(std::int64_t time) noexcept { this->SleepUntil(time, time); }
  /**
   * Sleeps with an alarm at `alarm`. If the alarm is later than `planned`, only a watcher can wake
   * the sleeper on time. For tests.
   */
  void SleepUntil(std::int64_t planned, std::int64_t alarm) noexcept;

  /**
   * Watches the sleeper until RequestStop(), which can't be undone. Only one thread may call this.
   * The thread gets the priority of a servo (ServoPriority::RaiseThread) and leaves the sleeper's
   * processor.
   */
  void Watch() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }

  /** Returns how often the watcher has tried to wake a late sleeper. */
  std::uint64_t GetRescues() const noexcept { return this->Rescues.load(); }

private:
  /** Planned end of the sleep (ns); 0 while the thread is awake. */
  std::atomic<std::int64_t> Planned{ 0 };
  std::atomic<std::uint64_t> Rescues{ 0 };
  std::atomic<bool> StopRequested{ false };

#if defined(__linux__)
  /** Whether the sleeper is bound to the watcher's processor. */
  enum class Binding : std::uint8_t
  {
    None,  ///< set by either thread; only in this state may the watcher change Allowed and Here
    Bound, ///< set by the watcher before it binds the sleeper
    Ending ///< set by the sleeper, which may read Allowed and Here only in this state
  };

  bool StandApart() noexcept;
  bool WakeHere(std::int64_t planned) noexcept;
  void EndBinding() noexcept;
  bool GiveBack() const noexcept;

  const std::int64_t Patience;            // delay (ns) after which the watcher wakes the sleeper
  std::atomic<std::int64_t> Sleeper{ 0 }; // the kernel's number of the sleeping thread
  std::atomic<int> Processor{ -1 };       // processor on which the sleeper fell asleep
  std::atomic<std::uint32_t> Wakes{ 0 };  // the futex word that the sleeper waits for
  std::atomic<Binding> State{ Binding::None };
  cpu_set_t Allowed{}; // processors on which the sleeper may run
  cpu_set_t Here{};    // processor to which the sleeper is bound
  ///@{
  /**
   * Data of the watcher alone: whether it still has to end a binding, and the processor that it has
   * left.
   */
  bool IsOwing = false;
  int Left = -1;
  ///@}
#endif
};

} // namespace VolumeHaptics

#endif
