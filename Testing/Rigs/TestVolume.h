// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A volume of any scalar type and memory layout, in a memory block of exactly the needed size. */
#ifndef TestVolume_h
#define TestVolume_h

#include "AllScalarTypes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <random>

namespace coretest
{
class TestVolume
{
public:
  using Size = std::array<std::int64_t, 3>;

  /// Makes a volume whose samples are `step` elements apart, in the memory at `place`, or on the
  /// heap if `place` is null.
  TestVolume(ScalarType type, const Size& n, std::int64_t step = 1, std::byte* place = nullptr)
  {
    this->View.Type = type;
    std::copy(n.begin(), n.end(), this->View.Dimensions);
    this->View.Stride[0] = step;
    this->View.Stride[1] = step * n[0];
    this->View.Stride[2] = step * n[0] * n[1];
    if (!place)
    {
      // Allocate with new std::byte[] instead of a vector, so that the block ends exactly at the
      // last sample.
      this->Memory.reset(new std::byte[Bytes(type, n, step)]());
      place = this->Memory.get();
    }
    this->Data = place;
    this->View.Data = place;
  }

  /// Returns the number of bytes from the first sample to the end of the last sample. Later bytes
  /// must not be read.
  static std::size_t Bytes(ScalarType type, const Size& n, std::int64_t step)
  {
    const std::size_t elements = static_cast<std::size_t>((n[0] * n[1] * n[2] - 1) * step + 1);
    return elements * WithSampleType(type, [](auto t) { return sizeof(t); });
  }

  /// Fills the volume with random values of the type. Floating-point values are between -1e6 and
  /// 1e6.
  void FillRandom(unsigned seed)
  {
    std::mt19937_64 engine(seed);
    WithSampleType(this->View.Type,
      [&](auto t)
      {
        using T = decltype(t);
        this->Fill<T>(
          [&](std::int64_t, std::int64_t, std::int64_t)
          {
            const auto bits = engine();
            return std::is_floating_point_v<T>
              ? static_cast<T>(2e6 * (static_cast<double>(bits >> 11) * 0x1p-53 - 0.5))
              : static_cast<T>(bits);
          });
      });
  }

  template <typename T, typename F>
  void Fill(F&& f)
  {
    const std::int64_t* const n = this->View.Dimensions;
    const std::int64_t* const step = this->View.Stride;
    for (std::int64_t at = 0; at < n[0] * n[1] * n[2]; ++at)
    {
      const std::int64_t i = at % n[0];
      const std::int64_t j = at / n[0] % n[1];
      const std::int64_t k = at / (n[0] * n[1]);
      const T value = static_cast<T>(f(i, j, k));
      const std::int64_t element = i * step[0] + j * step[1] + k * step[2];
      std::memcpy(this->Data + element * static_cast<std::int64_t>(sizeof(T)), &value, sizeof(T));
    }
  }

  /// Returns the sample at an index, or the nearest sample of the border if the index is outside.
  double operator()(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const std::int64_t at[3] = { i, j, k };
    std::int64_t offset = 0;
    for (int a = 0; a < 3; ++a)
    {
      const std::int64_t last = this->View.Dimensions[a] - 1;
      offset += this->View.Stride[a] * std::max<std::int64_t>(0, std::min(at[a], last));
    }
    return WithSampleType(this->View.Type,
      [&](auto t)
      {
        std::memcpy(&t, this->Data + offset * static_cast<std::int64_t>(sizeof(t)), sizeof(t));
        return static_cast<double>(t);
      });
  }

  VolumeView View;

private:
  std::unique_ptr<std::byte[]> Memory;
  std::byte* Data = nullptr;
};
} // namespace coretest

#endif
