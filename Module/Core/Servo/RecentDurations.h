// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * An upper and a typical figure of recent durations: written by one thread, read by any, without
 * waiting.
 *
 * They are the 95th percentile, which a few late wake-ups of a busy machine do not move, and the
 * median of the last Capacity durations, limited to those that sum to one second. Both are computed
 * with every Stride-th duration.
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
  static constexpr std::int64_t Span = 1000000000; ///< ns; the figures use the latest durations
                                                   ///< until their sum reaches this, or Capacity of
                                                   ///< them

  ///@{
  /**
   * Adds a duration (ns). Called by the one writer. The first figures come with the Stride-th
   * duration.
   */
  void Add(std::int64_t nanoseconds) noexcept;
  void Reset() noexcept;
  ///@}

  ///@{
  /** Return the figures in ns; 0 until the first figures are known. */
  std::int64_t GetUpper() const noexcept { return this->Upper.load(std::memory_order_relaxed); }
  std::int64_t GetTypical() const noexcept { return this->Typical.load(std::memory_order_relaxed); }
  ///@}

private:
  void Compute() noexcept;

  std::array<std::int64_t, Capacity> Last{}; ///< a ring
  std::array<std::int64_t, Capacity> Sorted{};
  std::uint64_t Count = 0; ///< durations so far
  std::atomic<std::int64_t> Upper{ 0 };
  std::atomic<std::int64_t> Typical{ 0 };
};

} // namespace VolumeHaptics

#endif
