// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/PointShell/ShellReader.h"

#include "Core/Field/WholeData.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

ShellFunctions SelectBaselineShellFunctions(ScalarType type);
#ifdef VOLUME_HAPTICS_HAS_AVX2
ShellFunctions SelectAVX2ShellFunctions(ScalarType type);
#endif

namespace
{

ShellFunctions SelectShellFunctions(ScalarType type, InstructionSet instructions) noexcept
{
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    return SelectAVX2ShellFunctions(type);
  }
#else
  static_cast<void>(instructions);
#endif
  return SelectBaselineShellFunctions(type);
}

/** The samples of all cells that a box around an index touches. */
struct SampleBox
{
  SampleBox(const Vector3& centre, const Vector3& half) noexcept
  {
    const double middle[3] = { centre.X, centre.Y, centre.Z };
    const double sizes[3] = { half.X, half.Y, half.Z };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->From[axis] = std::floor(middle[axis] - sizes[axis]);
      this->To[axis] = std::floor(middle[axis] + sizes[axis]) + 1.0;
    }
  }

  double From[3];
  double To[3];
};

} // namespace

const MaterialTable::Segment* FindSegmentOf(const MaterialTable& table, double x) noexcept
{
  return table.FindSegment(x);
}

const DistinctnessTable::Segment* FindSegmentOf(const DistinctnessTable& table, double x) noexcept
{
  return table.FindSegment(x);
}

ShellReader::ShellReader(const VolumeView& view, double level, bool isBelow,
  const CarvedView& carved, InstructionSet instructions) noexcept
  : Given(view)
  , Carved(carved)
  , Functions(SelectShellFunctions(view.Type, instructions))
  , OfCopies(SelectShellFunctions(ScalarType::Float64, instructions))
{
  this->Reading.View.Volume = view;
  this->Reading.View.Volume.Data = WholeData(view);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Reading.View.First[axis] = static_cast<double>(view.First[axis]);
    this->Reading.View.Last[axis] = static_cast<double>(view.Last(axis));
    this->Reading.Border[axis] = static_cast<double>(view.Border(axis));
  }
  this->Reading.Level = level;
  this->Reading.Sign = isBelow ? -1.0 : 1.0;
}

template <typename F>
void ShellReader::ForEachCopy(const CarvedBox* boxes, std::size_t count, const F& f) const noexcept
{
  double samples[MostCopied];
  ShellReading copy = this->Reading;
  // Ends of the halves that are not processed yet. Boxes are joined in halves, because consecutive
  // points are usually neighbours.
  std::size_t ends[16] = { count };
  int rest = count > 0 ? 1 : 0;
  for (std::size_t begin = 0; rest > 0;)
  {
    const std::size_t end = ends[rest - 1];
    const auto number = static_cast<std::int64_t>(end - begin);
    CarvedBox box = boxes[begin];
    for (std::size_t i = begin + 1; i < end; ++i)
    {
      for (int a = 0; a < 3; ++a)
      {
        box.Low[a] = std::min(box.Low[a], boxes[i].Low[a]);
        box.High[a] = std::max(box.High[a], boxes[i].High[a]);
      }
    }
    const bool isLong = box.Size(0) > CarvedBox::MostSide || box.Size(1) > CarvedBox::MostSide ||
      box.Size(2) > CarvedBox::MostSide;
    if (number > 1 && (isLong || box.Samples() > std::min(MostCopied, WorthOfPoint * number)))
    {
      ends[rest++] = begin + (end - begin) / 2;
      continue;
    }
    if (CopyCarved(this->Reading.View.Volume, this->Carved, box, samples, copy.View.Volume))
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        f(copy, i);
      }
    }
    begin = end;
    --rest;
  }
}

std::uint64_t ShellReader::Remark(
  const ShellNumbers& points, const double* map, std::uint64_t marks) const noexcept
{
  double places[64][3];
  CarvedBox boxes[64];
  std::size_t marked[64];
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.Count; ++i)
  {
    if ((marks >> i & 1) == 0)
    {
      continue;
    }
    double* const at = places[count];
    for (int a = 0; a < 3; ++a)
    {
      const double* const row = map + 3 * a;
      at[a] = row[0] * points.X[i] + row[1] * points.Y[i] + row[2] * points.Z[i] + map[9 + a];
    }
    boxes[count] = ComputeBox(this->Given, at, 0, 0);
    marked[count++] = i;
  }
  this->ForEachCopy(boxes, count,
    [&](const ShellReading& copy, std::size_t n)
    {
      const double zero = 0.0;
      const double* const at = places[n];
      const double here[12] = { 1, 0, 0, 0, 1, 0, 0, 0, 1, at[0], at[1], at[2] };
      const bool isSolid = this->OfCopies.Mark(copy, { &zero, &zero, &zero, 1 }, here) != 0;
      marks &= isSolid ? ~std::uint64_t{ 0 } : ~(std::uint64_t{ 1 } << marked[n]);
    });
  return marks;
}

void ShellReader::ReadCarved(ShellBatch& batch) const noexcept
{
  const bool isFloat =
    this->Given.Type == ScalarType::Float32 || this->Given.Type == ScalarType::Float64;
  CarvedBox boxes[ShellBatch::Most];
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    const double at[3] = { batch.Place[0][i], batch.Place[1][i], batch.Place[2][i] };
    boxes[i] = ComputeBox(this->Given, at, 1, 1);
    const auto isShort = [&](int a) { return boxes[i].Size(a) < 4; };
    if (isFloat || isShort(0) || isShort(1) || isShort(2))
    {
      // At the border, and near samples that are not numbers, rounding may move a position into the
      // next cell, one sample away.
      boxes[i] = ComputeBox(this->Given, at, 1, 2);
    }
  }
  this->ForEachCopy(boxes, batch.Count,
    [&](const ShellReading& copy, std::size_t i)
    {
      double foot[7];
      this->OfCopies.Foot(copy, batch.Place[0][i], batch.Place[1][i], batch.Place[2][i], foot);
      batch.Value[i] = foot[0];
      for (int a = 0; a < 3; ++a)
      {
        batch.Gradient[a][i] = foot[1 + a];
        batch.Cell[a][i] = foot[4 + a];
      }
    });
}

void ShellReader::ReadCarved(const ShellNumbers& indices, double* to) const noexcept
{
  CarvedBox boxes[ShellBatch::Most];
  for (std::size_t first = 0; first < indices.Count; first += ShellBatch::Most)
  {
    const double* const x = indices.X + first;
    const double* const y = indices.Y + first;
    const double* const z = indices.Z + first;
    const std::size_t some = std::min(ShellBatch::Most, indices.Count - first);
    for (std::size_t i = 0; i < some; ++i)
    {
      const double at[3] = { x[i], y[i], z[i] };
      boxes[i] = ComputeBox(this->Given, at, 0, 0);
    }
    this->ForEachCopy(boxes, some,
      [&](const ShellReading& copy, std::size_t i) {
        this->OfCopies.Values(copy, { x + i, y + i, z + i, 1 }, to + first + i);
      });
  }
}

bool ShellReader::MayBeSolid(const Vector3& centre, const Vector3& half) const noexcept
{
  constexpr double mostSamples = 4096.0;
  const SampleBox box(centre, half);
  const FieldView& view = this->Reading.View;
  std::int64_t low[3];
  std::int64_t high[3];
  double samples = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The comparison is false for NaN, too.
    if (!(box.To[axis] - box.From[axis] < mostSamples))
    {
      return true;
    }
    // Outside the resident samples, use the nearest sample.
    const double first = view.First[axis];
    const double last = view.Last[axis];
    low[axis] = static_cast<std::int64_t>(std::min(std::max(box.From[axis], first), last));
    high[axis] = static_cast<std::int64_t>(std::min(std::max(box.To[axis], first), last));
    samples *= static_cast<double>(high[axis] - low[axis] + 1);
  }
  return samples > mostSamples || this->Functions.Box(this->Reading, low, high);
}

bool ShellReader::ComputeSlopes(
  const Vector3& centre, const Vector3& half, double* slopes) const noexcept
{
  // Reading more samples would take longer than reading the points of a block, which it is meant to
  // save.
  constexpr double mostSamples = 512.0;
  const SampleBox box(centre, half);
  const FieldView& view = this->Reading.View;
  std::int64_t low[3];
  std::int64_t high[3];
  double samples = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The comparisons are false for NaN, too.
    if (!(box.From[axis] >= view.First[axis] && box.To[axis] <= view.Last[axis]))
    {
      return false;
    }
    low[axis] = static_cast<std::int64_t>(box.From[axis]);
    high[axis] = static_cast<std::int64_t>(box.To[axis]);
    samples *= box.To[axis] - box.From[axis] + 1.0;
  }
  if (samples > mostSamples)
  {
    return false;
  }
  this->Functions.Slope(this->Reading, low, high, slopes);
  return slopes[0] < HUGE_VAL && slopes[1] < HUGE_VAL && slopes[2] < HUGE_VAL;
}

} // namespace VolumeHaptics
