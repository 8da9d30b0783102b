// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A signal with a handler of this library, installed in front of the earlier handlers.
 *
 * Crash reporters also install handlers. A reporter that is installed later may restore this
 * library's handler and send the signal again. The earlier handlers are therefore kept in a list.
 * Each time the signal comes back, one is removed from the list and restored, so that each handler
 * gets the signal, and the default action comes last.
 */
#ifndef GuardedSignal_h
#define GuardedSignal_h

#include <atomic>
#include <csignal>

namespace VolumeHaptics
{

enum class SignalManner
{
  Deliver,       ///< the watcher thread ends the force, then sends the signal again
  Crash,         ///< the signal is raised again when the handler returns
  CrashIfDefault ///< same as Crash, but the handler is installed only over the default action
};

class GuardedSignal
{
public:
  using Deliverer = void (*)(int);
  using Crasher = void (*)(int, siginfo_t*, void*);

  GuardedSignal(int number, SignalManner manner)
    : Number(number)
    , Manner(manner)
  {
  }

  int GetNumber() const noexcept { return this->Number; }

  /**
   * Installs the handler for the signal's manner in front of the others, unless it is already
   * there.
   */
  void Install(Deliverer deliverer, Crasher crasher) noexcept;
  /** Returns the number of earlier handlers that are left; each PutBack() changes it. */
  int CountBefore() const noexcept { return this->Count.load(); }
  /**
   * Restores the next earlier handler, if `count` of them are still left and no other handler was
   * installed in front since. Safe to call in signal handlers, on several threads at once.
   */
  void PutBack(int count) noexcept;

private:
  static constexpr int Most = 8;

  bool IsOurs(const struct sigaction& action) const noexcept;
  void Record(const struct sigaction& action) noexcept;

  const int Number;
  const SignalManner Manner;
  Deliverer Ours = nullptr;
  Crasher OurCrasher = nullptr;
  struct sigaction Before[Most] = {};
  std::atomic<int> Count{ 0 };
};

/**
 * Returns whether the instruction that crashed runs again, and crashes again, when the handler
 * returns.
 */
bool ComesAgain(int number, const siginfo_t& info) noexcept;

} // namespace VolumeHaptics

#endif
