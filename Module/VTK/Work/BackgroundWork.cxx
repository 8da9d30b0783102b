// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Work/BackgroundWork.h"

#include <algorithm>
#include <new>
#include <system_error>

#if defined(__linux__)
#include <sys/resource.h>
#endif

namespace VolumeHaptics
{
namespace
{

/** Lets other threads run first. */
void LowerPriority() noexcept
{
#if defined(__linux__)
  // The calling thread alone, other than POSIX has it.
  constexpr int nice = 10;
  (void)setpriority(PRIO_PROCESS, 0, nice);
#endif
}

} // namespace

void BackgroundWork::Run::Do() noexcept
{
  try
  {
    this->Work(this->Monitor);
  }
  catch (const std::bad_alloc&) // there is no result
  {
  }
  this->HasReturned.store(true, std::memory_order_release);
}

void BackgroundWork::Begin(Task task)
{
  this->End();
  auto run = std::make_unique<Run>();
  run->Work = std::move(task);
  this->Current = std::move(run);
  Run* const current = this->Current.get();
  try
  {
    current->Thread = std::thread(
      [current]
      {
        ServoClock::BlockSignals();
        LowerPriority();
        current->Do();
      });
  }
  catch (const std::system_error&)
  {
    current->Do();
  }
}

void BackgroundWork::End() noexcept
{
  if (this->Current && !this->IsOurs())
  {
    (void)this->Current.release(); // its thread belongs to the parent
  }
  if (this->Current)
  {
    this->Current->Monitor.Cancel();
    if (this->Current->Thread.joinable())
    {
      this->Current->Thread.join();
    }
    this->Current.reset();
  }
}

void BackgroundWork::Cancel() noexcept
{
  if (this->Current && this->IsOurs())
  {
    this->Current->Monitor.Cancel();
  }
}

bool BackgroundWork::HasReturned() const
{
  return this->Current && this->IsOurs() &&
    this->Current->HasReturned.load(std::memory_order_acquire);
}

bool BackgroundWork::WaitFor(double seconds) const
{
  const auto end = ServoClock::Now() +
    static_cast<std::int64_t>(std::max(0.0, seconds) * ServoClock::NanosecondsPerSecond);
  const bool mayReturn = this->Current && this->IsOurs();
  while (mayReturn && !this->HasReturned() && ServoClock::Now() < end)
  {
    ServoClock::SleepUntil(std::min(end, ServoClock::Now() + ServoClock::Millisecond));
  }
  return this->HasReturned();
}

double BackgroundWork::GetProgress() const
{
  return this->Current ? this->Current->Monitor.GetProgress() : 0.0;
}

} // namespace VolumeHaptics
