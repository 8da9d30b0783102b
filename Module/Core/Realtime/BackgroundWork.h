// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs long work on a volume in a background thread, so that the hand does not wait for it.
 *
 * The owner (the GUI thread) begins the work, polls its progress, and fetches its result at any
 * later time; neither thread waits for the other. The task works in pieces of some milliseconds,
 * and checks between them whether it is cancelled. A KeyedWork also remembers to which data its
 * result belongs, and begins again if the data have changed:
 *
 *   KeyedWork<DataKey, std::string> hash;
 *   const std::string* known = hash.Poll({ array, array->GetMTime() }, // on each GUI tick
 *     [array](WorkMonitor& monitor) { return HashArray(array, dimensions, monitor); });
 *
 * The owner's thread releases the objects that the task owns, such as a reference to an array. The
 * worker never does, because another thread must not drop the last reference of a VTK object. If
 * running work is cancelled, its objects are released later: at the next call of a function of any
 * work in the owner's thread after the task's piece has ended, or when the owner's thread ends. A
 * task must therefore own all that it reads, because it may outlive the object that began it. The
 * task may read values while the program changes them; the program then calls Modified() and gets a
 * new result. The values must stay at their address for as long as the array exists, as for the
 * servo: see vtkHapticDevice.
 *
 * The worker has a low priority, so that it delays neither the servo nor the rendering. A forked
 * child has no worker: work that was running at the fork never ends in the child.
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
   * Reports the task's progress (0 to 1). Returns false if the task is cancelled. The task calls
   * this.
   */
  bool GoesOn(double fraction) noexcept
  {
    this->SetProgress(fraction);
    return !this->IsCancelled();
  }
  ///@}
  ///@{
  /** Cancel the task, and return its progress (0 to 1). The owner calls these functions. */
  void Cancel() noexcept { this->Cancelled.store(true, std::memory_order_relaxed); }
  double GetProgress() const noexcept { return this->Fraction.load(std::memory_order_relaxed); }
  ///@}

private:
  std::atomic<bool> Cancelled{ false };
  std::atomic<double> Fraction{ 0.0 };
};

/** A task in a separate thread. Only the owner may call these functions. */
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
   * Begins a task, and cancels one that is running. The new task starts after the current piece of
   * the old one. If the system provides no thread, the task runs to its end within this call.
   */
  void Begin(Task task);
  /** Cancels the task without waiting for it. If it has returned, releases its objects. */
  void End() noexcept;

  /**
   * Cancels the task without waiting for it. HasReturned() returns true from the end of the current
   * piece on.
   */
  void Cancel() noexcept;

  /** Returns whether a task was begun and not ended by End(). */
  bool IsBegun() const { return this->Current != nullptr; }
  /**
   * Returns whether this process began the task. If not, its parent did, before the fork.
   */
  bool IsOurs() const { return this->Current && this->Current->IsOurs(); }
  /** Returns whether the task has returned. Its results may then be read. */
  bool HasReturned() const;
  /**
   * Waits at most `seconds` until the task has returned. Returns whether it has.
   */
  bool WaitFor(double seconds) const;
  /** Returns the progress of the task (0 to 1), or 0 without a task. */
  double GetProgress() const;

private:
  using Flag = std::atomic<bool>;
  struct Run
  {
    Task Work;
    WorkMonitor Monitor;
    const std::shared_ptr<Flag> HasReturned = std::make_shared<Flag>(false);
    /** Flag of the earlier run that has to end before this one, or null. */
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
  /** Computes a result. Returns none if the work is cancelled. */
  using Maker = std::function<std::optional<Result>(WorkMonitor&)>;

  /**
   * Returns the result for a key, or null while it is not known. If the key has changed, cancels
   * the work for the old key and begins new work with `make`. If the work runs out of memory, the
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

  /** Like Poll(), but begins no work. */
  const Result* Find(const Key& key)
  {
    if (this->Work.IsBegun() && this->Work.HasReturned())
    {
      this->Work.End();
    }
    return this->IsOf(key) && !this->Work.IsBegun() && *this->Made ? &**this->Made : nullptr;
  }

  /** Returns whether the running work or the last result belongs to a key. */
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
   * returned, so that IsUnderWay() includes it.
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
   * for work of the parent process, which never ends in a forked child.
   */
  bool IsUnderWay() const
  {
    return this->Work.IsBegun() && this->Work.IsOurs() && !this->Work.HasReturned();
  }
  /**
   * Waits at most `seconds` until no result is being computed. Returns whether none is.
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
