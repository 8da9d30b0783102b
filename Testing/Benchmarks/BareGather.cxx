// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BareGather.h"

namespace benchmarks
{
namespace
{

template <int N>
std::int32_t Sum(const std::int16_t* corner, std::int64_t line, std::int64_t plane)
{
  // Sum each column in 16 bits, so that reading takes most of the time.
  std::uint16_t sums[N] = {};
  for (int k = 0; k < N; ++k)
  {
    for (int j = 0; j < N; ++j)
    {
      const std::int16_t* const row = corner + k * plane + j * line;
      for (int i = 0; i < N; ++i)
      {
        sums[i] = static_cast<std::uint16_t>(sums[i] + static_cast<std::uint16_t>(row[i]));
      }
    }
  }
  std::int32_t sum = 0;
  for (int i = 0; i < N; ++i)
  {
    sum += sums[i];
  }
  return sum;
}

} // namespace

Gather SelectGather(int taps)
{
  return taps == 4 ? Sum<4> : (taps == 6 ? Sum<6> : Sum<8>);
}

} // namespace benchmarks
