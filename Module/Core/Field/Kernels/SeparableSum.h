// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sum over N^3 taps of a separable kernel. The rules in FieldKernels.h also apply here.
 */
#ifndef SeparableSum_h
#define SeparableSum_h

#include "Core/Field/FieldSampler.h"
#include "Core/Math/Double4.h"

#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** The weights of N taps along each axis, and the indices of the first taps. */
template <int N>
struct Footprint
{
  /** N weights for smoothing, then N weights for the derivative. */
  alignas(32) double Weights[3][2 * N];
  std::int64_t First[3];
};

/**
 * Two rows of N samples (N even) in vectors of four. If N is not a multiple of four, Rest has the
 * last two samples of Even, followed by those of Odd. RowSum::Rest has separate sums for these two
 * rows.
 */
template <int N>
struct RowPair
{
  static constexpr int Whole = N / 4;
  static constexpr bool HasRest = N % 4 != 0;
  Double4 Even[Whole];
  Double4 Odd[Whole];
  Double4 Rest;
};

template <int N>
struct RowSum
{
  Double4 Whole[N / 4] = {};
  Double4 Rest = {};
};

template <typename T, int N>
VOLUME_HAPTICS_INLINE void LoadRows(const T* even, const T* odd, RowPair<N>& rows)
{
  constexpr int whole = RowPair<N>::Whole;
  for (int p = 0; p < whole; ++p)
  {
    rows.Even[p] = LoadDouble4(even + 4 * p);
    rows.Odd[p] = LoadDouble4(odd + 4 * p);
  }
  if constexpr (RowPair<N>::HasRest)
  {
    rows.Rest = LoadPairs(even + 4 * whole, odd + 4 * whole);
  }
}

///@{
/**
 * Store two rows as numbers, and load them again. They copy vectors of four, because the compiler
 * would split up a copy of the whole structure.
 */
template <int N>
VOLUME_HAPTICS_INLINE void StoreRows(const RowPair<N>& rows, double* to)
{
  constexpr int whole = RowPair<N>::Whole;
  for (int p = 0; p < whole; ++p)
  {
    StoreDouble4(rows.Even[p], to + 4 * p);
    StoreDouble4(rows.Odd[p], to + 4 * (whole + p));
  }
  if constexpr (RowPair<N>::HasRest)
  {
    StoreDouble4(rows.Rest, to + 8 * whole);
  }
}
template <int N>
VOLUME_HAPTICS_INLINE void LoadStoredRows(const double* from, RowPair<N>& rows)
{
  constexpr int whole = RowPair<N>::Whole;
  for (int p = 0; p < whole; ++p)
  {
    rows.Even[p] = LoadDouble4(from + 4 * p);
    rows.Odd[p] = LoadDouble4(from + 4 * (whole + p));
  }
  if constexpr (RowPair<N>::HasRest)
  {
    rows.Rest = LoadDouble4(from + 8 * whole);
  }
}
///@}

/** Computes sum += weights[0] * even row + weights[1] * odd row. */
template <int N>
VOLUME_HAPTICS_INLINE void AddRows(
  const RowPair<N>& rows, const double* weights, bool isFirst, RowSum<N>& sum)
{
  const Double4 even = Spread(weights);
  const Double4 odd = Spread(weights + 1);
  for (int p = 0; p < RowPair<N>::Whole; ++p)
  {
    const Double4 both = even * rows.Even[p] + odd * rows.Odd[p];
    sum.Whole[p] = isFirst ? both : sum.Whole[p] + both;
  }
  if constexpr (RowPair<N>::HasRest)
  {
    const Double4 each = JoinHalves(even, odd);
    sum.Rest = isFirst ? each * rows.Rest : sum.Rest + each * rows.Rest;
  }
}

/** Computes sum += *weight * other. */
template <int N>
VOLUME_HAPTICS_INLINE void AddScaled(const RowSum<N>& other, const double* weight, RowSum<N>& sum)
{
  const Double4 all = Spread(weight);
  for (int p = 0; p < RowPair<N>::Whole; ++p)
  {
    sum.Whole[p] = sum.Whole[p] + all * other.Whole[p];
  }
  if constexpr (RowPair<N>::HasRest)
  {
    sum.Rest = sum.Rest + all * other.Rest;
  }
}

/** Multiplies a row by the weights along x. Returns four sums, which AddLanes() adds up. */
template <int N>
VOLUME_HAPTICS_INLINE Double4 WeighRow(const RowSum<N>& sum, const double* weights)
{
  Double4 products = sum.Whole[0] * LoadDouble4(weights);
  for (int p = 1; p < RowPair<N>::Whole; ++p)
  {
    products = products + sum.Whole[p] * LoadDouble4(weights + 4 * p);
  }
  if constexpr (RowPair<N>::HasRest)
  {
    const double a = weights[N - 2];
    const double b = weights[N - 1];
    products = products + sum.Rest * Double4{ a, b, a, b };
  }
  return products;
}

/**
 * Computes value and gradient from three sums over y and z: of the values, and of the slopes along
 * y and along z.
 */
template <int N>
VOLUME_HAPTICS_INLINE double WeighSums(const RowSum<N>& sum, const RowSum<N>& sumY,
  const RowSum<N>& sumZ, const double* weights, Vector3* gradient)
{
  double sums[4];
  AddLanes(WeighRow<N>(sum, weights), WeighRow<N>(sum, weights + N), WeighRow<N>(sumY, weights),
    WeighRow<N>(sumZ, weights), sums);
  gradient->X = sums[1];
  gradient->Y = sums[2];
  gradient->Z = sums[3];
  return sums[0];
}

/**
 * Computes the sum over N^3 taps and, if WithGradient, the gradient. `load` loads the rows j and j
 * + 1 of plane k. Rows are along x. They are first combined over y and z in vectors of four; the
 * weights along x come last.
 */
template <int N, bool WithGradient, typename LoadFunction>
VOLUME_HAPTICS_INLINE double SumPlanes(
  const LoadFunction& load, const Footprint<N>& foot, Vector3* gradient)
{
  RowSum<N> sum;
  RowSum<N> sumY;
  RowSum<N> sumZ;
  for (int k = 0; k < N; ++k)
  {
    RowSum<N> smooth;
    RowSum<N> slope;
#pragma GCC unroll 8
    for (int j = 0; j < N; j += 2)
    {
      RowPair<N> rows;
      load(k, j, rows);
      AddRows<N>(rows, foot.Weights[1] + j, j == 0, smooth);
      if constexpr (WithGradient)
      {
        AddRows<N>(rows, foot.Weights[1] + N + j, j == 0, slope);
      }
    }
    AddScaled<N>(smooth, foot.Weights[2] + k, sum);
    if constexpr (WithGradient)
    {
      AddScaled<N>(slope, foot.Weights[2] + k, sumY);
      AddScaled<N>(smooth, foot.Weights[2] + N + k, sumZ);
    }
  }
  if constexpr (WithGradient)
  {
    return WeighSums<N>(sum, sumY, sumZ, foot.Weights[0], gradient);
  }
  return AddLanes(WeighRow<N>(sum, foot.Weights[0]));
}

/** Computes the sum over N^3 taps. `corner` is the first tap. */
template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_INLINE double SumBlock(const T* corner, std::int64_t line, std::int64_t plane,
  const Footprint<N>& foot, Vector3* gradient)
{
  return SumPlanes<N, WithGradient>(
    [=](int k, int j, RowPair<N>& rows)
    {
      const T* const even = corner + k * plane + j * line;
      LoadRows<T, N>(even, even + line, rows);
    },
    foot, gradient);
}

/**
 * Returns the offset of a tap along an axis. Taps outside the resident samples repeat the nearest
 * sample.
 */
VOLUME_HAPTICS_INLINE std::int64_t ClampedOffset(const VolumeView& view, int axis, std::int64_t tap)
{
  // VolumeView's own functions must not be called here: see FieldKernels.h.
  const std::int64_t least = view.First[axis];
  const std::int64_t last = least + view.Dimensions[axis] - 1;
  return (tap < least ? least : (tap < last ? tap : last)) * view.Stride[axis];
}

/**
 * Copies the taps where the sum can't read the samples themselves: at the border, where taps
 * outside repeat the last sample; if other components are between the samples; and around samples
 * that are not numbers, which must not count if their weight is 0.
 */
template <typename T, int N>
VOLUME_HAPTICS_INLINE void CopyTaps(const VolumeView& view, const Footprint<N>& foot, T* to)
{
  std::int64_t offset[3][N];
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i < N; ++i)
    {
      offset[a][i] = ClampedOffset(view, a, foot.First[a] + i);
    }
  }
  for (int k = 0; k < N; ++k)
  {
    for (int j = 0; j < N; ++j)
    {
      const T* const from = static_cast<const T*>(view.Data) + offset[2][k] + offset[1][j];
      const bool counts = foot.Weights[2][k] != 0.0 && foot.Weights[1][j] != 0.0;
      for (int i = 0; i < N; ++i)
      {
        *to++ = counts && foot.Weights[0][i] != 0.0 ? from[offset[0][i]] : T(0);
      }
    }
  }
}

template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_OUTLINE double SumCopy(
  const VolumeView& view, const Footprint<N>& foot, Vector3* gradient)
{
  T block[N * N * N];
  CopyTaps<T, N>(view, foot, block);
  return SumBlock<T, N, WithGradient>(block, N, N * N, foot, gradient);
}

/** Prefetches all rows at once, because the processor by itself prefetches only a few rows. */
template <typename T>
VOLUME_HAPTICS_INLINE void PrefetchRows(
  const T* corner, int count, std::int64_t line, std::int64_t plane)
{
  for (int k = 0; k < count; ++k)
  {
    for (int j = 0; j < count; ++j)
    {
      VOLUME_HAPTICS_PREFETCH(corner + k * plane + j * line);
    }
  }
}

/**
 * Returns the first of N^3 samples if they are consecutive along x and all resident, otherwise
 * null.
 */
template <typename T, int N>
VOLUME_HAPTICS_INLINE const T* GetCorner(const VolumeView& view, const std::int64_t* first)
{
  const std::int64_t* const n = view.Dimensions;
  const std::int64_t* const stride = view.Stride;
  const auto fits = [&](int a)
  { return first[a] >= view.First[a] && first[a] + N <= view.First[a] + n[a]; };
  return stride[0] == 1 && fits(0) && fits(1) && fits(2)
    ? static_cast<const T*>(view.Data) + first[0] + first[1] * stride[1] + first[2] * stride[2]
    : nullptr;
}

template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_INLINE double Separable(
  const VolumeView& view, const Footprint<N>& foot, Vector3* gradient)
{
  const std::int64_t line = view.Stride[1];
  const std::int64_t plane = view.Stride[2];
  if (const T* const corner = GetCorner<T, N>(view, foot.First))
  {
    if constexpr (N > 4)
    {
      PrefetchRows(corner, N, line, plane);
    }
    const double value = SumBlock<T, N, WithGradient>(corner, line, plane, foot, gradient);
    if (!std::is_floating_point_v<T> || IsNumber(value))
    {
      return value;
    }
  }
  return SumCopy<T, N, WithGradient>(view, foot, gradient);
}

/**
 * Writes the N^3 taps to a memory, beginning with the tap at `first`. Returns false if some taps
 * are outside the samples.
 */
template <typename T, int N>
bool FillTaps(const VolumeView& view, const std::int64_t* first, TapMemory& memory) noexcept
{
  const T* const corner = GetCorner<T, N>(view, first);
  if (!corner)
  {
    return false;
  }
  PrefetchRows(corner, N, view.Stride[1], view.Stride[2]);
  double* to = memory.Taps;
  for (int k = 0; k < N; ++k)
  {
    for (int j = 0; j < N; j += 2)
    {
      RowPair<N> rows;
      const T* const even = corner + k * view.Stride[2] + j * view.Stride[1];
      LoadRows<T, N>(even, even + view.Stride[1], rows);
      StoreRows<N>(rows, to);
      to += 2 * N;
    }
  }
  return true;
}

VOLUME_HAPTICS_INLINE bool HoldsTaps(
  const TapMemory& memory, std::uint64_t field, const std::int64_t* first)
{
  return memory.Field == field && memory.First[0] == first[0] && memory.First[1] == first[1] &&
    memory.First[2] == first[2];
}

VOLUME_HAPTICS_INLINE void SetPlace(
  std::uint64_t field, const std::int64_t* first, TapMemory& memory)
{
  memory.Field = field;
  for (int a = 0; a < 3; ++a)
  {
    memory.First[a] = first[a];
  }
}

/**
 * Reads the taps into a memory, beginning with the tap at `first`, unless the memory has them
 * already. Returns false if some taps are outside the samples.
 */
VOLUME_HAPTICS_INLINE bool KeepTaps(
  const FieldView& view, const std::int64_t* first, FillFunction fill, TapMemory& memory)
{
  if (HoldsTaps(memory, view.Number, first))
  {
    return true;
  }
  memory.Field = 0;
  if (!fill(view.Volume, first, memory))
  {
    return false;
  }
  SetPlace(view.Number, first, memory);
  return true;
}

/** The weights of the N rows of a plane, repeated for RowPair's vectors of four. */
template <int N>
struct PlaneWeights
{
  Double4 Even[N / 2];
  Double4 Odd[N / 2];
  Double4 Each[N / 2]; ///< weights of RowPair::Rest
};

template <int N>
VOLUME_HAPTICS_INLINE void SpreadWeights(const double* from, PlaneWeights<N>& weights)
{
#pragma GCC unroll 4
  for (int pair = 0; pair < N / 2; ++pair)
  {
    weights.Even[pair] = Spread(from + 2 * pair);
    weights.Odd[pair] = Spread(from + 2 * pair + 1);
    if constexpr (RowPair<N>::HasRest)
    {
      weights.Each[pair] = JoinHalves(weights.Even[pair], weights.Odd[pair]);
    }
  }
}

/**
 * Multiplies the rows of a plane by their weights and adds them up. The result equals that of
 * AddRows(), to the bit. `load` loads a pair of rows.
 */
template <int N, typename LoadFunction>
VOLUME_HAPTICS_INLINE RowSum<N> SumRows(const LoadFunction& load, const PlaneWeights<N>& weights)
{
  RowSum<N> sum;
#pragma GCC unroll 4
  for (int pair = 0; pair < N / 2; ++pair)
  {
    RowPair<N> rows;
    load(pair, rows);
    for (int p = 0; p < RowPair<N>::Whole; ++p)
    {
      const Double4 both = weights.Even[pair] * rows.Even[p] + weights.Odd[pair] * rows.Odd[p];
      sum.Whole[p] = pair == 0 ? both : sum.Whole[p] + both;
    }
    if constexpr (RowPair<N>::HasRest)
    {
      const Double4 each = weights.Each[pair] * rows.Rest;
      sum.Rest = pair == 0 ? each : sum.Rest + each;
    }
  }
  return sum;
}

/**
 * Computes the sum over taps and the gradient. The result equals that of SumPlanes(), to the bit.
 * Reads the rows twice, so that the weights of all rows stay in registers. `load` loads a pair of
 * rows of a plane, and stores it for the second pass if it is not stored yet.
 */
template <int N, typename LoadFunction>
VOLUME_HAPTICS_INLINE double SumTwice(
  const LoadFunction& load, const double* taps, const Footprint<N>& foot, Vector3* gradient)
{
  RowSum<N> sum;
  RowSum<N> sumY;
  RowSum<N> sumZ;
  PlaneWeights<N> weights;
  SpreadWeights<N>(foot.Weights[1], weights);
  for (int k = 0; k < N; ++k)
  {
    const RowSum<N> smooth =
      SumRows<N>([&load, k](int pair, RowPair<N>& rows) { load(k, pair, rows); }, weights);
    AddScaled<N>(smooth, foot.Weights[2] + k, sum);
    AddScaled<N>(smooth, foot.Weights[2] + N + k, sumZ);
  }
  SpreadWeights<N>(foot.Weights[1] + N, weights);
  for (int k = 0; k < N; ++k)
  {
    const double* const plane = taps + k * N * N;
    const RowSum<N> slope = SumRows<N>([plane](int pair, RowPair<N>& rows)
      { LoadStoredRows<N>(plane + 2 * N * pair, rows); },
      weights);
    AddScaled<N>(slope, foot.Weights[2] + k, sumY);
  }
  return WeighSums<N>(sum, sumY, sumZ, foot.Weights[0], gradient);
}

/** Computes the sum over the taps in a memory, and the gradient. */
template <int N>
VOLUME_HAPTICS_INLINE double SumTaps(
  const double* taps, const Footprint<N>& foot, Vector3* gradient)
{
  return SumTwice<N>([taps](int k, int pair, RowPair<N>& rows)
    { LoadStoredRows<N>(taps + (k * N + 2 * pair) * N, rows); },
    taps, foot, gradient);
}

} // namespace
} // namespace VolumeHaptics

#endif
