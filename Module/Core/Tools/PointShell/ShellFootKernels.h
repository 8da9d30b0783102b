// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads values and gradients at the feet of points, for ShellKernels.h. The rules in FieldKernels.h
 * also apply here.
 */
#ifndef ShellFootKernels_h
#define ShellFootKernels_h

#include "Core/Tools/PointShell/FourCells.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** Reads value and gradient. Each position is clamped to the samples. */
template <typename T>
VOLUME_HAPTICS_OUTLINE void ReadFootAtBorder(
  const FieldView& view, double x, double y, double z, double* to)
{
  double values[6];
  for (int i = 0; i < 6; ++i)
  {
    const double step = i % 2 == 0 ? -1.0 : 1.0;
    const int axis = i / 2;
    values[i] = Trilinear<T>(
      view, axis == 0 ? x + step : x, axis == 1 ? y + step : y, axis == 2 ? z + step : z);
  }
  to[0] = Trilinear<T>(view, x, y, z);
  for (int axis = 0; axis < 3; ++axis)
  {
    to[1 + axis] = to[4 + axis] = 0.5 * (values[2 * axis + 1] - values[2 * axis]);
  }
}

/**
 * Reads the value and its central differences. These are seven interpolations with the same
 * weights. The differences extend over one sample on both sides, so 32 samples suffice.
 */
template <typename T>
VOLUME_HAPTICS_INLINE void ReadFoot(const FieldView& view, double x, double y, double z, double* to)
{
  const auto& [ax, ay, az] = LocateCell(view, x, y, z);
  const auto isWithin = [&view](std::int64_t cell, int axis)
  {
    const auto place = static_cast<double>(cell);
    return place >= view.First[axis] + 1.0 && place <= view.Last[axis] - 2.0;
  };
  if (!isWithin(ax.Cell, 0) || !isWithin(ay.Cell, 1) || !isWithin(az.Cell, 2))
  {
    ReadFootAtBorder<T>(view, x, y, z, to);
    return;
  }
  const std::int64_t sx = view.Volume.Stride[0];
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const T* const p =
    static_cast<const T*>(view.Volume.Data) + ax.Cell * sx + ay.Cell * sy + az.Cell * sz;
  const double fx = ax.Fraction;
  const double fy = ay.Fraction;
  const double fz = az.Fraction;
  const double ey = 1.0 - fy;
  const double ez = 1.0 - fz;
  // Four lines along x in each array: the lines of the cell, their neighbours along y, and their
  // neighbours along z.
  const T* const inner[4] = { p, p + sy, p + sz, p + sy + sz };
  const T* const besideY[4] = { p - sy, p - sy + sz, p + 2 * sy, p + 2 * sy + sz };
  const T* const besideZ[4] = { p - sz, p - sz + sy, p + 2 * sz, p + 2 * sz + sy };
  Double4 t0;
  Double4 t1;
  Double4 t2;
  Double4 t3;
  LoadFourPairs<false>(inner, -sx, sx, t0, t1);
  LoadFourPairs<false>(inner, sx, sx, t2, t3);
  const Double4 step = t2 - t1;
  const Double4 a = t1 + fx * step;
  const Double4 alongX = 0.5 * ((t2 + fx * (t3 - t2)) - (t0 + fx * (t1 - t0)));
  LoadFourPairs<false>(besideY, 0, sx, t0, t3);
  const Double4 b = t0 + fx * (t3 - t0);
  LoadFourPairs<false>(besideZ, 0, sx, t0, t3);
  const Double4 c = t0 + fx * (t3 - t0);
  const Double4 cell = MakeDouble4(ey * ez, fy * ez, ey * fz, fy * fz);
  const Double4 innerY = MakeDouble4(-fy * ez, ey * ez, -fy * fz, ey * fz);
  const Double4 outerY = MakeDouble4(-ey * ez, -ey * fz, fy * ez, fy * fz);
  const Double4 innerZ = MakeDouble4(-ey * fz, -fy * fz, ey * ez, fy * ez);
  const Double4 outerZ = MakeDouble4(-ey * ez, -fy * ez, ey * fz, fy * fz);
  AddLanes(
    cell * a, cell * alongX, 0.5 * (innerY * a + outerY * b), 0.5 * (innerZ * a + outerZ * c), to);
  double own[4];
  AddLanes(cell * step, MakeDouble4(-ez, ez, -fz, fz) * a, MakeDouble4(-ey, -fy, ey, fy) * a,
    cell * a, own);
  to[4] = own[0];
  to[5] = own[1];
  to[6] = own[2];
  if constexpr (std::is_floating_point_v<T>)
  {
    if (!IsNumber(to[0] + to[1] + to[2] + to[3]))
    {
      // ReadFootAtBorder() ignores samples with the weight 0, which may be NaN.
      ReadFootAtBorder<T>(view, x, y, z, to);
    }
  }
}

template <typename T>
void ReadOneFoot(const ShellReading& reading, double x, double y, double z, double* to) noexcept
{
  ReadFoot<T>(reading.View, x, y, z, to);
}

/** One lane of ReadFoot()'s sums for four points. */
struct FourFeet
{
  Double4 Of[7];
};
VOLUME_HAPTICS_INLINE FourFeet AddFeet(const FourFeet& a, const FourFeet& b)
{
  return { { a.Of[0] + b.Of[0], a.Of[1] + b.Of[1], a.Of[2] + b.Of[2], a.Of[3] + b.Of[3],
    a.Of[4] + b.Of[4], a.Of[5] + b.Of[5], a.Of[6] + b.Of[6] } };
}

/**
 * Computes the contribution of one line along x to the sums of ReadFoot(), for four cells at a
 * time. isSecondY and isSecondZ select one of a cell's four lines. If IsRow, the line's samples are
 * adjacent in memory.
 */
template <typename T, bool IsRow>
VOLUME_HAPTICS_INLINE FourFeet ReadLine(const FourCells<T>& at, const std::int64_t* stride,
  const Double4& fy, const Double4& fz, bool isSecondY, bool isSecondZ)
{
  const Double4 one = Spread(1.0);
  const Double4 ey = one - fy;
  const Double4 ez = one - fz;
  const auto minus = [](const Double4& a) { return -1.0 * a; };
  // Weights of this line, of the line opposite along y, and of the line opposite along z.
  const Double4 wy = isSecondY ? fy : ey;
  const Double4 wz = isSecondZ ? fz : ez;
  const Double4 own = wy * wz;
  const Double4 acrossY = (isSecondY ? ey : fy) * wz;
  const Double4 acrossZ = wy * (isSecondZ ? ez : fz);
  const std::int64_t sx = IsRow ? 1 : stride[0];
  const std::int64_t line = (isSecondY ? stride[1] : 0) + (isSecondZ ? stride[2] : 0);
  // In the lanes of ReadFoot(), the neighbours along y have another order.
  const bool isBehind = isSecondZ;
  const Double4 outer = (isSecondZ ? fy : ey) * (isSecondY ? fz : ez);
  const std::int64_t besideY =
    (isBehind ? 2 * stride[1] : -stride[1]) + (isSecondY ? stride[2] : 0);
  const std::int64_t besideZ = line + (isSecondZ ? stride[2] : -stride[2]);
  const auto load = [&](std::int64_t distance, Double4& first, Double4& second)
  { LoadFourPairs<IsRow>(at, distance, first, second); };
  const Double4 fx = at.X.Fraction;
  Double4 t0;
  Double4 t1;
  Double4 t2;
  Double4 t3;
  load(line - sx, t0, t1);
  load(line + sx, t2, t3);
  const Double4 step = t2 - t1;
  const Double4 a = t1 + fx * step;
  const Double4 alongX = 0.5 * ((t2 + fx * (t3 - t2)) - (t0 + fx * (t1 - t0)));
  load(besideY, t0, t3);
  const Double4 b = t0 + fx * (t3 - t0);
  load(besideZ, t0, t3);
  const Double4 c = t0 + fx * (t3 - t0);
  const Double4 alongY =
    (isSecondY ? acrossY : minus(acrossY)) * a + (isBehind ? outer : minus(outer)) * b;
  const Double4 alongZ = isSecondZ ? acrossZ * a + own * c : minus(acrossZ) * a + minus(own) * c;
  return { { own * a, own * alongX, 0.5 * alongY, 0.5 * alongZ, own * step,
    (isSecondY ? wz : minus(wz)) * a, (isSecondZ ? wy : minus(wy)) * a } };
}

/**
 * Like ReadFoot(), for four points at a time. Returns false if one of them is at the border.
 */
template <typename T, bool IsRow>
VOLUME_HAPTICS_INLINE bool ReadFourFeet(const FieldView& view, std::size_t i, ShellBatch& batch)
{
  const FourVectors place = LoadVectors(batch.Place, i);
  const FourCells<T> at = ComputeCells<T>(view, place.X, place.Y, place.Z);
  const auto isWithin = [&view](const FourPlaces& p, int axis)
  {
    return NotNegative(p.Cell - Spread(view.First[axis] + 1.0)) &
      NotNegative(Spread(view.Last[axis] - 2.0) - p.Cell);
  };
  constexpr std::uint64_t all = 0b1111;
  if ((isWithin(at.X, 0) & isWithin(at.Y, 1) & isWithin(at.Z, 2)) != all)
  {
    return false;
  }
  const Double4 fy = at.Y.Fraction;
  const Double4 fz = at.Z.Fraction;
  const std::int64_t* const stride = view.Volume.Stride;
  // Add in the same order as AddLanes() does.
  FourFeet sum = AddFeet(ReadLine<T, IsRow>(at, stride, fy, fz, false, false),
    ReadLine<T, IsRow>(at, stride, fy, fz, false, true));
  sum = AddFeet(sum,
    AddFeet(ReadLine<T, IsRow>(at, stride, fy, fz, true, false),
      ReadLine<T, IsRow>(at, stride, fy, fz, true, true)));
  double* const to[7] = { batch.Value, batch.Gradient[0], batch.Gradient[1], batch.Gradient[2],
    batch.Cell[0], batch.Cell[1], batch.Cell[2] };
  for (int n = 0; n < 7; ++n)
  {
    StoreDouble4(sum.Of[n], to[n] + i);
  }
  return true;
}

template <typename T>
void ReadFeet(const ShellReading& reading, ShellBatch& batch) noexcept
{
  const auto readOne = [&](std::size_t i)
  {
    double foot[7];
    ReadFoot<T>(reading.View, batch.Place[0][i], batch.Place[1][i], batch.Place[2][i], foot);
    batch.Value[i] = foot[0];
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.Gradient[axis][i] = foot[1 + axis];
      batch.Cell[axis][i] = foot[4 + axis];
    }
  };
  const bool isRow = HasRows(reading.View);
  std::size_t i = 0;
  for (; i + 4 <= batch.Count; i += 4)
  {
    const bool isRead = isRow ? ReadFourFeet<T, true>(reading.View, i, batch)
                              : ReadFourFeet<T, false>(reading.View, i, batch);
    for (std::size_t n = i; n < i + 4; ++n)
    {
      // Leave samples that are NaN or infinite to ReadFoot().
      const bool isDone = isRead &&
        (!std::is_floating_point_v<T> ||
          IsNumber(
            batch.Value[n] + batch.Gradient[0][n] + batch.Gradient[1][n] + batch.Gradient[2][n]));
      if (!isDone)
      {
        readOne(n);
      }
    }
  }
  for (; i < batch.Count; ++i)
  {
    readOne(i);
  }
}

} // namespace
} // namespace VolumeHaptics

#endif
