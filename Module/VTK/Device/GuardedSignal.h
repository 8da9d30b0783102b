// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A signal with a handler of this library, installed in front of the earlier handlers.
 *
 * Crash reporters also install handlers. A reporter that is installed later may restore this
 * library's handler and send the signal again. The earlier handlers are therefore kept as a list,
 * and each round removes one from it, so that each gets the signal, and the default action comes
 * last.
 */
#ifndef GuardedSignal_h
#define GuardedSignal_h

#include <atomic>
#include <csignal>

namespace VolumeHaptics
{

enum class SignalManner
{
  Deliver,       ///< the watcher ends the force, then sends the signal again
  Crash,         ///< the signal comes again when the handler returns
  CrashIfDefault ///< the same as Crash, but installed only if the signal has its default action
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

  /** Installs the handler for the signal's manner in front, unless it is there already. */
  void Install(Deliverer deliverer, Crasher crasher) noexcept;
  /** Returns the number of earlier handlers that are left, which changes with each PutBack. */
  int CountBefore() const noexcept { return this->Count.load(); }
  /**
   * Restores the next earlier handler, if `count` of them are still left, and if no other handler
   * was put in front since this one was installed. Signal handlers may call it, on several threads
   * at once.
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

/** Returns whether the instruction that crashed runs and crashes again when the handler returns. */
bool ComesAgain(int number, const siginfo_t& info) noexcept;

} // namespace VolumeHaptics

#endif
