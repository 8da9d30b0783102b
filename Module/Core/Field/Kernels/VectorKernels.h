// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The kernels of VectorSampler, as templates. Only one translation unit for each instruction set
 * may include this file. The rules in FieldKernels.h also apply here.
 */
#ifndef VectorKernels_h
#define VectorKernels_h

#include "Core/Field/Kernels/SplineWeights.h"
#include "Core/Field/VectorSampler.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Computes the sums over 4^3 taps of C interleaved components. `corner` is the first tap. A row of
 * taps is 4 C consecutive numbers. Rows are first combined over y and z in vectors of four, which
 * mix components. The weights along x are applied last, for each component.
 */
template <typename T, int C, bool WithGradient>
VOLUME_HAPTICS_INLINE void SumVectors(const T* corner, std::int64_t line, std::int64_t plane,
  const Footprint<4>& foot, VectorSample& sample)
{
  // Sum of the values, and sums of the slopes along y and z.
  constexpr int sums = WithGradient ? 3 : 1;
  // Unroll the loop, so that the sums of a vector stay in registers.
  Double4 sum[sums][C] = {};
  for (int k = 0; k < 4; ++k)
  {
    Double4 smooth[C] = {};
    Double4 slope[C] = {};
#pragma GCC unroll 4
    for (int j = 0; j < 4; ++j)
    {
      const T* const row = corner + k * plane + j * line;
#pragma GCC unroll 9
      for (int p = 0; p < C; ++p)
      {
        const Double4 taps = LoadDouble4(row + 4 * p);
        smooth[p] = smooth[p] + foot.Weights[1][j] * taps;
        if constexpr (WithGradient)
        {
          slope[p] = slope[p] + foot.Weights[1][4 + j] * taps;
        }
      }
    }
#pragma GCC unroll 9
    for (int p = 0; p < C; ++p)
    {
      sum[0][p] = sum[0][p] + foot.Weights[2][k] * smooth[p];
      if constexpr (WithGradient)
      {
        sum[1][p] = sum[1][p] + foot.Weights[2][k] * slope[p];
        sum[2][p] = sum[2][p] + foot.Weights[2][4 + k] * smooth[p];
      }
    }
  }
  alignas(32) double row[sums][4 * C];
#pragma GCC unroll 3
  for (int s = 0; s < sums; ++s)
  {
#pragma GCC unroll 9
    for (int p = 0; p < C; ++p)
    {
      StoreDouble4(sum[s][p], row[s] + 4 * p);
    }
  }
  const auto along = [&](int s, int c, const double* weights)
  {
    return (weights[0] * row[s][c] + weights[2] * row[s][2 * C + c]) +
      (weights[1] * row[s][C + c] + weights[3] * row[s][3 * C + c]);
  };
#pragma GCC unroll 9
  for (int c = 0; c < C; ++c)
  {
    sample.Value[c] = along(0, c, foot.Weights[0]);
    if constexpr (WithGradient)
    {
      sample.Gradient[c].X = along(0, c, foot.Weights[0] + 4);
      sample.Gradient[c].Y = along(1, c, foot.Weights[0]);
      sample.Gradient[c].Z = along(2, c, foot.Weights[0]);
    }
  }
}

/**
 * Computes the sums of SumVectors() from a copy of the taps. Used if taps lie outside the resident
 * samples, if the components of a sample are not adjacent in memory, or if a sum is not a number.
 */
template <typename T, int C, bool WithGradient>
VOLUME_HAPTICS_OUTLINE void SumVectorsCopy(
  const VectorView& view, const Footprint<4>& foot, VectorSample& sample)
{
  std::int64_t offset[3][4];
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i < 4; ++i)
    {
      offset[a][i] = ClampedOffset(view.Volume, a, foot.First[a] + i);
    }
  }
  T block[64 * C];
  T* to = block;
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      const T* const from = static_cast<const T*>(view.Volume.Data) + offset[2][k] + offset[1][j];
      const bool counts = foot.Weights[2][k] != 0.0 && foot.Weights[1][j] != 0.0;
      for (int i = 0; i < 4; ++i)
      {
        for (int c = 0; c < C; ++c)
        {
          *to++ = counts && foot.Weights[0][i] != 0.0 ? from[offset[0][i] + c * view.Stride] : T(0);
        }
      }
    }
  }
  SumVectors<T, C, WithGradient>(block, 4 * C, 16 * C, foot, sample);
}

/** Returns whether all values and slopes are numbers. */
template <int C, bool WithGradient>
VOLUME_HAPTICS_INLINE bool IsOfNumbers(const VectorSample& sample)
{
  double sum = 0.0;
  for (int c = 0; c < C; ++c)
  {
    // The difference is 0 for a number and NaN otherwise.
    sum += sample.Value[c] - sample.Value[c];
    if constexpr (WithGradient)
    {
      const Vector3& slope = sample.Gradient[c];
      sum += (slope.X - slope.X) + (slope.Y - slope.Y) + (slope.Z - slope.Z);
    }
  }
  return sum == 0.0;
}

template <typename T, int C, bool WithGradient>
bool SampleVectors(
  const VectorFieldView& field, double x, double y, double z, VectorSample& sample) noexcept
{
  const FieldView& view = field.View;
  Footprint<4> foot;
  LocateSpline<WithGradient>(view, x, y, z, foot);
  const std::int64_t* const n = view.Volume.Dimensions;
  const std::int64_t* const stride = view.Volume.Stride;
  const std::int64_t* const first = foot.First;
  const auto fits = [&](int a)
  { return first[a] >= view.Volume.First[a] && first[a] + 4 <= view.Volume.First[a] + n[a]; };
  if (field.ComponentStride == 1 && stride[0] == C && fits(0) && fits(1) && fits(2))
  {
    const T* const corner = static_cast<const T*>(view.Volume.Data) + first[0] * C +
      first[1] * stride[1] + first[2] * stride[2];
    SumVectors<T, C, WithGradient>(corner, stride[1], stride[2], foot, sample);
    if (!std::is_floating_point_v<T> || IsOfNumbers<C, WithGradient>(sample))
    {
      return true;
    }
  }
  const VectorView given = { view.Volume, C, field.ComponentStride };
  SumVectorsCopy<T, C, WithGradient>(given, foot, sample);
  return IsOfNumbers<C, WithGradient>(sample);
}

/**
 * Returns the functions of this translation unit's instruction set, or none if the number of
 * components is not 3, 6 or 9.
 */
VectorFunctions SelectVectorFunctions(ScalarType type, int components)
{
  return WithSampleType(type,
    [=](auto t) -> VectorFunctions
    {
      using T = decltype(t);
      switch (components)
      {
        case 3:
          return { SampleVectors<T, 3, false>, SampleVectors<T, 3, true> };
        case 6:
          return { SampleVectors<T, 6, false>, SampleVectors<T, 6, true> };
        case 9:
          return { SampleVectors<T, 9, false>, SampleVectors<T, 9, true> };
        default:
          return {};
      }
    });
}

} // namespace
} // namespace VolumeHaptics

#endif
