// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Observes the servo's loop with a resting hand, from the loop's own thread: how late ticks are,
 * and why.
 */
#ifndef WatchedHand_h
#define WatchedHand_h

#include <Devices/Common/DeviceKind.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace benchmarks
{

/** Counts of a loop's ticks. */
struct LoopCounts
{
  /** Reasons why the loop skipped ticks between two of its ticks. */
  enum Cause
  {
    Computed, ///< the thread computed for longer than a period
    Waited,   ///< the thread waited for something other than its next tick, such as a lock or the
              ///< disk
    Machine,  ///< the thread was ready to run, but the machine did not run it
    Causes
  };
  std::uint64_t Ticks = 0;
  std::uint64_t LeftOut[Causes] = {};
  std::int64_t LongestWork = 0; ///< ns, processor time between two ticks

  LoopCounts& operator+=(const LoopCounts& other);
};

/** Observes a loop with a period of 1 ms. */
class LoopWatch
{
public:
  /** Makes the next tick reset the counts to zero. Any thread may call it. */
  void Reset() { this->IsResetWanted = true; }
  /** Returns the counts. Any thread may call it. */
  LoopCounts GetCounts() const;

  /** Records a tick. Call it once per tick on the loop's thread. */
  void RecordTick() noexcept;

private:
  /** Resources that the loop's thread has used since its start. */
  struct Usage
  {
    std::int64_t Work = 0;  ///< ns, processor time of this thread
    std::int64_t Waits = 0; ///< number of waits: one per tick, plus those for other reasons
    std::int64_t Reads = 0; ///< number of pages read from the disk
  };
  static Usage ReadUsage() noexcept;

  std::atomic<bool> IsResetWanted{ true };
  std::atomic<std::uint64_t> Ticks{ 0 };
  std::atomic<std::uint64_t> LeftOut[LoopCounts::Causes] = {};
  std::atomic<std::int64_t> LongestWork{ 0 };
  Usage Last;
  std::int64_t Planned = 0; ///< ns, planned time of the last tick
};

/**
 * Returns the device kind "watched": a hand that rests at a position (m). The watch must outlive
 * the device.
 */
VolumeHaptics::DeviceKind MakeWatchedKind(const VolumeHaptics::Vector3& tip, LoopWatch* watch);

} // namespace benchmarks

#endif
