// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/CrashGuard.h"

#include "Core/Realtime/ServoClock.h"

#if !defined(_WIN32)
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>

#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace VolumeHaptics
{

#if !defined(_WIN32)

namespace
{

// Don't use thread_local: it would allocate memory if a handler is the first to use it in a thread.
struct RegisteredAct
{
  std::atomic<bool> IsTaken{ false };
  std::atomic<bool> IsSet{ false };
  pthread_t Thread{};
  std::int64_t Process = 0; // a forked child has only one of the threads
  CrashGuard::Act Act = nullptr;
  void* Object = nullptr;
};

constexpr int MostActs = 64;
RegisteredAct Acts[MostActs];

int Register(CrashGuard::Act act, void* object) noexcept
{
  for (int slot = 0; slot < MostActs; ++slot)
  {
    RegisteredAct& one = Acts[slot];
    if (!one.IsTaken.exchange(true))
    {
      one.Thread = pthread_self();
      one.Process = ServoClock::GetProcess();
      one.Act = act;
      one.Object = object;
      one.IsSet.store(true);
      return slot;
    }
  }
  return -1;
}

} // namespace

CrashGuard::CrashGuard(Act act, void* object) noexcept
{
  stack_t now{};
  if (sigaltstack(nullptr, &now) == 0 && (now.ss_flags & SS_DISABLE) != 0)
  {
    this->Size = 1 << 16;
#if defined(_SC_MINSIGSTKSZ)
    this->Size += static_cast<std::size_t>(std::max(0L, sysconf(_SC_MINSIGSTKSZ)));
#endif
    void* const memory =
      mmap(nullptr, this->Size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory != MAP_FAILED)
    {
      this->Memory = memory;
      stack_t mine{};
      mine.ss_sp = memory;
      mine.ss_size = this->Size;
      sigaltstack(&mine, nullptr);
    }
  }
  this->Slot = act != nullptr ? Register(act, object) : -1;
}

CrashGuard::~CrashGuard()
{
  if (this->Slot >= 0)
  {
    Acts[this->Slot].IsSet.store(false);
    Acts[this->Slot].IsTaken.store(false);
  }
  stack_t now{};
  if (this->Memory != nullptr && sigaltstack(nullptr, &now) == 0 && now.ss_sp == this->Memory)
  {
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
    munmap(this->Memory, this->Size);
  }
}

void CrashGuard::RunAct() noexcept
{
  for (RegisteredAct& one : Acts)
  {
    if (one.IsSet.load() && pthread_equal(one.Thread, pthread_self()) != 0 &&
      one.Process == ServoClock::GetProcess() && one.IsSet.exchange(false))
    {
      one.Act(one.Object);
      return;
    }
  }
}

#else

CrashGuard::CrashGuard(Act, void*) noexcept {}
CrashGuard::~CrashGuard() = default;
void CrashGuard::RunAct() noexcept {}

#endif

} // namespace VolumeHaptics
