// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/PointShell.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Spreads the lower 20 bits of a number, inserting two zeros after each. */
std::uint64_t SpreadBits(std::uint64_t bits)
{
  std::uint64_t spread = 0;
  for (int i = 0; i < 20; ++i)
  {
    spread |= (bits >> i & 1) << (3 * i);
  }
  return spread;
}

/**
 * Returns the rank of a point along the Morton curve through a box with the lower corner `low`. The
 * curve's cells have the edge 1 / `scale`.
 */
std::uint64_t PlaceOnCurve(const Vector3& position, const Vector3& low, double scale)
{
  const Vector3 at = scale * (position - low);
  return SpreadBits(static_cast<std::uint64_t>(at.X)) |
    SpreadBits(static_cast<std::uint64_t>(at.Y)) << 1 |
    SpreadBits(static_cast<std::uint64_t>(at.Z)) << 2;
}

struct ShellBox
{
  Vector3 Low;
  Vector3 High;
};

/** Returns the bounding box of points. There must be at least one. */
ShellBox ComputeBox(const ShellPoint* begin, const ShellPoint* end)
{
  ShellBox box{ begin->Position, begin->Position };
  for (const ShellPoint* point = begin; point != end; ++point)
  {
    box.Low = Least(box.Low, point->Position);
    box.High = Most(box.High, point->Position);
  }
  return box;
}

void SortAlongCurve(std::vector<ShellPoint>& points)
{
  if (points.empty())
  {
    return;
  }
  const ShellBox box = ComputeBox(points.data(), points.data() + points.size());
  const Vector3 size = box.High - box.Low;
  const double largest = std::max(std::max(size.X, size.Y), size.Z);
  constexpr double cells = 0xfffff;
  const double scale = largest > 0.0 ? cells / largest : 0.0;
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    order.emplace_back(PlaceOnCurve(points[i].Position, box.Low, scale), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<ShellPoint> sorted;
  sorted.reserve(points.size());
  for (const auto& [place, i] : order)
  {
    sorted.push_back(points[i]);
  }
  points.swap(sorted);
}

/** Computes a sphere around points from their bounding box. */
ShellBlock MakeBlock(const ShellPoint* begin, const ShellPoint* end)
{
  const ShellBox box = ComputeBox(begin, end);
  ShellBlock block;
  block.Centre = 0.5 * (box.Low + box.High);
  for (const ShellPoint* point = begin; point != end; ++point)
  {
    block.Radius = std::max(block.Radius, Norm(point->Position - block.Centre));
  }
  return block;
}

} // namespace

PointShell::PointShell(std::vector<ShellPoint> points)
{
  const auto isUseless = [](const ShellPoint& point)
  { return !IsFinite(point.Position) || !std::isfinite(point.Area) || !(point.Area > 0.0); };
  points.erase(std::remove_if(points.begin(), points.end(), isUseless), points.end());
  SortAlongCurve(points);
  for (std::vector<double>* numbers : { &this->X, &this->Y, &this->Z, &this->Areas })
  {
    numbers->reserve(points.size());
  }
  for (const ShellPoint& point : points)
  {
    this->X.push_back(point.Position.X);
    this->Y.push_back(point.Position.Y);
    this->Z.push_back(point.Position.Z);
    this->Areas.push_back(point.Area);
    this->Area += point.Area;
    this->Reach = std::max(this->Reach, Norm(point.Position));
  }
  for (std::size_t begin = 0; begin < points.size(); begin += ShellBlock::Size)
  {
    const std::size_t end = std::min(begin + ShellBlock::Size, points.size());
    this->Blocks.push_back(MakeBlock(points.data() + begin, points.data() + end));
  }
}

std::size_t PointShell::GetMemorySize() const noexcept
{
  return sizeof(*this) + this->Blocks.capacity() * sizeof(ShellBlock) +
    sizeof(double) *
    (this->X.capacity() + this->Y.capacity() + this->Z.capacity() + this->Areas.capacity());
}

} // namespace VolumeHaptics
