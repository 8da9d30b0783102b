// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/CarvedSamples.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Copies samples along x, with the removal applied. The lowest byte of `fractions` is the remaining
 * fraction of the first sample.
 */
template <typename T>
inline void CopyRun(const T* from, std::int64_t stride, std::uint64_t fractions, int last,
  const CarvedView& carved, double* to)
{
  const CarvedView view = carved;
  for (int i = 0; i <= last; ++i, fractions >>= 8)
  {
    to[i] = view.Left(static_cast<double>(from[i * stride]), static_cast<std::uint8_t>(fractions));
  }
}

/** Numbers of the bricks that a box touches, x fastest. */
struct BoxBricks
{
  static constexpr std::int64_t MostAlong = CarvedBox::MostSide / CarvedBricks::Side + 1;

  std::uint32_t Numbers[MostAlong * MostAlong * MostAlong];
  std::int64_t First[3];
  std::int64_t Count[3];

  /** Looks up the bricks that the box touches. Returns false if none of them exists. */
  bool Find(const CarvedBricks& bricks, const CarvedBox& box) noexcept
  {
    for (int a = 0; a < 3; ++a)
    {
      this->First[a] = box.Low[a] >> CarvedBricks::Shift;
      this->Count[a] = (box.High[a] >> CarvedBricks::Shift) - this->First[a] + 1;
    }
    bool isAny = false;
    std::uint32_t* to = this->Numbers;
    for (std::int64_t z = this->First[2]; z < this->First[2] + this->Count[2]; ++z)
    {
      for (std::int64_t y = this->First[1]; y < this->First[1] + this->Count[1]; ++y)
      {
        for (std::int64_t x = this->First[0]; x < this->First[0] + this->Count[0]; ++x)
        {
          *to = bricks.Find(CarvedBricks::KeyOf({ x, y, z }));
          isAny = isAny || *to != CarvedBricks::None;
          ++to;
        }
      }
    }
    return isAny;
  }
};

/** Copies the samples of a box, with the removal applied. */
template <typename T>
void CopyBox(const VolumeView& whole, const CarvedView& carved, const CarvedBox& box,
  const BoxBricks& bricks, double* to)
{
  constexpr std::int64_t mask = CarvedBricks::Side - 1;
  const std::int64_t stride = whole.Stride[0];
  for (std::int64_t k = box.Low[2]; k <= box.High[2]; ++k)
  {
    const std::int64_t z = (k >> CarvedBricks::Shift) - bricks.First[2];
    for (std::int64_t j = box.Low[1]; j <= box.High[1]; ++j)
    {
      const std::int64_t y = (j >> CarvedBricks::Shift) - bricks.First[1];
      const std::uint32_t* number = bricks.Numbers + (z * bricks.Count[1] + y) * bricks.Count[0];
      const auto row = static_cast<int>((j & mask) + CarvedBricks::Side * (k & mask));
      const T* const from =
        static_cast<const T*>(whole.Data) + k * whole.Stride[2] + j * whole.Stride[1];
      for (std::int64_t i = box.Low[0]; i <= box.High[0]; ++number)
      {
        const std::uint64_t fractions = *number == CarvedBricks::None
          ? CarvedBricks::WholeRow
          : carved.Bricks->GetRow(*number, row);
        const std::int64_t last = std::min(box.High[0], i | mask);
        CopyRun(from + i * stride, stride, fractions >> (8 * (i & mask)),
          static_cast<int>(last - i), carved, to);
        to += last - i + 1;
        i = last + 1;
      }
    }
  }
}

} // namespace

CarvedBox ComputeBox(
  const VolumeView& view, const double* position, int before, int behind) noexcept
{
  CarvedBox box;
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t first = view.First[a];
    const std::int64_t last = view.Last(a);
    const auto least = static_cast<double>(first);
    const auto most = static_cast<double>(last);
    const double inside = position[a] > least ? std::min(position[a], most) : least;
    // At the last sample, a kernel may use the previous cell.
    const std::int64_t cell =
      std::max(std::min(static_cast<std::int64_t>(inside), last - 1), first);
    box.Low[a] = std::max(cell - before, first);
    box.High[a] = std::min(cell + 1 + behind, last);
  }
  return box;
}

bool CopyCarved(const VolumeView& whole, const CarvedView& carved, const CarvedBox& box, double* to,
  VolumeView& copy) noexcept
{
  BoxBricks bricks;
  if (!bricks.Find(*carved.Bricks, box))
  {
    return false;
  }
  WithSampleType(
    whole.Type, [&](auto sample) { CopyBox<decltype(sample)>(whole, carved, box, bricks, to); });
  copy = whole;
  copy.Type = ScalarType::Float64;
  copy.Stride[0] = 1;
  copy.Stride[1] = box.Size(0);
  copy.Stride[2] = box.Size(0) * box.Size(1);
  std::int64_t elements = 0;
  for (int a = 0; a < 3; ++a)
  {
    elements += box.Low[a] * copy.Stride[a];
  }
  // Compute the address as an integer, because it may be outside the buffer.
  copy.Data = reinterpret_cast<const void*>(
    reinterpret_cast<std::uintptr_t>(to) - static_cast<std::uintptr_t>(elements) * sizeof(double));
  return true;
}

} // namespace VolumeHaptics
