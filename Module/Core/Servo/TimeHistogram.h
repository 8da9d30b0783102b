// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Durations, counted in fixed buckets: written by one thread, read by any, without waiting.
 *
 * There are eight buckets per octave, from 1 ns to more than an hour: a percentile is exact to 1/8.
 */
#ifndef TimeHistogram_h
#define TimeHistogram_h

#include <array>
#include <atomic>
#include <cstdint>

namespace VolumeHaptics
{

class TimeHistogram
{
public:
  /** Counts a duration. Called by the one writer. */
  void Add(std::int64_t nanoseconds) noexcept
  {
    std::atomic<std::uint64_t>& bucket = this->Count[Bucket(nanoseconds)];
    bucket.store(bucket.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  /**
   * Returns the duration in ns below which a fraction (0 to 1) of the durations lie: the upper edge
   * of that duration's bucket. 0 if nothing was counted.
   */
  double GetPercentile(double fraction) const noexcept;

  std::uint64_t GetTotal() const noexcept;

  /** Called by the writer as well. */
  void Reset() noexcept;

private:
  static constexpr int Shift = 3;
  static constexpr int PerOctave = 1 << Shift;
  static constexpr int Octaves = 42;

  static int Bucket(std::int64_t nanoseconds) noexcept;
  static double UpperEdge(int bucket) noexcept;

  std::array<std::atomic<std::uint64_t>, PerOctave * Octaves> Count{};
};

} // namespace VolumeHaptics

#endif
