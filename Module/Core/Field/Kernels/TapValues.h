// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Trilinear values of two time steps, blended. They are computed from the samples that the last
 * gradient has stored in a memory, because a proxy hardly needs samples beyond the gradient's taps.
 * The values equal those read from the time steps, to the bit. If the memory lacks samples, the
 * result is NaN. The rules in FieldKernels.h also apply here.
 */
#ifndef TapValues_h
#define TapValues_h

#include "Core/Field/Kernels/LinearKernels.h"

#include <limits>

namespace VolumeHaptics
{
namespace
{

constexpr double NoTapValue = std::numeric_limits<double>::quiet_NaN();

/**
 * Pointers to the samples of a cell in a TimeStepTaps, and the fraction by which both time steps
 * are blended there.
 */
template <int N>
struct TapCell
{
  static constexpr int Line = TimeStepTaps::Line<N>;

  const double* Taps;
  const double* Changes;
  double Fraction;
};

template <int N>
VOLUME_HAPTICS_INLINE Double4 LoadPlane(const TapCell<N>& cell, int plane)
{
  constexpr int line = TapCell<N>::Line;
  const int at = plane * N * line;
  return LoadHalves(cell.Taps + at, cell.Taps + at + line) +
    cell.Fraction * LoadHalves(cell.Changes + at, cell.Changes + at + line);
}

/** Looks for a cell in a memory. Returns false if the memory lacks some of the cell's samples. */
template <int N>
VOLUME_HAPTICS_INLINE bool ReadCell(
  const TimeStepTaps& memory, const CellPlace& place, double fraction, TapCell<N>& cell)
{
  // Negative numbers become large when converted to unsigned, so that one comparison checks both
  // ends.
  const auto i = static_cast<std::uint64_t>(place.X.Cell - memory.First[0]);
  const auto j = static_cast<std::uint64_t>(place.Y.Cell - memory.First[1]);
  const auto k = static_cast<std::uint64_t>(place.Z.Cell - memory.First[2]);
  constexpr std::uint64_t cells = N - 1;
  if (!(i < cells && j < cells && k < cells))
  {
    return false;
  }
  const std::uint64_t at = (k * N + j) * TapCell<N>::Line + i;
  cell = { memory.Taps + at, memory.Changes + at, fraction };
  return true;
}

template <int N>
double TapValue(const TimeStepTaps& memory, const FieldView& view, double fraction, double x,
  double y, double z) noexcept
{
  const CellPlace place = LocateCell(view, x, y, z);
  TapCell<N> cell;
  return ReadCell<N>(memory, place, fraction, cell) ? BlendCell(cell, place) : NoTapValue;
}

template <int N>
FractionPair SharedTapValues(const TimeStepTaps& memory, const FieldView& view,
  const FractionPair& fractions, double x, double y, double z) noexcept
{
  const CellPlace place = LocateCell(view, x, y, z);
  TapCell<N> cell;
  FractionPair pair{ NoTapValue, NoTapValue };
  if (ReadCell<N>(memory, place, fractions.First, cell))
  {
    pair.First = BlendCell(cell, place);
    cell.Fraction = fractions.Second;
    pair.Second = BlendCell(cell, place);
  }
  return pair;
}

template <int N>
ValuePair TapPair(const TimeStepTaps& memory, const FieldView& view, double fraction, double x,
  double y, double z, double dx, double dy, double dz) noexcept
{
  const CellPlace there = LocateCell(view, x + dx, y + dy, z + dz);
  const CellPlace here = LocateCell(view, x - dx, y - dy, z - dz);
  TapCell<N> ahead;
  TapCell<N> behind;
  return ReadCell<N>(memory, there, fraction, ahead) && ReadCell<N>(memory, here, fraction, behind)
    ? BlendCells(ahead, there, behind, here)
    : ValuePair{ NoTapValue, NoTapValue };
}

} // namespace
} // namespace VolumeHaptics

#endif
