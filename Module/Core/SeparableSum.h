// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sum over N^3 taps of a separable kernel. The rules of FieldKernels.h hold here too.
 */
#ifndef SeparableSum_h
#define SeparableSum_h

#include "FieldSampler.h"
#include "Pack4.h"

#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** N consecutive samples of a row, as packs of four; unused lanes are zero. */
template <int N>
struct Row
{
  static constexpr int Packs = (N + 3) / 4;
  Pack4 Pack[Packs];
};

/** How the samples of a row lie in memory: one behind the other, or Stride[0] apart. */
enum class Layout
{
  Contiguous,
  Strided
};

template <typename T, int N, Layout L>
VOLUME_HAPTICS_INLINE void LoadRow(const T* from, std::int64_t stride, Row<N>& row)
{
  if constexpr (L == Layout::Contiguous)
  {
    for (int p = 0; p < N / 4; ++p)
    {
      LoadPack4(from + 4 * p, row.Pack[p]);
    }
    if constexpr (N % 4 != 0)
    {
      row.Pack[N / 4] =
        Pack4{ static_cast<double>(from[N - 2]), static_cast<double>(from[N - 1]), 0.0, 0.0 };
    }
  }
  else
  {
    double lanes[4 * Row<N>::Packs] = {};
    for (int i = 0; i < N; ++i)
    {
      lanes[i] = static_cast<double>(from[i * stride]);
    }
    for (int p = 0; p < Row<N>::Packs; ++p)
    {
      LoadPack4(lanes + 4 * p, row.Pack[p]);
    }
  }
}

template <int N>
VOLUME_HAPTICS_INLINE double DotRow(const Row<N>& row, const double* weights)
{
  double sum[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < N; ++i)
  {
    sum[i % 4] += row.Pack[i / 4][i % 4] * weights[i];
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/** Weights of N taps along each axis, and where the first taps stand. */
template <int N>
struct Footprint
{
  double Smooth[3][N];
  double Slope[3][N];
  std::int64_t First[3];
};

/**
 * The separable sum over N^3 taps. Rows lie along x: they are combined over y and z first, as
 * packs, and weighted along x last. load(k, j, row) reads the row of plane k and line j.
 */
template <int N, bool WithGradient, typename Loader>
VOLUME_HAPTICS_INLINE FieldSample SumRows(const Footprint<N>& foot, const Loader& load)
{
  Row<N> sum{};
  Row<N> sumY{};
  Row<N> sumZ{};
  for (int k = 0; k < N; ++k)
  {
    Row<N> smooth{};
    Row<N> slope{};
    for (int j = 0; j < N; ++j)
    {
      Row<N> row;
      load(k, j, row);
      for (int p = 0; p < Row<N>::Packs; ++p)
      {
        smooth.Pack[p] += foot.Smooth[1][j] * row.Pack[p];
        if constexpr (WithGradient)
        {
          slope.Pack[p] += foot.Slope[1][j] * row.Pack[p];
        }
      }
    }
    for (int p = 0; p < Row<N>::Packs; ++p)
    {
      sum.Pack[p] += foot.Smooth[2][k] * smooth.Pack[p];
      if constexpr (WithGradient)
      {
        sumY.Pack[p] += foot.Smooth[2][k] * slope.Pack[p];
        sumZ.Pack[p] += foot.Slope[2][k] * smooth.Pack[p];
      }
    }
  }
  FieldSample sample;
  sample.Value = DotRow<N>(sum, foot.Smooth[0]);
  if constexpr (WithGradient)
  {
    sample.Gradient.X = DotRow<N>(sum, foot.Slope[0]);
    sample.Gradient.Y = DotRow<N>(sumY, foot.Smooth[0]);
    sample.Gradient.Z = DotRow<N>(sumZ, foot.Smooth[0]);
  }
  return sample;
}

/** Offset of a tap along an axis; taps beyond the border replicate the border sample. */
VOLUME_HAPTICS_INLINE std::int64_t ClampedOffset(const VolumeView& view, int axis, std::int64_t tap)
{
  const std::int64_t last = view.Dimensions[axis] - 1;
  return (tap < 0 ? 0 : (tap < last ? tap : last)) * view.Stride[axis];
}

/** Whether a tap of an axis counts: one without weight may be NaN. */
VOLUME_HAPTICS_INLINE bool HasWeight(const double* smooth, const double* slope, int tap)
{
  return smooth[tap] != 0.0 || slope[tap] != 0.0;
}

/** With every tap clamped to the border, and taps without weight left out. */
template <typename T, int N, bool WithGradient>
VOLUME_HAPTICS_INLINE FieldSample CarefulSum(const VolumeView& view, const Footprint<N>& foot)
{
  std::int64_t offset[3][N];
  bool counts[3][N];
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i < N; ++i)
    {
      offset[a][i] = ClampedOffset(view, a, foot.First[a] + i);
      counts[a][i] = HasWeight(foot.Smooth[a], foot.Slope[a], i);
    }
  }
  const T* const data = static_cast<const T*>(view.Data);
  return SumRows<N, WithGradient>(foot,
    [&](int k, int j, Row<N>& row)
    {
      T taps[N];
      const T* const from = data + offset[2][k] + offset[1][j];
      for (int i = 0; i < N; ++i)
      {
        taps[i] = counts[2][k] && counts[1][j] && counts[0][i] ? from[offset[0][i]] : T(0);
      }
      LoadRow<T, N, Layout::Contiguous>(taps, 1, row);
    });
}

template <typename T, int N, Layout L, bool WithGradient>
VOLUME_HAPTICS_INLINE FieldSample Separable(const VolumeView& view, const Footprint<N>& foot)
{
  const std::int64_t* const n = view.Dimensions;
  const std::int64_t* const first = foot.First;
  if (first[0] >= 0 && first[1] >= 0 && first[2] >= 0 && first[0] + N <= n[0] &&
    first[1] + N <= n[1] && first[2] + N <= n[2])
  {
    const std::int64_t* const stride = view.Stride;
    const T* const corner = static_cast<const T*>(view.Data) + first[0] * stride[0] +
      first[1] * stride[1] + first[2] * stride[2];
    const FieldSample sample = SumRows<N, WithGradient>(foot,
      [&](int k, int j, Row<N>& row)
      { LoadRow<T, N, L>(corner + k * stride[2] + j * stride[1], stride[0], row); });
    if (!std::is_floating_point_v<T> || IsNumber(sample.Value))
    {
      return sample;
    }
  }
  return CarefulSum<T, N, WithGradient>(view, foot);
}

} // namespace
} // namespace VolumeHaptics

#endif
