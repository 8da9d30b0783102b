// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Tests which points of a shell are solid, and what a box of samples contains, for
 * ShellKernels.h. The rules of FieldKernels.h apply here, too.
 */
#ifndef ShellMarkKernels_h
#define ShellMarkKernels_h

#include "Core/Math/LowestBit.h"
#include "Core/Tools/PointShell/FourCells.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** Returns the mark of one point, given its index and the trilinear value there. */
VOLUME_HAPTICS_INLINE std::uint64_t MarkOf(
  const ShellReading& reading, double x, double y, double z, double value)
{
  const bool isInside = x >= 0.0 && y >= 0.0 && z >= 0.0 && x <= reading.Border[0] &&
    y <= reading.Border[1] && z <= reading.Border[2];
  // The comparison is false for NaN.
  const bool isBeyond = reading.Sign * (value - reading.Level) >= 0.0;
  return isInside && isBeyond ? 1 : 0;
}

/** Returns the marks of four points, and writes the points' values. */
template <typename T, bool IsRow>
VOLUME_HAPTICS_INLINE std::uint64_t MarkFour(
  const ShellReading& reading, const FourVectors& points, const double* map, Double4& values)
{
  const auto along = [&](int row)
  {
    const double* const m = map + 3 * row;
    return m[0] * points.X + m[1] * points.Y + m[2] * points.Z + Spread(map[9 + row]);
  };
  const Double4 x = along(0);
  const Double4 y = along(1);
  const Double4 z = along(2);
  const FieldView& view = reading.View;
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const FourCells<T> at = ComputeCells<T>(view, x, y, z);
  const auto line = [&](std::int64_t i)
  {
    Double4 first;
    Double4 second;
    LoadFourPairs<IsRow>(at, i, first, second);
    return first + at.X.Fraction * (second - first);
  };
  const auto plane = [&](std::int64_t i)
  {
    const Double4 first = line(i);
    return first + at.Y.Fraction * (line(i + sy) - first);
  };
  const Double4 near = plane(0);
  values = near + at.Z.Fraction * (plane(sz) - near);
  if constexpr (std::is_floating_point_v<T>)
  {
    for (int lane = 0; lane < 4; ++lane)
    {
      if (!IsNumber(values[lane]))
      {
        // Trilinear() skips samples with the weight 0, which may be NaN.
        values[lane] = Trilinear<T>(view, x[lane], y[lane], z[lane]);
      }
    }
  }
  const auto isWithin = [](const Double4& p, double border)
  { return NotNegative(p) & NotNegative(Spread(border) - p); };
  return isWithin(x, reading.Border[0]) & isWithin(y, reading.Border[1]) &
    isWithin(z, reading.Border[2]) & NotNegative(reading.Sign * (values - Spread(reading.Level)));
}

template <typename T>
std::uint64_t MarkPoints(
  const ShellReading& reading, const ShellNumbers& points, const double* map) noexcept
{
  const bool isRow = HasRows(reading.View);
  std::uint64_t mark = 0;
  std::size_t i = 0;
  for (; i + 4 <= points.Count; i += 4)
  {
    Double4 values;
    const FourVectors four = { LoadDouble4(points.X + i), LoadDouble4(points.Y + i),
      LoadDouble4(points.Z + i) };
    const std::uint64_t found = isRow ? MarkFour<T, true>(reading, four, map, values)
                                      : MarkFour<T, false>(reading, four, map, values);
    mark |= found << i;
  }
  for (; i < points.Count; ++i)
  {
    const double px = points.X[i];
    const double py = points.Y[i];
    const double pz = points.Z[i];
    const double x = map[0] * px + map[1] * py + map[2] * pz + map[9];
    const double y = map[3] * px + map[4] * py + map[5] * pz + map[10];
    const double z = map[6] * px + map[7] * py + map[8] * pz + map[11];
    mark |= MarkOf(reading, x, y, z, Trilinear<T>(reading.View, x, y, z)) << i;
  }
  return mark;
}

template <typename T, bool IsRow>
VOLUME_HAPTICS_INLINE std::uint64_t UpdateLate(const ShellReading& reading,
  const ShellNumbers& points, const double* map, const ShellMarking& before, std::uint64_t late)
{
  std::uint64_t marks = before.Marks & ~late;
  const auto size = [](const Double4& a) { return Larger(a, -1.0 * a); };
  const Double4 level = Spread(reading.Level);
  while (late != 0)
  {
    // The last point may occur several times.
    int at[4];
    const auto next = [&late](int last)
    {
      const int bit = late != 0 ? LowestBit(late) : last;
      late &= late - 1;
      return bit;
    };
    at[0] = next(0);
    at[1] = next(at[0]);
    at[2] = next(at[1]);
    at[3] = next(at[2]);
    const auto load = [&at](const double* from)
    { return MakeDouble4(from[at[0]], from[at[1]], from[at[2]], from[at[3]]); };
    Double4 values;
    const std::uint64_t found =
      MarkFour<T, IsRow>(reading, { load(points.X), load(points.Y), load(points.Z) }, map, values);
    // The distances from the level, minus a margin for rounding.
    const Double4 distance = size(values - level) - 1e-12 * (size(values) + size(level));
    // If a value is NaN, or if the slope is not known, the mark is valid only here. The limit keeps
    // the length finite, because it will be scaled.
    constexpr double farthest = 1e300;
    const Double4 from = Spread(before.From);
    double until[4];
    StoreDouble4(Smaller(Larger(from + before.PerValue * distance, from), Spread(farthest)), until);
    for (int lane = 0; lane < 4; ++lane)
    {
      marks |= (found >> lane & 1) << at[lane];
      before.Until[at[lane]] = until[lane];
    }
  }
  return marks;
}

template <typename T>
std::uint64_t UpdateMarks(const ShellReading& reading, const ShellNumbers& points,
  const double* map, const ShellMarking& before) noexcept
{
  std::uint64_t late = 0;
  for (std::size_t i = 0; i < points.Count; i += 4)
  {
    late |= NotNegative(Spread(before.Now) - LoadDouble4(before.Until + i)) << i;
  }
  late &= FirstBits(points.Count);
  return HasRows(reading.View) ? UpdateLate<T, true>(reading, points, map, before, late)
                               : UpdateLate<T, false>(reading, points, map, before, late);
}

/**
 * Computes the largest magnitude of differences. The result is infinite if one of them is not a
 * number.
 */
class MostDifference
{
public:
  void Add(const Double4& at, const Double4& next)
  {
    const Double4 difference = next - at;
    this->Most = Larger(Larger(difference, -1.0 * difference), this->Most);
    // This sum differs from 0 if a difference is not a number.
    this->Odd = this->Odd + (difference - difference);
  }
  double Compute() const
  {
    double most = 0.0;
    for (int lane = 0; lane < 4; ++lane)
    {
      most = this->Most[lane] > most ? this->Most[lane] : most;
    }
    return AddLanes(this->Odd) == 0.0 ? most : HUGE_VAL;
  }

private:
  Double4 Most = MakeDouble4(0.0, 0.0, 0.0, 0.0);
  Double4 Odd = MakeDouble4(0.0, 0.0, 0.0, 0.0);
};

/**
 * Computes the largest slopes in a box whose samples along x are adjacent in memory. The box must
 * have at least five of them along x.
 */
template <typename T>
VOLUME_HAPTICS_INLINE void ComputeMostSlopesOfRows(
  const ShellReading& reading, const std::int64_t* low, const std::int64_t* high, double* most)
{
  const std::int64_t* const stride = reading.View.Volume.Stride;
  MostDifference along[3];
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      const T* const row =
        static_cast<const T*>(reading.View.Volume.Data) + j * stride[1] + k * stride[2];
      // The last samples have no neighbour in the box, so compare them with themselves.
      const std::int64_t sy = j < high[1] ? stride[1] : 0;
      const std::int64_t sz = k < high[2] ? stride[2] : 0;
      for (std::int64_t i = low[0];; i += 4)
      {
        // The last four samples may overlap the previous ones.
        const bool isLast = i + 3 >= high[0];
        const T* const at = row + (isLast ? high[0] - 3 : i);
        const Double4 here = LoadDouble4(at);
        along[0].Add(LoadDouble4(isLast ? at - 1 : at), LoadDouble4(isLast ? at : at + 1));
        along[1].Add(here, LoadDouble4(at + sy));
        along[2].Add(here, LoadDouble4(at + sz));
        if (isLast)
        {
          break;
        }
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    most[axis] = along[axis].Compute();
  }
}

template <typename T>
void ComputeMostSlopes(const ShellReading& reading, const std::int64_t* low,
  const std::int64_t* high, double* most) noexcept
{
  if (HasRows(reading.View) && high[0] - low[0] >= 4)
  {
    ComputeMostSlopesOfRows<T>(reading, low, high, most);
    return;
  }
  // Compute differences of small integers as integers.
  using Wide = std::conditional_t<std::is_integral_v<T> && sizeof(T) <= 2, std::int32_t, double>;
  const std::int64_t* const stride = reading.View.Volume.Stride;
  bool isFinite = true;
  Wide largest[3] = { 0, 0, 0 };
  const auto compare = [&](int axis, const T* at, const T* next)
  {
    const Wide difference = static_cast<Wide>(*next) - static_cast<Wide>(*at);
    const Wide size = difference < 0 ? -difference : difference;
    largest[axis] = size > largest[axis] ? size : largest[axis];
    if constexpr (std::is_floating_point_v<T>)
    {
      isFinite = isFinite && IsNumber(difference);
    }
  };
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      const T* at = static_cast<const T*>(reading.View.Volume.Data) + low[0] * stride[0] +
        j * stride[1] + k * stride[2];
      // The last samples have no neighbour in the box, so compare them with themselves.
      const std::int64_t sy = j < high[1] ? stride[1] : 0;
      const std::int64_t sz = k < high[2] ? stride[2] : 0;
      for (std::int64_t i = low[0]; i <= high[0]; ++i, at += stride[0])
      {
        compare(0, at, at + (i < high[0] ? stride[0] : 0));
        compare(1, at, at + sy);
        compare(2, at, at + sz);
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    most[axis] = isFinite ? static_cast<double>(largest[axis]) : HUGE_VAL;
  }
}

template <typename T>
bool IsAnySolid(
  const ShellReading& reading, const std::int64_t* low, const std::int64_t* high) noexcept
{
  const std::int64_t* const stride = reading.View.Volume.Stride;
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      const T* const line =
        static_cast<const T*>(reading.View.Volume.Data) + k * stride[2] + j * stride[1];
      bool isSolid = false;
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
      {
        const auto value = static_cast<double>(line[i * stride[0]]);
        isSolid = isSolid || reading.Sign * (value - reading.Level) >= 0.0;
      }
      if (isSolid)
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace
} // namespace VolumeHaptics

#endif
