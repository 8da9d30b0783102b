// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sum over N^3 taps of two time steps, blended:
 *
 *   V_i = a_i + share (b_i - a_i)
 *
 * A sample that is equal in both time steps keeps its value to the bit. The rules in FieldKernels.h
 * also apply here.
 */
#ifndef BlendedSum_h
#define BlendedSum_h

#include "Core/Field/Kernels/SeparableSum.h"

namespace VolumeHaptics
{
namespace
{

/** Blends the rows of another time step into `rows`. */
template <int N>
VOLUME_HAPTICS_INLINE void BlendRows(const RowPair<N>& other, double fraction, RowPair<N>& rows)
{
  for (int p = 0; p < RowPair<N>::Whole; ++p)
  {
    rows.Even[p] = rows.Even[p] + fraction * (other.Even[p] - rows.Even[p]);
    rows.Odd[p] = rows.Odd[p] + fraction * (other.Odd[p] - rows.Odd[p]);
  }
  if constexpr (RowPair<N>::HasRest)
  {
    rows.Rest = rows.Rest + fraction * (other.Rest - rows.Rest);
  }
}

template <int N>
VOLUME_HAPTICS_INLINE void SubtractRows(const RowPair<N>& of, RowPair<N>& rows)
{
  for (int p = 0; p < RowPair<N>::Whole; ++p)
  {
    rows.Even[p] = rows.Even[p] - of.Even[p];
    rows.Odd[p] = rows.Odd[p] - of.Odd[p];
  }
  if constexpr (RowPair<N>::HasRest)
  {
    rows.Rest = rows.Rest - of.Rest;
  }
}

///@{
/**
 * Store two rows in the layout of TimeStepTaps, and load the rows of both time steps, blended like
 * BlendRows().
 */
template <int N>
VOLUME_HAPTICS_INLINE void StoreLines(const RowPair<N>& rows, double* to)
{
  constexpr int line = TimeStepTaps::Line<N>;
  constexpr int whole = RowPair<N>::Whole;
  for (int p = 0; p < whole; ++p)
  {
    StoreDouble4(rows.Even[p], to + 4 * p);
    StoreDouble4(rows.Odd[p], to + line + 4 * p);
  }
  if constexpr (RowPair<N>::HasRest)
  {
    StoreHalves(rows.Rest, to + 4 * whole, to + line + 4 * whole);
  }
}
template <int N>
VOLUME_HAPTICS_INLINE void LoadBlendedLines(
  const TimeStepTaps& timeSteps, int at, double fraction, RowPair<N>& rows)
{
  constexpr int line = TimeStepTaps::Line<N>;
  constexpr int whole = RowPair<N>::Whole;
  const double* const taps = timeSteps.Taps + at;
  const double* const changes = timeSteps.Changes + at;
  const auto blend = [=](int place)
  { return LoadDouble4(taps + place) + fraction * LoadDouble4(changes + place); };
  for (int p = 0; p < whole; ++p)
  {
    rows.Even[p] = blend(4 * p);
    rows.Odd[p] = blend(line + 4 * p);
  }
  if constexpr (RowPair<N>::HasRest)
  {
    const int rest = 4 * whole;
    rows.Rest = LoadHalves(taps + rest, taps + line + rest) +
      fraction * LoadHalves(changes + rest, changes + line + rest);
  }
}
///@}

/** N^3 samples of a time step, consecutive along x. */
template <typename T>
struct TapBlock
{
  const T* Corner;
  std::int64_t Line;
  std::int64_t Plane;
};

template <typename T, int N>
VOLUME_HAPTICS_INLINE void LoadRows(const TapBlock<T>& block, int k, int j, RowPair<N>& rows)
{
  const T* const even = block.Corner + k * block.Plane + j * block.Line;
  LoadRows<T, N>(even, even + block.Line, rows);
}

template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_INLINE double SumBlend(const TapBlock<T>& first, const TapBlock<T>& second,
  double fraction, const Footprint<N>& foot, Vector3* gradient)
{
  return SumPlanes<N, WithGradient>(
    [&](int k, int j, RowPair<N>& rows)
    {
      RowPair<N> other;
      LoadRows<T, N>(first, k, j, rows);
      LoadRows<T, N>(second, k, j, other);
      BlendRows<N>(other, fraction, rows);
    },
    foot, gradient);
}

/** Computes the sum from copies of the taps (CopyTaps()). */
template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_OUTLINE double SumBlendOfCopies(
  const TimeStepBlend& blend, const Footprint<N>& foot, Vector3* gradient)
{
  T blocks[2][N * N * N];
  CopyTaps<T, N>(blend.First.Volume, foot, blocks[0]);
  CopyTaps<T, N>(blend.Second.Volume, foot, blocks[1]);
  return SumBlend<T, N, WithGradient>(
    { blocks[0], N, N * N }, { blocks[1], N, N * N }, blend.Fraction, foot, gradient);
}

/** Computes the sum without a memory. */
template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_OUTLINE double SumBlendOfSamples(
  const TimeStepBlend& blend, const Footprint<N>& foot, Vector3* gradient)
{
  const VolumeView& a = blend.First.Volume;
  const VolumeView& b = blend.Second.Volume;
  const T* const first = GetCorner<T, N>(a, foot.First);
  const T* const second = GetCorner<T, N>(b, foot.First);
  if (first && second)
  {
    if constexpr (N > 4)
    {
      PrefetchRows(first, N, a.Stride[1], a.Stride[2]);
      PrefetchRows(second, N, b.Stride[1], b.Stride[2]);
    }
    const double value = SumBlend<T, N, WithGradient>({ first, a.Stride[1], a.Stride[2] },
      { second, b.Stride[1], b.Stride[2] }, blend.Fraction, foot, gradient);
    if (!std::is_floating_point_v<T> || IsNumber(value))
    {
      return value;
    }
  }
  return SumBlendOfCopies<T, N, WithGradient>(blend, foot, gradient);
}

/** Returns whether a memory has the samples of a blend whose first tap is at `first`. */
VOLUME_HAPTICS_INLINE bool HoldsTimeSteps(
  const TimeStepTaps& memory, const TimeStepBlend& blend, const std::int64_t* first)
{
  return memory.Field == blend.First.Number && memory.SecondField == blend.Second.Number &&
    memory.First[0] == first[0] && memory.First[1] == first[1] && memory.First[2] == first[2];
}

/**
 * Reads the N^3 taps of both time steps, beginning with the tap at `first`. Returns false if some
 * taps are outside the samples.
 */
template <typename T, int N>
VOLUME_HAPTICS_OUTLINE bool FillTimeSteps(
  const TimeStepBlend& blend, const std::int64_t* first, TimeStepTaps& memory)
{
  constexpr int line = TimeStepTaps::Line<N>;
  const VolumeView& a = blend.First.Volume;
  const VolumeView& b = blend.Second.Volume;
  const TapBlock<T> near{ GetCorner<T, N>(a, first), a.Stride[1], a.Stride[2] };
  const TapBlock<T> next{ GetCorner<T, N>(b, first), b.Stride[1], b.Stride[2] };
  memory.Field = 0;
  if (!near.Corner || !next.Corner)
  {
    return false;
  }
  PrefetchRows(near.Corner, N, near.Line, near.Plane);
  PrefetchRows(next.Corner, N, next.Line, next.Plane);
  for (int k = 0; k < N; ++k)
  {
    for (int j = 0; j < N; j += 2)
    {
      RowPair<N> rows;
      RowPair<N> changes;
      LoadRows<T, N>(near, k, j, rows);
      LoadRows<T, N>(next, k, j, changes);
      SubtractRows<N>(rows, changes);
      const int at = (k * N + j) * line;
      StoreLines<N>(rows, memory.Taps + at);
      StoreLines<N>(changes, memory.Changes + at);
    }
  }
  memory.Field = blend.First.Number;
  memory.SecondField = blend.Second.Number;
  for (int axis = 0; axis < 3; ++axis)
  {
    memory.First[axis] = first[axis];
  }
  return true;
}

/** Returns the memory that has this blend, or null if there is none. */
VOLUME_HAPTICS_INLINE const BlendMemory* FindBlend(
  const TimeStepBlend& blend, const std::int64_t* first, const TickMemory& tick)
{
  for (const BlendMemory& memory : tick.Blends)
  {
    if (memory.Fraction == blend.Fraction && HoldsTaps(memory, blend.First.Number, first) &&
      memory.SecondField == blend.Second.Number)
    {
      return &memory;
    }
  }
  return nullptr;
}

/** Prepares the older of the two memories for a blend, and returns it. */
VOLUME_HAPTICS_INLINE BlendMemory& BeginBlend(
  const TimeStepBlend& blend, const std::int64_t* first, TickMemory& tick)
{
  BlendMemory& memory = tick.Blends[tick.OldBlend];
  tick.OldBlend = 1 - tick.OldBlend;
  SetPlace(blend.First.Number, first, memory);
  memory.SecondField = blend.Second.Number;
  memory.Fraction = blend.Fraction;
  return memory;
}

/**
 * Computes the gradient from the memory of the blend, or from the memory of both time steps. In the
 * second case, also stores the blend.
 */
template <typename T, int N>
VOLUME_HAPTICS_INLINE bool SumRememberedBlend(
  const TimeStepBlend& blend, const Footprint<N>& foot, TickMemory& tick, FieldSample& sample)
{
  if (const BlendMemory* const known = FindBlend(blend, foot.First, tick))
  {
    sample.Value = SumTaps<N>(known->Taps, foot, &sample.Gradient);
    return IsNumber(sample.Value);
  }
  const TimeStepTaps& timeSteps = tick.Pair;
  if (!HoldsTimeSteps(timeSteps, blend, foot.First) &&
    !FillTimeSteps<T, N>(blend, foot.First, tick.Pair))
  {
    return false;
  }
  BlendMemory& kept = BeginBlend(blend, foot.First, tick);
  const double fraction = blend.Fraction;
  sample.Value = SumTwice<N>(
    [&timeSteps, &kept, fraction](int k, int pair, RowPair<N>& rows)
    {
      const int line = k * N + 2 * pair;
      LoadBlendedLines<N>(timeSteps, line * TimeStepTaps::Line<N>, fraction, rows);
      StoreRows<N>(rows, kept.Taps + line * N);
    },
    kept.Taps, foot, &sample.Gradient);
  return IsNumber(sample.Value);
}

/** Computes the gradient of a blend. */
template <typename T, int N>
VOLUME_HAPTICS_INLINE FieldSample SumBlendedGradient(
  const TimeStepBlend& blend, const Footprint<N>& foot, const BlendMemories& memories)
{
  FieldSample sample;
  if constexpr (N <= TapMemory::MostTaps)
  {
    if (memories.Tick && SumRememberedBlend<T, N>(blend, foot, *memories.Tick, sample))
    {
      return sample;
    }
  }
  sample.Value = SumBlendOfSamples<T, N, true>(blend, foot, &sample.Gradient);
  return sample;
}

} // namespace
} // namespace VolumeHaptics

#endif
