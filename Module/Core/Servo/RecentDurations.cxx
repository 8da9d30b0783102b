// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/RecentDurations.h"

#include <algorithm>

namespace VolumeHaptics
{

void RecentDurations::Reset() noexcept
{
  this->Count = 0;
  this->Upper.store(0, std::memory_order_relaxed);
  this->Typical.store(0, std::memory_order_relaxed);
}

void RecentDurations::Add(std::int64_t nanoseconds) noexcept
{
  this->Last[this->Count % Capacity] = nanoseconds;
  ++this->Count;
  if (this->Count % Stride == 0)
  {
    this->Compute();
  }
}

void RecentDurations::Compute() noexcept
{
  const auto all = static_cast<std::size_t>(std::min<std::uint64_t>(this->Count, Capacity));
  std::size_t count = 0;
  std::int64_t sum = 0;
  while (count < all && sum < Span)
  {
    this->Sorted[count] = this->Last[(this->Count - 1 - count) % Capacity];
    sum += this->Sorted[count];
    ++count;
  }
  const auto begin = this->Sorted.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  // Counted from 1, the 95th percentile is duration 95 * count / 100, rounded up.
  const auto upper = begin + static_cast<std::ptrdiff_t>((95 * count + 99) / 100 - 1);
  std::nth_element(begin, upper, end);
  this->Upper.store(*upper, std::memory_order_relaxed);
  const auto middle = begin + static_cast<std::ptrdiff_t>((count - 1) / 2);
  std::nth_element(begin, middle, end);
  this->Typical.store(*middle, std::memory_order_relaxed);
}

} // namespace VolumeHaptics
