// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A signal with a handler of this library in front of the handlers from before.
 *
 * Crash reporters do the same: a handler in front of this library's may put this library's back and
 * send the signal again. The handlers from before are therefore a list, from which each round takes
 * one, so that each gets the signal, and the default action comes last.
 */
#ifndef GuardedSignal_h
#define GuardedSignal_h

#include <atomic>
#include <csignal>

namespace VolumeHaptics
{

enum class SignalManner
{
  Deliver,       ///< the force ends first, then the signal is sent again
  Crash,         ///< the signal comes again at once
  CrashIfDefault ///< as Crash, but left alone if the signal is handled or ignored
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

  /** Puts the handler for the manner in front, unless it is there already. */
  void Install(Deliverer deliverer, Crasher crasher) noexcept;
  /** The number of handlers from before that are left; changes with each PutBack. */
  int CountBefore() const noexcept { return this->Count.load(); }
  /**
   * Puts the handler from before back that was next when `count` were left, unless that was done,
   * or another handler was put in front meanwhile. For signal handlers, of several threads at once.
   */
  void PutBack(int count) noexcept;

private:
  static constexpr int Most = 8;

  bool IsOurs(const struct sigaction& action) const noexcept;
  void Note(const struct sigaction& action) noexcept;

  const int Number;
  const SignalManner Manner;
  Deliverer Ours = nullptr;
  Crasher OurCrasher = nullptr;
  struct sigaction Before[Most] = {};
  std::atomic<int> Count{ 0 };
};

/**
 * Whether the instruction of a crash runs again, and crashes again, when the handler returns.
 */
bool ComesAgain(int number, const siginfo_t& info) noexcept;

} // namespace VolumeHaptics

#endif
