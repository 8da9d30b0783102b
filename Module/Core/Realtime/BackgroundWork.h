// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs long work on a volume on a thread of its own, so that the hand does not wait for it.
 *
 * The owner (the GUI thread) begins the work, polls its progress, and takes its result whenever it
 * likes; neither thread waits for the other. The task works in pieces of some milliseconds and asks
 * between them whether it is cancelled. A KeyedWork also remembers which data its result belongs
 * to, and begins again if the data have changed:
 *
 *   KeyedWork<DataKey, std::string> hash;
 *   const std::string* known = hash.Poll({ array, array->GetMTime() }, // on each GUI tick
 *     [array](WorkMonitor& monitor) { return HashArray(array, dimensions, monitor); });
 *
 * The owner's thread releases the objects that the task holds, such as a reference to an array; the
 * worker never does, because another thread must not drop the last reference of a VTK object. If
 * work is cancelled while it runs, the owner's thread releases its objects at the next call of a
 * function of any work after the end of the task's piece, or when the owner's thread ends. So a
 * task must own all that it reads: it may outlive the object that began it. The task may read
 * values while the program writes them: the program then calls Modified() and gets a new result.
 * The memory of the values must stay at its address for as long as the array exists, as for the
 * servo: see vtkHapticDevice.
 *
 * The worker has a low priority, so that it delays neither the servo nor the picture. A forked
 * child has no worker; work that was under way at the fork never ends in the child.
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

/** Reports progress from a task to its owner, and cancellation from the owner to the task. */
class WorkMonitor
{
public:
  ///@{
  /** Returns whether the owner has cancelled the task. The task calls this. */
  bool IsCancelled() const noexcept { return this->Cancelled.load(std::memory_order_relaxed); }
  void SetProgress(double fraction) noexcept
  {
    this->Fraction.store(fraction, std::memory_order_relaxed);
  }
  /**
   * Reports the task's progress (0 to 1). The task calls this. Returns false if it is cancelled.
   */
  bool GoesOn(double fraction) noexcept
  {
    this->SetProgress(fraction);
    return !this->IsCancelled();
  }
  ///@}
  ///@{
  /** Cancel the task, and read its progress (0 to 1). The owner calls these. */
  void Cancel() noexcept { this->Cancelled.store(true, std::memory_order_relaxed); }
  double GetProgress() const noexcept { return this->Fraction.load(std::memory_order_relaxed); }
  ///@}

private:
  std::atomic<bool> Cancelled{ false };
  std::atomic<double> Fraction{ 0.0 };
};

/** A task on a thread of its own. Only the owner calls these functions. */
class BackgroundWork
{
public:
  using Task = std::function<void(WorkMonitor&)>;

  BackgroundWork() = default;
  /** Cancels the task without waiting for it. */
  ~BackgroundWork() { this->End(); }
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /**
   * Begins a task. A task that is under way is cancelled; the new task starts when the current
   * piece of the old one has ended. If the system provides no thread, the task runs to its end
   * within this call.
   */
  void Begin(Task task);
  /** Cancels the task without waiting for it. Releases its objects if it has returned. */
  void End() noexcept;

  /**
   * Cancels the task without waiting for it: HasReturned() becomes true at the end of its piece.
   */
  void Cancel() noexcept;

  /** Returns whether a task was begun, and End() was not called since. */
  bool IsBegun() const { return this->Current != nullptr; }
  /**
   * Returns whether this process began the task, rather than the process that it was forked from.
   */
  bool IsOurs() const { return this->Current && this->Current->IsOurs(); }
  /** Returns whether the task has returned; its results can be read then. */
  bool HasReturned() const;
  /**
   * Waits until the task has returned, at most this many seconds. Returns whether it has returned.
   */
  bool WaitFor(double seconds) const;
  /** Returns the progress of the task, 0 to 1; 0 without a task. */
  double GetProgress() const;

private:
  using Flag = std::atomic<bool>;
  struct Run
  {
    Task Work;
    WorkMonitor Monitor;
    const std::shared_ptr<Flag> HasReturned = std::make_shared<Flag>(false);
    /** Flag of the earlier run that has to end before this one; null if there is none. */
    std::shared_ptr<const Flag> Before;
    std::thread Thread;
    const std::int64_t Process = ServoClock::GetProcess();

    bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }
    bool IsOver() const { return this->HasReturned->load(std::memory_order_acquire); }
    void Do() noexcept;
  };
  class Leavings;

  std::unique_ptr<Run> Current;
  std::shared_ptr<const Flag> Last; ///< flag of the run that was ended last; null if there is none
  std::int64_t LastProcess = 0;     ///< process that began this last run
};

/**
 * Computes a result in the background from data that a key identifies, such as an array and its
 * modification time.
 */
template <typename Key, typename Result>
class KeyedWork
{
public:
  /** Computes a result. Returns nothing if the work is cancelled. */
  using Maker = std::function<std::optional<Result>(WorkMonitor&)>;

  /**
   * Returns the result for a key; null until it is known. If the key has changed, cancels the work
   * for the old key and begins new work with `make`. If the work fails for lack of memory, the
   * result stays null.
   */
  const Result* Poll(const Key& key, const Maker& make)
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

  /** Returns the result for a key like Poll(), but begins no work. */
  const Result* Find(const Key& key)
  {
    if (this->Work.IsBegun() && this->Work.HasReturned())
    {
      this->Work.End();
    }
    return this->IsOf(key) && !this->Work.IsBegun() && *this->Made ? &**this->Made : nullptr;
  }

  /** Returns whether the result that is under way or was computed last belongs to a key. */
  bool IsOf(const Key& key) const { return this->Of && *this->Of == key; }

  /** Cancels the work and discards its result. */
  void Forget()
  {
    this->Work.End();
    this->Of.reset();
    this->Made.reset();
  }

  /**
   * Cancels the work and discards its result like Forget(), but keeps the work until it has
   * returned, so that IsUnderWay() sees it.
   */
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
   * Returns whether a result is being computed, or abandoned work has not ended yet. Returns false
   * for work of the process that this one was forked from: such work never ends here.
   */
  bool IsUnderWay() const
  {
    return this->Work.IsBegun() && this->Work.IsOurs() && !this->Work.HasReturned();
  }
  /**
   * Waits until no result is being computed, at most this many seconds. Returns whether none is.
   */
  bool WaitFor(double seconds) const
  {
    return !this->Work.IsBegun() || this->Work.WaitFor(seconds);
  }
  double GetProgress() const { return this->Work.GetProgress(); }

private:
  std::optional<Key> Of;
  std::shared_ptr<std::optional<Result>> Made; // result, written by the task
  BackgroundWork Work;                         // the last member, so that it is destroyed first
};

} // namespace VolumeHaptics

#endif
