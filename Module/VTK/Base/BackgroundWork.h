// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Work on a volume that a hand must not wait for, on a thread of its own.
 *
 * The owner (the GUI thread) begins the work, looks at its progress, and takes its result whenever
 * it comes by; neither waits for the other. The work does its task in pieces of some milliseconds
 * and asks between them whether it is cancelled. A KeyedWork also knows which data its result is
 * of, and begins again if they have changed:
 *
 *   KeyedWork<DataKey, std::string> hash;
 *   const std::string* known = hash.Follow({ array, array->GetMTime() }, // on each GUI tick
 *     [array](WorkMonitor& monitor) { return HashArray(array, dimensions, monitor); });
 *
 * The owner releases the objects that the task holds, such as a reference to an array; the worker
 * never does: the last reference of a VTK object must not be dropped by another thread. Of work
 * that is cancelled while it goes on, the owner's thread releases them the next time that it calls
 * a function of any work after the end of the task's piece, or when that thread ends. So a task
 * has to own all that it reads: it may outlive the object that began it. The task
 * reads values while the program may write them: the program announces that with Modified(), and
 * gets another result. The memory of the values must stay where it is for as long as the array
 * exists, as for the servo: see vtkHapticDevice.
 *
 * The worker has a low priority, so that it delays neither the servo nor the picture. A forked
 * child has no worker; there, work that was under way never ends.
 */
#ifndef BackgroundWork_h
#define BackgroundWork_h

#include "Core/Realtime/ServoClock.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace VolumeHaptics
{

/** Passes progress from a task to its owner, and cancellation from the owner to the task. */
class WorkMonitor
{
public:
  ///@{
  /** Called by the task. */
  bool IsCancelled() const noexcept { return this->Cancelled.load(std::memory_order_relaxed); }
  void SetProgress(double share) noexcept { this->Share.store(share, std::memory_order_relaxed); }
  /** Tells the progress; false if the task is cancelled. */
  bool GoesOn(double share) noexcept
  {
    this->SetProgress(share);
    return !this->IsCancelled();
  }
  ///@}
  ///@{
  /** Called by the owner; the progress is 0 to 1. */
  void Cancel() noexcept { this->Cancelled.store(true, std::memory_order_relaxed); }
  double GetProgress() const noexcept { return this->Share.load(std::memory_order_relaxed); }
  ///@}

private:
  std::atomic<bool> Cancelled{ false };
  std::atomic<double> Share{ 0.0 };
};

/** A task on a thread of its own. All functions are for the owner. */
class BackgroundWork
{
public:
  using Task = std::function<void(WorkMonitor&)>;

  BackgroundWork() = default;
  /** Cancels the task, and does not wait for it. */
  ~BackgroundWork() { this->End(); }
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /**
   * Begins a task, instead of one that is under way, which is cancelled; the new one begins when
   * that one's piece has ended. If the system gives no thread, the task is done at once, before
   * this returns.
   */
  void Begin(Task task);
  /** Cancels the task, does not wait for it, and releases what it holds if it has returned. */
  void End() noexcept;

  /** Cancels the task, and does not wait: HasReturned() tells when its piece has ended. */
  void Cancel() noexcept;

  /** Whether a task was begun, and End() was not called since. */
  bool IsBegun() const { return this->Current != nullptr; }
  /** Whether it was begun by this process, and not by one that this one was forked from. */
  bool IsOurs() const { return this->Current && this->Current->IsOurs(); }
  /** Whether the task has returned; what it wrote can be read. */
  bool HasReturned() const;
  /** Waits until the task has returned, or for some seconds; returns whether it has. */
  bool WaitFor(double seconds) const;
  /** 0 to 1; 0 without a task. */
  double GetProgress() const;

private:
  using Flag = std::atomic<bool>;
  struct Run
  {
    Task Work;
    WorkMonitor Monitor;
    const std::shared_ptr<Flag> HasReturned = std::make_shared<Flag>(false);
    std::shared_ptr<const Flag> Before; ///< of the run that has to end first; or null
    std::thread Thread;
    const std::int64_t Process = ServoClock::GetProcess();

    bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }
    bool IsOver() const { return this->HasReturned->load(std::memory_order_acquire); }
    void Do() noexcept;
  };
  class Leavings;

  std::unique_ptr<Run> Current;
  std::shared_ptr<const Flag> Last; ///< of the run that was ended last; or null
  std::int64_t LastProcess = 0;     ///< that has begun it
};

/**
 * A result that is made in the background of the data that a key names, such as an array and the
 * time of its last change.
 */
template <typename Key, typename Result>
class KeyedWork
{
public:
  /** Returns nothing if it is cancelled. */
  using Maker = std::function<std::optional<Result>(WorkMonitor&)>;

  /**
   * The result of a key; null until it is known. If the key is another one than before, the work is
   * begun with `make`, and that of the old key is cancelled. If the work fails for lack of memory,
   * the result stays null.
   */
  const Result* Follow(const Key& key, const Maker& make)
  {
    if (!this->IsOf(key))
    {
      this->Forget();
      this->Of = key;
      const auto made = this->Made = std::make_shared<std::optional<Result>>();
      this->Work.Begin([made, make](WorkMonitor& monitor) { *made = make(monitor); });
    }
    return this->Find(key);
  }

  /** The same, but begins nothing. */
  const Result* Find(const Key& key)
  {
    if (this->Work.IsBegun() && this->Work.HasReturned())
    {
      this->Work.End();
    }
    return this->IsOf(key) && !this->Work.IsBegun() && *this->Made ? &**this->Made : nullptr;
  }

  /** Whether the result that is made, or was made last, is of a key. */
  bool IsOf(const Key& key) const { return this->Of && *this->Of == key; }

  /** Cancels the work and forgets its result. */
  void Forget()
  {
    this->Work.End();
    this->Of.reset();
    this->Made.reset();
  }

  /** As Forget(), but keeps the work until it has returned, so that IsUnderWay() can tell. */
  void Abandon()
  {
    if (!this->IsUnderWay())
    {
      this->Forget();
      return;
    }
    this->Work.Cancel();
    this->Of.reset();
  }

  /**
   * Whether a result is being made, or work that was abandoned still ends. Not the work of a
   * process that this one was forked from: it never ends here.
   */
  bool IsUnderWay() const
  {
    return this->Work.IsBegun() && this->Work.IsOurs() && !this->Work.HasReturned();
  }
  /** Waits until no result is being made, or for some seconds; returns whether none is. */
  bool WaitFor(double seconds) const
  {
    return !this->Work.IsBegun() || this->Work.WaitFor(seconds);
  }
  double GetProgress() const { return this->Work.GetProgress(); }

private:
  std::optional<Key> Of;
  std::shared_ptr<std::optional<Result>> Made; // written by the task
  BackgroundWork Work;                         // last: it ends first
};

} // namespace VolumeHaptics

#endif
