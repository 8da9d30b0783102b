// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A hand at rest, which watches the servo's loop from its own thread: how late the ticks come, and
 * why.
 */
#ifndef WatchedHand_h
#define WatchedHand_h

#include <Devices/Common/DeviceKind.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace benchmarks
{

/** Of the ticks of a loop. */
struct LoopCounts
{
  /** Why the loop left out ticks between two of its ticks. */
  enum Cause
  {
    Computed, ///< its thread had a processor for longer than a period
    Waited,   ///< its thread waited for something other than its next tick: a lock, or the disk
    Machine,  ///< neither: its thread was ready to run, or to be woken, and did not run
    Causes
  };
  std::uint64_t Ticks = 0;
  std::uint64_t LeftOut[Causes] = {};
  std::int64_t LongestWork = 0; ///< ns of its processor between two ticks

  LoopCounts& operator+=(const LoopCounts& other);
};

/** For a loop of a period of 1 ms. */
class LoopWatch
{
public:
  /** For a loop that does not run. */
  void Reset() { this->IsResetWanted = true; }
  /** From any thread. */
  LoopCounts GetCounts() const;

  /** On the loop's thread, once a tick. */
  void RecordTick() noexcept;

private:
  /** What the loop's thread has used so far. */
  struct Usage
  {
    std::int64_t Work = 0;  ///< ns of a processor, without what others took of it
    std::int64_t Waits = 0; ///< each tick, and each wait for something else
    std::int64_t Reads = 0; ///< pages from the disk
  };
  static Usage ReadUsage() noexcept;

  std::atomic<bool> IsResetWanted{ true };
  std::atomic<std::uint64_t> Ticks{ 0 };
  std::atomic<std::uint64_t> LeftOut[LoopCounts::Causes] = {};
  std::atomic<std::int64_t> LongestWork{ 0 };
  Usage Last;
  std::int64_t Planned = 0; ///< ns, of the last tick
};

/** The kind of device "watched": a hand that rests at a place (m). The watch has to outlive it. */
VolumeHaptics::DeviceKind MakeWatchedKind(const VolumeHaptics::Vector3& tip, LoopWatch* watch);

} // namespace benchmarks

#endif
