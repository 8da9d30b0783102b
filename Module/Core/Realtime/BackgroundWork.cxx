// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Realtime/BackgroundWork.h"

#include "Core/Realtime/ServoPriority.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
/** The runs that a thread has begun and no longer needs. */
class BackgroundWork::Leavings
{
public:
  /**
   * Returns the unneeded runs of the calling thread. Returns null at the thread's end, where static
   * objects may still end their work.
   */
  static Leavings* OfThread()
  {
    thread_local Leavings leavings;
    return IsGone ? nullptr : &leavings;
  }

  /** Waits for the runs that the ending thread has begun, because nothing else waits for them. */
  ~Leavings()
  {
    // Releasing a task may end other work that the task owns, and add its run.
    while (!this->Runs.empty())
    {
      for (std::unique_ptr<Run>& run : std::exchange(this->Runs, {}))
      {
        WaitFor(std::move(run));
      }
    }
    IsGone = true;
    for (Spent& spent : this->Threads)
    {
      if (spent.Process == ServoClock::GetProcess())
      {
        spent.Thread.join();
      }
      else
      {
        spent.Thread.detach(); // this process has no such thread
      }
    }
  }

  /** Waits for the end of a run, and releases the objects of its task. */
  static void WaitFor(std::unique_ptr<Run> run)
  {
    if (!run->IsOurs())
    {
      (void)run.release(); // the thread belongs to the parent process
    }
    else if (run->Thread.joinable())
    {
      run->Thread.join();
    }
  }

  void Own(std::unique_ptr<Run> run) { this->Runs.push_back(std::move(run)); }

  /** Releases the objects of the tasks that have returned. */
  void Release()
  {
    const auto over = std::partition(this->Runs.begin(), this->Runs.end(),
      [](const std::unique_ptr<Run>& run) { return !run->IsOurs() || !run->IsOver(); });
    // A release may run the program's code, which may end other work, and change this->Runs.
    std::vector<std::unique_ptr<Run>> runs(
      std::make_move_iterator(over), std::make_move_iterator(this->Runs.end()));
    this->Runs.erase(over, this->Runs.end());
    for (std::unique_ptr<Run>& run : runs)
    {
      if (run->Thread.joinable())
      {
        this->Threads.push_back({ std::move(run->Thread), run->Process });
      }
    }
  }

  /** Returns the threads whose tasks have returned, so that another thread can join them. */
  std::vector<std::thread> DrainThreads()
  {
    std::vector<std::thread> threads;
    for (Spent& spent : this->Threads)
    {
      if (spent.Process == ServoClock::GetProcess())
      {
        threads.push_back(std::move(spent.Thread));
      }
      else
      {
        spent.Thread.detach(); // this process has no such thread
      }
    }
    this->Threads.clear();
    return threads;
  }

private:
  struct Spent
  {
    std::thread Thread;
    std::int64_t Process;
  };
  std::vector<std::unique_ptr<Run>> Runs;
  std::vector<Spent> Threads;
  // Has no destructor, so that it can still be read while the thread ends.
  static thread_local bool IsGone;
};

thread_local bool BackgroundWork::Leavings::IsGone = false;

void BackgroundWork::Run::Do() noexcept
{
  while (this->Before && !this->Before->load(std::memory_order_acquire))
  {
    ServoClock::SleepUntil(ServoClock::Now() + ServoClock::Millisecond);
  }
  try
  {
    if (!this->Monitor.IsCancelled())
    {
      this->Work(this->Monitor);
    }
  }
  catch (const std::bad_alloc&) // the work has no result
  {
  }
  this->HasReturned->store(true, std::memory_order_release);
}

void BackgroundWork::Begin(Task task)
{
  this->End();
  auto run = std::make_unique<Run>();
  run->Work = std::move(task);
  // In a forked process, the parent's work never ends, so do not wait for it.
  run->Before = this->LastProcess == ServoClock::GetProcess() ? std::move(this->Last) : nullptr;
  this->Current = std::move(run);
  Run* const current = this->Current.get();
  Leavings* const leavings = Leavings::OfThread();
  auto spent = std::make_shared<std::vector<std::thread>>(
    leavings ? leavings->DrainThreads() : std::vector<std::thread>());
  try
  {
    current->Thread = std::thread(
      [current, spent]
      {
        ServoClock::BlockSignals();
        ServoPriority::LowerThread();
        for (std::thread& thread : *spent)
        {
          thread.join();
        }
        spent->clear();
        current->Do();
      });
  }
  catch (const std::system_error&)
  {
    for (std::thread& thread : *spent)
    {
      thread.join();
    }
    current->Do();
  }
}

void BackgroundWork::End() noexcept
{
  if (this->Current && !this->IsOurs())
  {
    (void)this->Current.release(); // the thread belongs to the parent process
    this->Last = nullptr;
  }
  if (this->Current)
  {
    this->Current->Monitor.Cancel();
    this->Last = this->Current->HasReturned;
    this->LastProcess = this->Current->Process;
    if (Leavings* const leavings = Leavings::OfThread())
    {
      leavings->Own(std::move(this->Current));
      leavings->Release();
    }
    else
    {
      Leavings::WaitFor(std::move(this->Current));
    }
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
  if (Leavings* const leavings = Leavings::OfThread())
  {
    leavings->Release();
  }
  return this->Current && this->IsOurs() && this->Current->IsOver();
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
