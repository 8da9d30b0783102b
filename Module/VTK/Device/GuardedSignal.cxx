// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#if !defined(_WIN32)
#include "VTK/Device/GuardedSignal.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

bool IsSame(const struct sigaction& a, const struct sigaction& b) noexcept
{
  const bool isLong = (a.sa_flags & SA_SIGINFO) != 0;
  return isLong == ((b.sa_flags & SA_SIGINFO) != 0) &&
    (isLong ? a.sa_sigaction == b.sa_sigaction : a.sa_handler == b.sa_handler);
}

} // namespace

bool GuardedSignal::IsOurs(const struct sigaction& action) const noexcept
{
  const bool isLong = (action.sa_flags & SA_SIGINFO) != 0;
  return isLong ? this->OurCrasher && action.sa_sigaction == this->OurCrasher
                : this->Ours && action.sa_handler == this->Ours;
}

void GuardedSignal::Record(const struct sigaction& action) noexcept
{
  const int count = this->Count.load();
  int at = 0;
  while (at < count && !IsSame(this->Before[at], action))
  {
    ++at;
  }
  // If the action is already in the list, drop the actions after it. If the list is full, replace
  // the last one.
  at = at < Most ? at : Most - 1;
  this->Before[at] = action;
  this->Count.store(at + 1);
}

void GuardedSignal::Install(Deliverer deliverer, Crasher crasher) noexcept
{
  const bool delivers = this->Manner == SignalManner::Deliver;
  this->Ours = delivers ? deliverer : nullptr;
  this->OurCrasher = delivers ? nullptr : crasher;
  struct sigaction now = {};
  sigaction(this->Number, nullptr, &now);
  const bool isDefault = (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler == SIG_DFL;
  if (this->IsOurs(now) || (this->Manner == SignalManner::CrashIfDefault && !isDefault))
  {
    return;
  }
  this->Record(now);
  struct sigaction action = {};
  action.sa_flags = SA_RESTART | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  if (delivers)
  {
    action.sa_handler = deliverer;
  }
  else
  {
    action.sa_flags |= SA_SIGINFO;
    action.sa_sigaction = crasher;
  }
  sigaction(this->Number, &action, nullptr);
}

void GuardedSignal::PutBack(int count) noexcept
{
  struct sigaction now = {};
  sigaction(this->Number, nullptr, &now);
  if (!this->IsOurs(now) || !this->Count.compare_exchange_strong(count, std::max(0, count - 1)))
  {
    return;
  }
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  sigaction(this->Number, count > 0 ? &this->Before[count - 1] : &action, nullptr);
}

bool ComesAgain(int number, const siginfo_t& info) noexcept
{
  // A code above zero means that the kernel raised the signal; otherwise a program sent it. Damaged
  // memory that was found before its use (BUS_MCEERR_AO) is not yet a crash.
  return (number == SIGSEGV || number == SIGBUS || number == SIGFPE || number == SIGILL) &&
    info.si_code > 0
#if defined(BUS_MCEERR_AO)
    && !(number == SIGBUS && info.si_code == BUS_MCEERR_AO)
#endif
    ;
}

} // namespace VolumeHaptics
#endif
