// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cell of a position along an axis, and the linear kernels. The rules of FieldKernels.h hold
 * here too.
 */
#ifndef LinearKernels_h
#define LinearKernels_h

#include "Core/Field/FieldSampler.h"
#include "Core/Math/Double4.h"

#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** The largest whole number below a position that is not negative. */
VOLUME_HAPTICS_INLINE double Floor(double position)
{
#if defined(__SSE4_1__)
  return __builtin_floor(position); // one instruction there, a call elsewhere
#else
  return static_cast<double>(static_cast<std::int64_t>(position));
#endif
}

/** The sample at or before a position along an axis, and the distance from it to the position. */
struct Axis
{
  std::int64_t Cell;
  double Fraction;
};

/** Positions outside [first, last] are clamped; first is not negative. */
VOLUME_HAPTICS_INLINE Axis Locate(double position, double first, double last)
{
  const double inside = position > first ? (position < last ? position : last) : first;
  // The index does not wait for the rounded number.
  return { static_cast<std::int64_t>(inside), inside - Floor(inside) };
}

/** The same with a sample behind the cell: the last sample is the end of the cell before it. */
VOLUME_HAPTICS_INLINE Axis LocateCell(double position, double first, double last)
{
  const double inside = position > first ? (position < last ? position : last) : first;
  const double whole = Floor(inside);
  const double cell = whole < last ? whole : last - 1.0;
  return { static_cast<std::int64_t>(cell), inside - cell };
}

/** A cell of the samples, and a position in it. */
struct CellPlace
{
  Axis X;
  Axis Y;
  Axis Z;
};

VOLUME_HAPTICS_INLINE CellPlace LocateCell(const FieldView& view, double x, double y, double z)
{
  return { LocateCell(x, view.First[0], view.Last[0]), LocateCell(y, view.First[1], view.Last[1]),
    LocateCell(z, view.First[2], view.Last[2]) };
}

template <typename T>
VOLUME_HAPTICS_INLINE double Trilinear(const FieldView& view, const CellPlace& place)
{
  const auto& [ax, ay, az] = place;
  const std::int64_t sx = view.Volume.Stride[0];
  const std::int64_t sy = view.Volume.Stride[1];
  const std::int64_t sz = view.Volume.Stride[2];
  const T* const p =
    static_cast<const T*>(view.Volume.Data) + ax.Cell * sx + ay.Cell * sy + az.Cell * sz;
  // Both samples along x of both lines of a plane.
  const auto plane = [&](const T* q)
  {
    if (sx == 1)
    {
      return LoadPairs(q, q + sy);
    }
    const T taps[4] = { q[0], q[sx], q[sy], q[sy + sx] };
    return LoadDouble4(taps);
  };
  const Double4 near = plane(p);
  const Double4 lines = near + az.Fraction * (plane(p + sz) - near);
  const double a = lines[0] + ay.Fraction * (lines[2] - lines[0]);
  const double b = lines[1] + ay.Fraction * (lines[3] - lines[1]);
  const double value = a + ax.Fraction * (b - a);
  if constexpr (std::is_floating_point_v<T>)
  {
    if (!IsNumber(value))
    {
      // A sample that is not a number but has no weight does not count.
      const double wx[2] = { 1.0 - ax.Fraction, ax.Fraction };
      const double wy[2] = { 1.0 - ay.Fraction, ay.Fraction };
      const double wz[2] = { 1.0 - az.Fraction, az.Fraction };
      double sum = 0.0;
      for (int i = 0; i < 8; ++i)
      {
        const double weight = wx[i & 1] * wy[(i >> 1) & 1] * wz[i >> 2];
        const T tap = p[(i & 1) * sx + ((i >> 1) & 1) * sy + (i >> 2) * sz];
        sum += weight == 0.0 ? 0.0 : weight * static_cast<double>(tap);
      }
      return sum;
    }
  }
  return value;
}

template <typename T>
VOLUME_HAPTICS_INLINE double Trilinear(const FieldView& view, double x, double y, double z)
{
  return Trilinear<T>(view, LocateCell(view, x, y, z));
}

template <typename T>
double TrilinearValue(const FieldView& view, double x, double y, double z) noexcept
{
  return Trilinear<T>(view, x, y, z);
}

template <typename T>
ValuePair TrilinearPair(
  const FieldView& view, double x, double y, double z, double dx, double dy, double dz) noexcept
{
  return { Trilinear<T>(view, x + dx, y + dy, z + dz), Trilinear<T>(view, x - dx, y - dy, z - dz) };
}

template <typename T>
FramePair<ValuePair> TrilinearPairs(const FieldView& first, const FieldView& second, double x,
  double y, double z, double dx, double dy, double dz) noexcept
{
  const CellPlace ahead = LocateCell(first, x + dx, y + dy, z + dz);
  const CellPlace behind = LocateCell(first, x - dx, y - dy, z - dz);
  return { { Trilinear<T>(first, ahead), Trilinear<T>(first, behind) },
    { Trilinear<T>(second, ahead), Trilinear<T>(second, behind) } };
}

template <typename T>
FieldSample CentralDifference(const FieldView& view, double x, double y, double z) noexcept
{
  const double r = view.Kernel.Radius;
  const double scale = 0.5 / r;
  const double x0 = Trilinear<T>(view, x - r, y, z);
  const double x1 = Trilinear<T>(view, x + r, y, z);
  const double y0 = Trilinear<T>(view, x, y - r, z);
  const double y1 = Trilinear<T>(view, x, y + r, z);
  const double z0 = Trilinear<T>(view, x, y, z - r);
  const double z1 = Trilinear<T>(view, x, y, z + r);
  return { (x0 + x1 + y0 + y1 + z0 + z1) / 6.0,
    Vector3{ scale * (x1 - x0), scale * (y1 - y0), scale * (z1 - z0) } };
}

} // namespace
} // namespace VolumeHaptics

#endif
