// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/CarvedSamples.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Copies what is left of samples along x; the share of the first one is the lowest byte. */
template <typename T>
inline void CopyRun(const T* from, std::int64_t stride, std::uint64_t shares, int last,
  const CarvedView& carved, double* to)
{
  const CarvedView view = carved;
  for (int i = 0; i <= last; ++i, shares >>= 8)
  {
    to[i] = view.Left(static_cast<double>(from[i * stride]), static_cast<std::uint8_t>(shares));
  }
}

/** Copies what is left of the samples of a box, all of which are in the bricks of a row along x. */
template <typename T>
void CopyLines(const VolumeView& whole, const CarvedView& carved, const CarvedBox& box,
  const std::int64_t* low, const std::int64_t* high, const std::uint32_t* bricks, double* to)
{
  constexpr std::int64_t mask = CarvedBricks::Side - 1;
  const std::int64_t* const stride = whole.Stride;
  const std::int64_t firstBrick = box.Low[0] >> CarvedBricks::Shift;
  const std::int64_t lastBrick = box.High[0] >> CarvedBricks::Shift;
  for (std::int64_t k = low[1]; k <= high[1]; ++k)
  {
    for (std::int64_t j = low[0]; j <= high[0]; ++j)
    {
      const T* const from = static_cast<const T*>(whole.Data) + k * stride[2] + j * stride[1];
      double* const line =
        to + ((k - box.Low[2]) * box.Size(1) + (j - box.Low[1])) * box.Size(0) - box.Low[0];
      const auto row = static_cast<int>((j & mask) + CarvedBricks::Side * (k & mask));
      for (std::int64_t brick = firstBrick; brick <= lastBrick; ++brick)
      {
        const std::uint32_t number = bricks[brick - firstBrick];
        const std::uint64_t shares = number == CarvedBricks::None
          ? CarvedBricks::WholeRow
          : carved.Bricks->GetRow(number, row);
        const std::int64_t begin = std::max(box.Low[0], brick * CarvedBricks::Side);
        const std::int64_t end =
          std::min(box.High[0], brick * CarvedBricks::Side + CarvedBricks::Side - 1);
        CopyRun(from + begin * stride[0], stride[0], shares >> (8 * (begin & mask)),
          static_cast<int>(end - begin), carved, line + begin);
      }
    }
  }
}

template <typename T>
void CopyBox(const VolumeView& whole, const CarvedView& carved, const CarvedBox& box, double* to)
{
  constexpr std::int64_t side = CarvedBricks::Side;
  const auto brickOf = [](std::int64_t index) { return index >> CarvedBricks::Shift; };
  std::uint32_t bricks[CarvedBox::MostSide / side + 2];
  for (std::int64_t z = brickOf(box.Low[2]); z <= brickOf(box.High[2]); ++z)
  {
    for (std::int64_t y = brickOf(box.Low[1]); y <= brickOf(box.High[1]); ++y)
    {
      const std::int64_t first = brickOf(box.Low[0]);
      for (std::int64_t x = first; x <= brickOf(box.High[0]); ++x)
      {
        bricks[x - first] = carved.Bricks->Find(CarvedBricks::KeyOf({ x, y, z }));
      }
      const std::int64_t low[2] = { std::max(box.Low[1], y * side),
        std::max(box.Low[2], z * side) };
      const std::int64_t high[2] = { std::min(box.High[1], y * side + side - 1),
        std::min(box.High[2], z * side + side - 1) };
      CopyLines<T>(whole, carved, box, low, high, bricks, to);
    }
  }
}

} // namespace

CarvedBox FindBox(const VolumeView& view, const double* position, int before, int behind) noexcept
{
  CarvedBox box;
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t first = view.First[a];
    const std::int64_t last = view.Last(a);
    const auto least = static_cast<double>(first);
    const auto most = static_cast<double>(last);
    const double inside = position[a] > least ? std::min(position[a], most) : least;
    // At the last sample, a kernel may take the cell before it.
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
  if (!carved.Bricks->HasBricks(box.Low, box.High))
  {
    return false;
  }
  WithSampleType(
    whole.Type, [&](auto sample) { CopyBox<decltype(sample)>(whole, carved, box, to); });
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
  // As a number, since there is no memory at it.
  copy.Data = reinterpret_cast<const void*>(
    reinterpret_cast<std::uintptr_t>(to) - static_cast<std::uintptr_t>(elements) * sizeof(double));
  return true;
}

} // namespace VolumeHaptics
