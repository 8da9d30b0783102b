// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A histogram of durations with fixed buckets. One thread writes to it, and any thread may read it
 * without waiting.
 *
 * There are eight buckets per octave, from 1 ns to more than an hour, so percentiles have a
 * precision of 1/8.
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
  /** Counts a duration. Only the writer may call this. */
  void Add(std::int64_t nanoseconds) noexcept
  {
    std::atomic<std::uint64_t>& bucket = this->Count[Bucket(nanoseconds)];
    bucket.store(bucket.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  /**
   * Returns the duration (ns) below which a fraction (0 to 1) of all durations lies, rounded up to
   * the edge of a bucket. Returns 0 if nothing was counted.
   */
  double GetPercentile(double fraction) const noexcept;

  std::uint64_t GetTotal() const noexcept;

  /** Clears all buckets. Only the writer may call this. */
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
