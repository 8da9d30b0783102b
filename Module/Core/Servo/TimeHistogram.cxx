// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/TimeHistogram.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

int TimeHistogram::Bucket(std::int64_t nanoseconds) noexcept
{
  // Below PerOctave ns, each bucket is one nanosecond wide. Above, the leading bits of the duration
  // select the bucket.
  auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0));
  int octave = 0;
  while (value >= 2 * PerOctave)
  {
    value >>= 1;
    ++octave;
  }
  const int bucket = octave * PerOctave + static_cast<int>(value);
  return std::min(bucket, PerOctave * Octaves - 1);
}

double TimeHistogram::UpperEdge(int bucket) noexcept
{
  if (bucket < 2 * PerOctave)
  {
    return bucket + 1;
  }
  const int octave = bucket / PerOctave - 1;
  const int value = bucket - octave * PerOctave;
  return std::ldexp(value + 1.0, octave);
}

std::uint64_t TimeHistogram::GetTotal() const noexcept
{
  std::uint64_t total = 0;
  for (const auto& count : this->Count)
  {
    total += count.load(std::memory_order_relaxed);
  }
  return total;
}

double TimeHistogram::GetPercentile(double fraction) const noexcept
{
  const std::uint64_t total = this->GetTotal();
  if (total == 0)
  {
    return 0.0;
  }
  const double wanted = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(total);
  std::uint64_t seen = 0;
  int bucket = 0;
  for (; bucket < PerOctave * Octaves - 1; ++bucket)
  {
    seen += this->Count[bucket].load(std::memory_order_relaxed);
    if (static_cast<double>(seen) >= wanted && seen > 0)
    {
      break;
    }
  }
  return UpperEdge(bucket);
}

void TimeHistogram::Reset() noexcept
{
  for (auto& count : this->Count)
  {
    count.store(0, std::memory_order_relaxed);
  }
}

} // namespace VolumeHaptics
