// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/TissueImage.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>

namespace VolumeHaptics
{
namespace
{

constexpr std::int64_t SideOfBrick = CarvedBricks::Side;

/** The part of a brick that lies in a box, as indices in the volume, both ends included. */
struct BrickPart
{
  std::int64_t Low[3];
  std::int64_t High[3];

  BrickPart(const BrickPlace& place, const TissueBox& box) noexcept
  {
    const std::int64_t places[3] = { place.X, place.Y, place.Z };
    for (int a = 0; a < 3; ++a)
    {
      const std::int64_t first = places[a] * SideOfBrick;
      this->Low[a] = std::max(first, box.First[a]);
      this->High[a] = std::min(first + SideOfBrick, box.First[a] + box.Size[a]) - 1;
    }
  }
  /**
   * Calls f(row, begin, place) for each row of the part: `begin` is the row's first sample in the
   * brick, and `place` the position of this sample in the image.
   */
  template <typename F>
  void ForEachRow(const TissueBox& box, F&& f) const
  {
    for (std::int64_t k = this->Low[2]; k <= this->High[2]; ++k)
    {
      for (std::int64_t j = this->Low[1]; j <= this->High[1]; ++j)
      {
        const auto row = static_cast<int>(j % SideOfBrick + SideOfBrick * (k % SideOfBrick));
        const std::int64_t line = (k - box.First[2]) * box.Size[1] + (j - box.First[1]);
        f(row, static_cast<int>(this->Low[0] % SideOfBrick),
          line * box.Size[0] + this->Low[0] - box.First[0]);
      }
    }
  }
  int GetLength() const noexcept { return static_cast<int>(this->High[0] - this->Low[0] + 1); }
};

/** Calls f(place) for each brick that a box touches. */
template <typename F>
void ForEachPlace(const TissueBox& box, F&& f)
{
  const auto first = [&box](int a) { return box.First[a] / SideOfBrick; };
  const auto last = [&box](int a) { return (box.First[a] + box.Size[a] - 1) / SideOfBrick; };
  for (std::int64_t z = first(2); z <= last(2); ++z)
  {
    for (std::int64_t y = first(1); y <= last(1); ++y)
    {
      for (std::int64_t x = first(0); x <= last(0); ++x)
      {
        f(BrickPlace{ x, y, z });
      }
    }
  }
}

bool IsUsable(const TissueBox& box) noexcept
{
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t end = CarvedBricks::PlaceLimit * SideOfBrick;
    if (box.First[a] < 0 || box.Size[a] <= 0 || box.First[a] > end - box.Size[a])
    {
      return false;
    }
  }
  return true;
}

/** Returns whether all tissue of a brick remains in the image. */
bool IsWhole(const BrickPart& part, const TissueBox& box, const std::uint8_t* from) noexcept
{
  bool isWhole = true;
  part.ForEachRow(box,
    [&](int, int, std::int64_t place)
    {
      isWhole = isWhole &&
        std::all_of(from + place, from + place + part.GetLength(),
          [](std::uint8_t fraction) { return fraction == CarvedBricks::Whole; });
    });
  return isWhole;
}

} // namespace

void WriteBrick(
  const CarvedBricks& bricks, std::uint32_t brick, const TissueBox& box, std::uint8_t* to) noexcept
{
  const BrickPart part(CarvedBricks::PlaceOf(bricks.GetKey(brick)), box);
  const int length = part.GetLength();
  part.ForEachRow(box,
    [&](int row, int begin, std::int64_t place)
    {
      const std::uint64_t fractions = bricks.GetRow(brick, row);
      for (int i = 0; i < length; ++i)
      {
        to[place + i] = static_cast<std::uint8_t>(fractions >> (8 * (begin + i)));
      }
    });
}

void WriteTissue(const CarvedBricks& bricks, const TissueBox& box, std::uint8_t* to) noexcept
{
  if (!IsUsable(box))
  {
    return;
  }
  std::memset(
    to, CarvedBricks::Whole, static_cast<std::size_t>(box.Size[0] * box.Size[1] * box.Size[2]));
  const std::uint32_t count = bricks.GetCount();
  for (std::uint32_t brick = 0; brick < count; ++brick)
  {
    WriteBrick(bricks, brick, box, to);
  }
}

bool ReadTissue(CarvedBricks& bricks, const TissueBox& box, const std::uint8_t* from) noexcept
{
  if (!IsUsable(box))
  {
    return false;
  }
  std::uint64_t needed = bricks.GetCount();
  ForEachPlace(box,
    [&](const BrickPlace& place)
    {
      const bool isThere = bricks.Find(CarvedBricks::KeyOf(place)) != CarvedBricks::None;
      needed += !isThere && !IsWhole(BrickPart(place, box), box, from) ? 1 : 0;
    });
  if (needed > bricks.GetMost())
  {
    return false;
  }
  const std::uint32_t before = bricks.GetCount();
  for (std::uint32_t brick = 0; brick < before; ++brick)
  {
    for (int row = 0; row < CarvedBricks::Rows; ++row)
    {
      bricks.SetRow(brick, row, CarvedBricks::WholeRow);
    }
    bricks.MarkChanged(brick);
  }
  ForEachPlace(box,
    [&](const BrickPlace& place)
    {
      const BrickPart part(place, box);
      if (IsWhole(part, box, from))
      {
        return;
      }
      const std::uint32_t brick = bricks.FindOrAdd(CarvedBricks::KeyOf(place));
      const int length = part.GetLength();
      part.ForEachRow(box,
        [&](int row, int begin, std::int64_t at)
        {
          std::uint64_t fractions = CarvedBricks::WholeRow;
          for (int i = 0; i < length; ++i)
          {
            const int shift = 8 * (begin + i);
            fractions &= ~(std::uint64_t{ 255 } << shift);
            fractions |= std::uint64_t{ from[at + i] } << shift;
          }
          bricks.SetRow(brick, row, fractions);
        });
      bricks.MarkChanged(brick);
    });
  return true;
}

std::vector<BrickTissue> MoveTissue(const std::vector<BrickTissue>& bricks, const TissueBox& box)
{
  std::map<std::uint64_t, BrickTissue> moved; // sorted by key, so that the order is always the same
  for (const BrickTissue& brick : bricks)
  {
    const BrickPlace place = CarvedBricks::PlaceOf(brick.Key);
    const std::int64_t first[3] = { place.X * SideOfBrick - box.First[0],
      place.Y * SideOfBrick - box.First[1], place.Z * SideOfBrick - box.First[2] };
    for (std::int64_t sample = 0; sample < SideOfBrick * CarvedBricks::Rows; ++sample)
    {
      const std::int64_t i = sample % SideOfBrick;
      const std::int64_t row = sample / SideOfBrick;
      const std::uint64_t fraction = brick.Rows[static_cast<std::size_t>(row)] >> (8 * i) & 255;
      const std::int64_t x[3] = { first[0] + i, first[1] + row % SideOfBrick,
        first[2] + row / SideOfBrick };
      const bool isInside = x[0] >= 0 && x[1] >= 0 && x[2] >= 0 && x[0] < box.Size[0] &&
        x[1] < box.Size[1] && x[2] < box.Size[2];
      if (fraction == CarvedBricks::Whole || !isInside)
      {
        continue;
      }
      const std::uint64_t key =
        CarvedBricks::KeyOf({ x[0] / SideOfBrick, x[1] / SideOfBrick, x[2] / SideOfBrick });
      const auto [entry, isNew] = moved.try_emplace(key);
      if (isNew)
      {
        entry->second.Key = key;
        entry->second.Rows.fill(CarvedBricks::WholeRow);
      }
      const std::int64_t to = x[1] % SideOfBrick + SideOfBrick * (x[2] % SideOfBrick);
      const std::int64_t shift = 8 * (x[0] % SideOfBrick);
      std::uint64_t& fractions = entry->second.Rows[static_cast<std::size_t>(to)];
      fractions = (fractions & ~(std::uint64_t{ 255 } << shift)) | fraction << shift;
    }
  }
  std::vector<BrickTissue> all;
  all.reserve(moved.size());
  for (const auto& [key, brick] : moved)
  {
    all.push_back(brick);
  }
  return all;
}

} // namespace VolumeHaptics
