// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the cells and reads the samples of four points at a time, in the lanes of vectors. The
 * rules of FieldKernels.h hold here, too.
 */
#ifndef FourCells_h
#define FourCells_h

#include "Core/Field/Kernels/LinearKernels.h"
#include "Core/Tools/PointShell/ShellReader.h"

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{
namespace
{

struct FourVectors
{
  Double4 X;
  Double4 Y;
  Double4 Z;
};
VOLUME_HAPTICS_INLINE FourVectors LoadVectors(const double (*from)[ShellBatch::Most], std::size_t i)
{
  return { LoadDouble4(from[0] + i), LoadDouble4(from[1] + i), LoadDouble4(from[2] + i) };
}
VOLUME_HAPTICS_INLINE void StoreVectors(
  const FourVectors& v, double (*to)[ShellBatch::Most], std::size_t i)
{
  StoreDouble4(v.X, to[0] + i);
  StoreDouble4(v.Y, to[1] + i);
  StoreDouble4(v.Z, to[2] + i);
}
VOLUME_HAPTICS_INLINE FourVectors Scaled(const Double4& s, const FourVectors& v)
{
  return { s * v.X, s * v.Y, s * v.Z };
}
VOLUME_HAPTICS_INLINE Double4 DotOf(const FourVectors& a, const FourVectors& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
/** Multiplies a matrix, stored by rows, with four vectors. */
VOLUME_HAPTICS_INLINE FourVectors Times(const double* m, const FourVectors& v)
{
  return { m[0] * v.X + m[1] * v.Y + m[2] * v.Z, m[3] * v.X + m[4] * v.Y + m[5] * v.Z,
    m[6] * v.X + m[7] * v.Y + m[8] * v.Z };
}

/**
 * The cells of four points along an axis, and the points' positions in them, computed as by
 * LocateCell().
 */
struct FourPlaces
{
  Double4 Cell;
  Double4 Fraction;
};
VOLUME_HAPTICS_INLINE FourPlaces LocateCells(const Double4& position, double first, double last)
{
  const Double4 inside = Smaller(Larger(position, Spread(first)), Spread(last));
  // Both operands are whole numbers, and the smaller one is at most the last cell.
  const Double4 cell = Smaller(Floor(inside), Spread(last - 1.0));
  return { cell, inside - cell };
}

/**
 * Loads a pair of neighbours along x for each of four points. Each pair begins `distance` elements
 * after the point's sample. `first` receives the first neighbours, and `second` the second ones. If
 * IsRow, samples along x are adjacent in memory, and sx is not used.
 */
template <bool IsRow, typename T>
VOLUME_HAPTICS_INLINE void LoadFourPairs(
  const T* const* samples, std::int64_t distance, std::int64_t sx, Double4& first, Double4& second)
{
  if constexpr (IsRow)
  {
    LoadFourPairs(samples[0] + distance, samples[1] + distance, samples[2] + distance,
      samples[3] + distance, first, second);
  }
  else
  {
    const auto load = [samples](std::int64_t i)
    {
      return MakeDouble4(static_cast<double>(samples[0][i]), static_cast<double>(samples[1][i]),
        static_cast<double>(samples[2][i]), static_cast<double>(samples[3][i]));
    };
    first = load(distance);
    second = load(distance + sx);
  }
}

/** The cells of four positions. */
template <typename T>
struct FourCells
{
  FourPlaces X;
  FourPlaces Y;
  FourPlaces Z;
  std::int64_t Step; ///< number of elements between samples along x
  const T* First[4]; ///< first sample of each cell
};
template <typename T>
VOLUME_HAPTICS_INLINE FourCells<T> ComputeCells(
  const FieldView& view, const Double4& x, const Double4& y, const Double4& z)
{
  const std::int64_t* const stride = view.Volume.Stride;
  FourCells<T> at{ LocateCells(x, view.First[0], view.Last[0]),
    LocateCells(y, view.First[1], view.Last[1]), LocateCells(z, view.First[2], view.Last[2]),
    stride[0], {} };
  // The products are exact, because no volume has 2^51 samples.
  const Double4 number = static_cast<double>(stride[0]) * at.X.Cell +
    static_cast<double>(stride[1]) * at.Y.Cell + static_cast<double>(stride[2]) * at.Z.Cell;
  std::int64_t numbers[4];
  StoreWhole(number, numbers);
  for (int lane = 0; lane < 4; ++lane)
  {
    at.First[lane] = static_cast<const T*>(view.Volume.Data) + numbers[lane];
  }
  return at;
}

/**
 * Loads a pair of neighbours along x for each cell. Each pair begins `distance` elements after the
 * cell's first sample.
 */
template <bool IsRow, typename T>
VOLUME_HAPTICS_INLINE void LoadFourPairs(
  const FourCells<T>& at, std::int64_t distance, Double4& first, Double4& second)
{
  LoadFourPairs<IsRow>(at.First, distance, at.Step, first, second);
}

/** Returns whether samples along x are adjacent in memory. */
VOLUME_HAPTICS_INLINE bool HasRows(const FieldView& view)
{
  return view.Volume.Stride[0] == 1;
}

} // namespace
} // namespace VolumeHaptics

#endif
