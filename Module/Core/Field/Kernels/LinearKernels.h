// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The cell of a position along an axis, and the linear kernels. The rules in FieldKernels.h also
 * apply here.
 */
#ifndef LinearKernels_h
#define LinearKernels_h

#include "Core/Field/FieldSampler.h"
#include "Core/Math/Double4.h"
#include "Core/Math/KernelFloor.h"

#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/**
 * The last sample at or before a position along an axis, and the distance (0 to 1) from there to
 * the position.
 */
struct Axis
{
  std::int64_t Cell;
  double Fraction;
};

/**
 * Returns the sample at or before a position. Clamps the position to [first, last]. `first` must
 * not be negative.
 */
VOLUME_HAPTICS_INLINE Axis Locate(double position, double first, double last)
{
  const double inside = position > first ? (position < last ? position : last) : first;
  // The cell is converted from `inside`, so that the processor need not wait for Floor().
  return { static_cast<std::int64_t>(inside), inside - Floor(inside) };
}

/**
 * Like Locate(), but there is always a sample behind the cell: at the last sample, returns the end
 * of the previous cell.
 */
VOLUME_HAPTICS_INLINE Axis LocateCell(double position, double first, double last)
{
  const double inside = position > first ? (position < last ? position : last) : first;
  const double whole = Floor(inside);
  if (whole < last)
  {
    // The cell is converted from `inside` as in Locate.
    return { static_cast<std::int64_t>(inside), inside - whole };
  }
  return { static_cast<std::int64_t>(last - 1.0), inside - (last - 1.0) };
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

/** The eight samples of a cell. */
template <typename T>
struct CellSamples
{
  const T* First;
  const std::int64_t* Stride;
};

/** The eight samples of a cell in two time steps. */
template <typename T>
struct CellBlend
{
  CellSamples<T> First;
  CellSamples<T> Second;
  double Fraction;
};

template <typename T>
VOLUME_HAPTICS_INLINE CellSamples<T> ReadSamples(const FieldView& view, const CellPlace& place)
{
  const std::int64_t* const stride = view.Volume.Stride;
  return { static_cast<const T*>(view.Volume.Data) + place.X.Cell * stride[0] +
      place.Y.Cell * stride[1] + place.Z.Cell * stride[2],
    stride };
}

template <typename T>
VOLUME_HAPTICS_INLINE CellBlend<T> ReadSamples(const TimeStepBlend& blend, const CellPlace& place)
{
  return { ReadSamples<T>(blend.First, place), ReadSamples<T>(blend.Second, place),
    blend.Fraction };
}

///@{
/** Returns the four samples of the first plane (0) or of the second one (1), line by line. */
template <typename T>
VOLUME_HAPTICS_INLINE Double4 LoadPlane(const CellSamples<T>& cell, int plane)
{
  const std::int64_t sx = cell.Stride[0];
  const std::int64_t sy = cell.Stride[1];
  const T* const q = cell.First + plane * cell.Stride[2];
  if (sx == 1)
  {
    return LoadPairs(q, q + sy);
  }
  const T taps[4] = { q[0], q[sx], q[sy], q[sy + sx] };
  return LoadDouble4(taps);
}
template <typename T>
VOLUME_HAPTICS_INLINE Double4 LoadPlane(const CellBlend<T>& cell, int plane)
{
  const Double4 first = LoadPlane(cell.First, plane);
  return first + cell.Fraction * (LoadPlane(cell.Second, plane) - first);
}
///@}

///@{
/** Returns sample i of a cell. The bits of i are the sample's indices along x, y and z. */
template <typename T>
VOLUME_HAPTICS_INLINE double LoadSample(const CellSamples<T>& cell, int i)
{
  return static_cast<double>(cell.First[(i & 1) * cell.Stride[0] + ((i >> 1) & 1) * cell.Stride[1] +
    (i >> 2) * cell.Stride[2]]);
}
template <typename T>
VOLUME_HAPTICS_INLINE double LoadSample(const CellBlend<T>& cell, int i)
{
  const double first = LoadSample(cell.First, i);
  return first + cell.Fraction * (LoadSample(cell.Second, i) - first);
}
///@}

/**
 * Interpolates between the two planes of a cell along z. Returns the plane's four values, line by
 * line.
 */
template <typename Cell>
VOLUME_HAPTICS_INLINE Double4 BlendPlanes(const Cell& cell, const CellPlace& place)
{
  const Double4 near = LoadPlane(cell, 0);
  return near + place.Z.Fraction * (LoadPlane(cell, 1) - near);
}

/**
 * Returns the trilinear value. Skips samples with the weight 0, because they may be NaN.
 */
template <typename Cell>
VOLUME_HAPTICS_INLINE double SumNumbers(const Cell& cell, const CellPlace& place)
{
  const auto& [ax, ay, az] = place;
  const double wx[2] = { 1.0 - ax.Fraction, ax.Fraction };
  const double wy[2] = { 1.0 - ay.Fraction, ay.Fraction };
  const double wz[2] = { 1.0 - az.Fraction, az.Fraction };
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const double weight = wx[i & 1] * wy[(i >> 1) & 1] * wz[i >> 2];
    sum += weight == 0.0 ? 0.0 : weight * LoadSample(cell, i);
  }
  return sum;
}

template <typename T, typename Cell>
VOLUME_HAPTICS_INLINE double CheckNumber(double value, const Cell& cell, const CellPlace& place)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    if (!IsNumber(value))
    {
      return SumNumbers(cell, place);
    }
  }
  return value;
}

/** Returns the trilinear value from all eight samples, none of which may be NaN. */
template <typename Cell>
VOLUME_HAPTICS_INLINE double BlendCell(const Cell& cell, const CellPlace& place)
{
  const Double4 lines = BlendPlanes(cell, place);
  const double a = lines[0] + place.Y.Fraction * (lines[2] - lines[0]);
  const double b = lines[1] + place.Y.Fraction * (lines[3] - lines[1]);
  return a + place.X.Fraction * (b - a);
}

/** Computes two values at once. Each equals BlendCell's value to the bit. */
template <typename Cell>
VOLUME_HAPTICS_INLINE ValuePair BlendCells(
  const Cell& ahead, const CellPlace& there, const Cell& behind, const CellPlace& here)
{
  const Double4 a = BlendPlanes(ahead, there);
  const Double4 b = BlendPlanes(behind, here);
  const Double4 first = JoinLow(a, b);
  const Double4 y{ there.Y.Fraction, there.Y.Fraction, here.Y.Fraction, here.Y.Fraction };
  const Double4 ends = first + y * (JoinHigh(a, b) - first);
  return { ends[0] + there.X.Fraction * (ends[1] - ends[0]),
    ends[2] + here.X.Fraction * (ends[3] - ends[2]) };
}

///@{
/** Returns the trilinear value in samples, or in a blend. */
template <typename T, typename Cell>
VOLUME_HAPTICS_INLINE double Interpolate(const Cell& cell, const CellPlace& place)
{
  return CheckNumber<T>(BlendCell(cell, place), cell, place);
}
template <typename T, typename Cell>
VOLUME_HAPTICS_INLINE ValuePair Interpolate(
  const Cell& ahead, const CellPlace& there, const Cell& behind, const CellPlace& here)
{
  const ValuePair pair = BlendCells(ahead, there, behind, here);
  return { CheckNumber<T>(pair.Ahead, ahead, there), CheckNumber<T>(pair.Behind, behind, here) };
}
///@}

template <typename T>
VOLUME_HAPTICS_INLINE double Trilinear(const FieldView& view, double x, double y, double z)
{
  const CellPlace place = LocateCell(view, x, y, z);
  return Interpolate<T>(ReadSamples<T>(view, place), place);
}

template <typename T>
VOLUME_HAPTICS_INLINE double Trilinear(const TimeStepBlend& blend, double x, double y, double z)
{
  const CellPlace place = LocateCell(blend.First, x, y, z);
  return Interpolate<T>(ReadSamples<T>(blend, place), place);
}

///@{
/** Returns the view that has the geometry of all time steps. */
VOLUME_HAPTICS_INLINE const FieldView& GetGeometry(const FieldView& view)
{
  return view;
}
VOLUME_HAPTICS_INLINE const FieldView& GetGeometry(const TimeStepBlend& blend)
{
  return blend.First;
}
///@}

/** Returns the trilinear value in a field, or in a blend of two fields. */
template <typename T, typename Source>
double TrilinearValue(const Source& from, double x, double y, double z) noexcept
{
  return Trilinear<T>(from, x, y, z);
}

template <typename T>
FractionPair SharedTrilinearValues(
  const TimeStepBlend& blend, double share, double x, double y, double z) noexcept
{
  const CellPlace place = LocateCell(blend.First, x, y, z);
  CellBlend<T> cell = ReadSamples<T>(blend, place);
  FractionPair pair;
  pair.First = Interpolate<T>(cell, place);
  cell.Fraction = share;
  pair.Second = Interpolate<T>(cell, place);
  return pair;
}

template <typename T, typename Source>
ValuePair TrilinearPair(
  const Source& from, double x, double y, double z, double dx, double dy, double dz) noexcept
{
  const FieldView& view = GetGeometry(from);
  const CellPlace ahead = LocateCell(view, x + dx, y + dy, z + dz);
  const CellPlace behind = LocateCell(view, x - dx, y - dy, z - dz);
  return Interpolate<T>(ReadSamples<T>(from, ahead), ahead, ReadSamples<T>(from, behind), behind);
}

template <typename T, typename Source>
VOLUME_HAPTICS_INLINE FieldSample ComputeDifference(
  const Source& from, int radius, double x, double y, double z)
{
  const double r = radius;
  const double scale = 0.5 / r;
  const double x0 = Trilinear<T>(from, x - r, y, z);
  const double x1 = Trilinear<T>(from, x + r, y, z);
  const double y0 = Trilinear<T>(from, x, y - r, z);
  const double y1 = Trilinear<T>(from, x, y + r, z);
  const double z0 = Trilinear<T>(from, x, y, z - r);
  const double z1 = Trilinear<T>(from, x, y, z + r);
  return { (x0 + x1 + y0 + y1 + z0 + z1) / 6.0,
    Vector3{ scale * (x1 - x0), scale * (y1 - y0), scale * (z1 - z0) } };
}

template <typename T>
FieldSample CentralDifference(const FieldView& view, double x, double y, double z) noexcept
{
  return ComputeDifference<T>(view, view.Kernel.Radius, x, y, z);
}

template <typename T>
FieldSample BlendedDifference(
  const TimeStepBlend& blend, double x, double y, double z, const BlendMemories&) noexcept
{
  return ComputeDifference<T>(blend, blend.First.Kernel.Radius, x, y, z);
}

} // namespace
} // namespace VolumeHaptics

#endif
