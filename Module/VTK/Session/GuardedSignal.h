// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A signal with a handler of ours in front of whatever handled it before.
 *
 * Crash reporters do the same: what is in front of us may put us back and send the signal again.
 * Handlers before us are therefore a list, from which each round takes one, so that every one is
 * met and the default action last.
 */
#ifndef GuardedSignal_h
#define GuardedSignal_h

#include <atomic>
#include <csignal>

namespace VolumeHaptics
{

enum class SignalManner
{
  Deliver,       ///< something else happens first, and then it is sent again
  Crash,         ///< it is met again at once
  CrashIfDefault ///< in the same way, but left alone where it is handled or ignored
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

  /** Puts the handler of the manner in front, unless it is there. */
  void Install(Deliverer deliverer, Crasher crasher) noexcept;
  /** How many handlers there are to be met: another number after each PutBack. */
  int CountBefore() const noexcept { return this->Count.load(); }
  /**
   * Puts back what was there when so many were to be met, unless that has been done, or something
   * else was put in front meanwhile. From signal handlers, of several threads at once.
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
 * Whether an instruction that a crash interrupted is run again, and crashes again, when the handler
 * returns.
 */
bool ComesAgain(int number, const siginfo_t& info) noexcept;

} // namespace VolumeHaptics

#endif
