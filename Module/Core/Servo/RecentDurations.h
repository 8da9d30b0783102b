// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes an upper and a typical value of recent durations. One thread adds durations, and any
 * thread may read the values without waiting.
 *
 * The values are the 95th percentile, which a few late wake-ups of a busy machine do not change,
 * and the median. They are computed from the last Capacity durations, or from fewer if these
 * already sum up to one second, and are updated with every Stride-th duration.
 */
#ifndef RecentDurations_h
#define RecentDurations_h

#include <array>
#include <atomic>
#include <cstdint>

namespace VolumeHaptics
{

class RecentDurations
{
public:
  static constexpr std::size_t Capacity = 256;
  static constexpr std::size_t Stride = 16;
  static constexpr std::int64_t Span = 1000000000; ///< sum of the durations (ns) that count

  ///@{
  /**
   * Adds a duration (ns). Only the writer may call this. The first values are available after
   * Stride durations.
   */
  void Add(std::int64_t nanoseconds) noexcept;
  void Reset() noexcept;
  ///@}

  ///@{
  /** Return the values (ns), or 0 until they are known. */
  std::int64_t GetUpper() const noexcept { return this->Upper.load(std::memory_order_relaxed); }
  std::int64_t GetTypical() const noexcept { return this->Typical.load(std::memory_order_relaxed); }
  ///@}

private:
  void Compute() noexcept;

  std::array<std::int64_t, Capacity> Last{}; ///< a ring buffer
  std::array<std::int64_t, Capacity> Sorted{};
  std::uint64_t Count = 0; ///< number of all durations so far
  std::atomic<std::int64_t> Upper{ 0 };
  std::atomic<std::int64_t> Typical{ 0 };
};

} // namespace VolumeHaptics

#endif
