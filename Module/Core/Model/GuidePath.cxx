// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/GuidePath.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns the direction halfway between two consecutive directions, or the second one if the line
 * reverses.
 */
Vector3 DirectionBetween(const Vector3& a, const Vector3& b) noexcept
{
  const Vector3 sum = a + b;
  const double length = Norm(sum);
  return length > 1e-6 ? (1.0 / length) * sum : b;
}

constexpr double Nowhere = HUGE_VAL;

} // namespace

GuidePath::GuidePath(const std::vector<Line>& lines, double rounding)
{
  for (const Line& line : lines)
  {
    this->AddLine(line, rounding);
  }
  if (!this->IsEmpty())
  {
    this->MakeBoxes();
  }
}

bool GuidePath::IsSame(const GuidePath& other) const noexcept
{
  return std::equal(this->Segments.begin(), this->Segments.end(), other.Segments.begin(),
    other.Segments.end(),
    [](const Segment& a, const Segment& b)
    {
      return IsIdentical(a.Begin, b.Begin) && IsIdentical(a.Direction, b.Direction) &&
        a.Length == b.Length && a.Turn == b.Turn && a.BeginsLine == b.BeginsLine &&
        a.EndsLine == b.EndsLine && IsIdentical(a.AtBegin, b.AtBegin) &&
        IsIdentical(a.AtEnd, b.AtEnd);
    });
}

void GuidePath::AddLine(const Line& line, double rounding)
{
  const std::size_t first = this->Segments.size();
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    const Vector3 way = line[i] - line[i - 1];
    const double length = Norm(way);
    if (length > 0.0)
    {
      Segment segment;
      segment.Begin = line[i - 1];
      segment.Direction = (1.0 / length) * way;
      segment.Length = length;
      segment.AtBegin = segment.AtEnd = segment.Direction;
      segment.Turn = 0.5 * std::min(rounding, length);
      this->Segments.push_back(segment);
    }
  }
  const std::size_t end = this->Segments.size();
  if (end == first)
  {
    return;
  }
  for (std::size_t i = first; i + 1 < end; ++i)
  {
    this->Segments[i].AtEnd = this->Segments[i + 1].AtBegin =
      DirectionBetween(this->Segments[i].Direction, this->Segments[i + 1].Direction);
  }
  Segment& begin = this->Segments[first];
  Segment& last = this->Segments[end - 1];
  if (IsIdentical(line.front(), line.back()) && end - first > 1)
  {
    last.AtEnd = begin.AtBegin = DirectionBetween(last.Direction, begin.Direction);
  }
  else
  {
    begin.BeginsLine = true;
    last.EndsLine = true;
  }
}

void GuidePath::MakeBoxes()
{
  const std::size_t needed = (this->Segments.size() + SegmentsOfALeaf - 1) / SegmentsOfALeaf;
  std::size_t leaves = 1;
  while (leaves < needed)
  {
    leaves *= 2;
  }
  this->FirstLeaf = leaves - 1;
  // Put boxes without segments infinitely far away, so that no search visits them.
  this->Boxes.assign(
    2 * leaves - 1, { { Nowhere, Nowhere, Nowhere }, { -Nowhere, -Nowhere, -Nowhere } });
  for (std::size_t i = 0; i < this->Segments.size(); ++i)
  {
    const Segment& segment = this->Segments[i];
    const Vector3 end = segment.Begin + segment.Length * segment.Direction;
    Box& box = this->Boxes[this->FirstLeaf + i / SegmentsOfALeaf];
    box.Low = Least(box.Low, Least(segment.Begin, end));
    box.High = Most(box.High, Most(segment.Begin, end));
  }
  for (std::size_t i = this->FirstLeaf; i-- > 0;)
  {
    this->Boxes[i].Low = Least(this->Boxes[2 * i + 1].Low, this->Boxes[2 * i + 2].Low);
    this->Boxes[i].High = Most(this->Boxes[2 * i + 1].High, this->Boxes[2 * i + 2].High);
  }
}

double GuidePath::SquareDistance(std::size_t box, const Vector3& place) const noexcept
{
  const Vector3 below = this->Boxes[box].Low - place;
  const Vector3 above = place - this->Boxes[box].High;
  const Vector3 outside = Most(Most(below, above), Vector3{});
  return Dot(outside, outside);
}

GuidePlace GuidePath::Find(const Vector3& place) const noexcept
{
  // Size of the stack: at most one box per level of the tree waits, and one more.
  constexpr std::size_t deepest = 64;
  std::size_t waiting[deepest] = { 0 };
  std::size_t count = 1;
  double least = Nowhere;
  const Segment* nearest = &this->Segments.front();
  double fraction = 0.0; // distance of the nearest point from its segment's begin
  while (count > 0)
  {
    const std::size_t box = waiting[--count];
    if (!(this->SquareDistance(box, place) < least))
    {
      continue;
    }
    if (box < this->FirstLeaf)
    {
      const std::size_t a = 2 * box + 1;
      const bool isFirstNearer =
        this->SquareDistance(a, place) <= this->SquareDistance(a + 1, place);
      waiting[count++] = isFirstNearer ? a + 1 : a;
      waiting[count++] = isFirstNearer ? a : a + 1;
      continue;
    }
    const std::size_t begin = (box - this->FirstLeaf) * SegmentsOfALeaf;
    const std::size_t end = std::min(begin + SegmentsOfALeaf, this->Segments.size());
    for (std::size_t i = begin; i < end; ++i)
    {
      const Segment& segment = this->Segments[i];
      const Vector3 from = place - segment.Begin;
      const double along = std::clamp(Dot(from, segment.Direction), 0.0, segment.Length);
      const Vector3 aside = from - along * segment.Direction;
      const double square = Dot(aside, aside);
      if (square < least)
      {
        least = square;
        nearest = &segment;
        fraction = along;
      }
    }
  }
  GuidePlace found;
  found.Nearest = nearest->Begin + fraction * nearest->Direction;
  const double toEnd = nearest->Length - fraction;
  const bool isNearBegin = fraction < toEnd;
  const double turned = std::min(fraction, toEnd) / nearest->Turn;
  const Vector3& corner = isNearBegin ? nearest->AtBegin : nearest->AtEnd;
  found.Direction = nearest->Direction;
  if (turned < 1.0)
  {
    const Vector3 mixed = (1.0 - turned) * corner + turned * nearest->Direction;
    const double length = Norm(mixed);
    found.Direction = length > 0.0 ? (1.0 / length) * mixed : nearest->Direction;
  }
  const bool nearsBegin = nearest->BeginsLine && (isNearBegin || !nearest->EndsLine);
  found.IsNearEnd = nearsBegin || nearest->EndsLine;
  found.Outward = nearsBegin ? -nearest->Direction : nearest->Direction;
  found.End = nearsBegin ? nearest->Begin : nearest->Begin + nearest->Length * nearest->Direction;
  return found;
}

} // namespace VolumeHaptics
