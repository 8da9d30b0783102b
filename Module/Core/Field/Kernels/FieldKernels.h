// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sampling kernels, as templates. Only one translation unit for each instruction set may
 * include this file.
 *
 * Nothing here may call an inline function with external linkage, such as those of the standard
 * library or of Vector3.h. The linker keeps only one copy of such a function, which could be the
 * one that was compiled for AVX2.
 */
#ifndef FieldKernels_h
#define FieldKernels_h

#include "Core/Field/Kernels/BlendedSum.h"
#include "Core/Field/Kernels/LinearKernels.h"
#include "Core/Field/Kernels/SeparableSum.h"
#include "Core/Field/Kernels/SplineWeights.h"
#include "Core/Field/Kernels/TapValues.h"

namespace VolumeHaptics
{
namespace
{

template <typename T>
VOLUME_HAPTICS_INLINE double Spline(const FieldView& view, double x, double y, double z)
{
  Footprint<4> foot;
  LocateSpline<false>(view, x, y, z, foot);
  return Separable<T, 4, false>(view.Volume, foot, nullptr);
}

template <typename T>
VOLUME_HAPTICS_INLINE double Spline(const TimeStepBlend& blend, double x, double y, double z)
{
  Footprint<4> foot;
  LocateSpline<false>(blend.First, x, y, z, foot);
  return SumBlendOfSamples<T, 4, false>(blend, foot, nullptr);
}

/** Returns the B-spline's value in a field, or in a blend of two fields. */
template <typename T, typename Source>
double SplineValue(const Source& from, double x, double y, double z) noexcept
{
  return Spline<T>(from, x, y, z);
}

template <typename T>
FractionPair SharedSplineValues(
  const TimeStepBlend& blend, double share, double x, double y, double z) noexcept
{
  Footprint<4> foot;
  LocateSpline<false>(blend.First, x, y, z, foot);
  const TimeStepBlend other{ blend.First, blend.Second, share };
  return { SumBlendOfSamples<T, 4, false>(blend, foot, nullptr),
    SumBlendOfSamples<T, 4, false>(other, foot, nullptr) };
}

template <typename T, typename Source>
ValuePair SplinePair(
  const Source& from, double x, double y, double z, double dx, double dy, double dz) noexcept
{
  return { Spline<T>(from, x + dx, y + dy, z + dz), Spline<T>(from, x - dx, y - dy, z - dz) };
}

template <typename T, int N>
VOLUME_HAPTICS_INLINE FieldSample SumGradient(const FieldView& view, const Footprint<N>& foot)
{
  FieldSample sample;
  sample.Value = Separable<T, N, true>(view.Volume, foot, &sample.Gradient);
  return sample;
}

template <typename T>
FieldSample SplineGradient(const FieldView& view, double x, double y, double z) noexcept
{
  Footprint<4> foot;
  LocateSpline<true>(view, x, y, z, foot);
  return SumGradient<T, 4>(view, foot);
}

template <typename T>
FieldSample BlendedSpline(
  const TimeStepBlend& blend, double x, double y, double z, const BlendMemories& memories) noexcept
{
  Footprint<4> foot;
  LocateSpline<true>(blend.First, x, y, z, foot);
  return SumBlendedGradient<T, 4>(blend, foot, memories);
}

/**
 * Computes the gradient from the taps in a memory. Reads the taps first if those in the memory
 * belong to another place.
 */
template <int N>
VOLUME_HAPTICS_INLINE bool SumRemembered(const FieldView& view, const Footprint<N>& foot,
  FillFunction fill, TapMemory& memory, FieldSample& sample)
{
  static_assert(N <= TapMemory::MostTaps, "the memory has no room for more taps");
  if (!KeepTaps(view, foot.First, fill, memory))
  {
    return false;
  }
  sample.Value = SumTaps<N>(memory.Taps, foot, &sample.Gradient);
  return IsNumber(sample.Value);
}

bool RememberedSpline(const FieldView& view, double x, double y, double z, FillFunction fill,
  TapMemory& memory, FieldSample& sample) noexcept
{
  Footprint<4> foot;
  LocateSpline<true>(view, x, y, z, foot);
  return SumRemembered<4>(view, foot, fill, memory, sample);
}

/**
 * Computes four weights of the Gaussian at a fraction t of an interval. `count` is the number of
 * coefficients for each power of t.
 */
VOLUME_HAPTICS_INLINE Double4 ComputeWeights(const double* coefficients, int count, double t)
{
  const double t2 = t * t;
  const auto term = [&](int power) { return LoadDouble4(coefficients + power * count); };
  const Double4 low = term(0) + t * term(1);
  const Double4 middle = term(2) + t * term(3);
  const Double4 high = term(4) + t * term(5);
  return low + t2 * (middle + t2 * high);
}

/**
 * The place of the Gaussian's weights along one axis in its table, and the index of the first tap.
 */
struct GaussianPlace
{
  const double* Coefficients;
  double Fraction; ///< position within the table's interval, from 0 to 1
  std::int64_t First;
};

VOLUME_HAPTICS_INLINE GaussianPlace LocateInTable(
  const FieldView& view, int axis, double position, int taps)
{
  constexpr int intervals = GradientKernel::Intervals;
  const KernelView& kernel = view.Kernel;
  const Axis place =
    Locate(position * intervals, view.First[axis] * intervals, view.Last[axis] * intervals);
  const auto interval = static_cast<std::uint64_t>(place.Cell);
  return { kernel.Table + (interval % intervals) * (2 * GradientKernel::Coefficients * taps),
    place.Fraction, static_cast<std::int64_t>(interval / intervals) - kernel.Radius };
}

/**
 * Computes the weights of the Gaussian along one axis from the kernel's table, and returns the
 * index of the first tap.
 */
VOLUME_HAPTICS_INLINE std::int64_t LocateGaussian(
  const FieldView& view, int axis, double position, int taps, double* weights)
{
  const GaussianPlace place = LocateInTable(view, axis, position, taps);
  for (int i = 0; i < 2 * taps; i += 4)
  {
    StoreDouble4(ComputeWeights(place.Coefficients + i, 2 * taps, place.Fraction), weights + i);
  }
  return place.First;
}

template <int N>
VOLUME_HAPTICS_INLINE void LocateGaussian(
  const FieldView& view, int axis, double position, Footprint<N>& foot)
{
  const GaussianPlace place = LocateInTable(view, axis, position, N);
#pragma GCC unroll 4
  for (int i = 0; i < 2 * N; i += 4)
  {
    StoreDouble4(
      ComputeWeights(place.Coefficients + i, 2 * N, place.Fraction), foot.Weights[axis] + i);
  }
  foot.First[axis] = place.First;
}

template <int N>
VOLUME_HAPTICS_INLINE void LocateGaussian(
  const FieldView& view, double x, double y, double z, Footprint<N>& foot)
{
  // Locate the axes in the order in which the sum needs them.
  LocateGaussian<N>(view, 1, y, foot);
  LocateGaussian<N>(view, 2, z, foot);
  LocateGaussian<N>(view, 0, x, foot);
}

template <typename T, int N>
FieldSample GaussianGradient(const FieldView& view, double x, double y, double z) noexcept
{
  Footprint<N> foot;
  LocateGaussian<N>(view, x, y, z, foot);
  return SumGradient<T, N>(view, foot);
}

template <typename T, int N>
FieldSample BlendedGaussian(
  const TimeStepBlend& blend, double x, double y, double z, const BlendMemories& memories) noexcept
{
  Footprint<N> foot;
  LocateGaussian<N>(blend.First, x, y, z, foot);
  return SumBlendedGradient<T, N>(blend, foot, memories);
}

template <int N>
bool RememberedGaussian(const FieldView& view, double x, double y, double z, FillFunction fill,
  TapMemory& memory, FieldSample& sample) noexcept
{
  Footprint<N> foot;
  LocateGaussian<N>(view, x, y, z, foot);
  return SumRemembered<N>(view, foot, fill, memory, sample);
}

/** Computes the same gradient for any number of taps, in plain loops. */
template <typename T>
FieldSample WideGaussianGradient(const FieldView& view, double x, double y, double z) noexcept
{
  constexpr int most = GradientKernel::MaximumTaps;
  const int taps = view.Kernel.Taps;
  const double position[3] = { x, y, z };
  alignas(32) double weights[3][2 * most];
  std::int64_t offset[3][most];
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t first = LocateGaussian(view, a, position[a], taps, weights[a]);
    for (int i = 0; i < taps; ++i)
    {
      offset[a][i] = ClampedOffset(view.Volume, a, first + i);
    }
  }
  FieldSample sample;
  for (int k = 0; k < taps; ++k)
  {
    double planeValue = 0.0;
    double planeX = 0.0;
    double planeY = 0.0;
    for (int j = 0; j < taps; ++j)
    {
      const T* const from = static_cast<const T*>(view.Volume.Data) + offset[2][k] + offset[1][j];
      double rowValue = 0.0;
      double rowX = 0.0;
      for (int i = 0; i < taps; ++i)
      {
        const bool counts = weights[0][i] != 0.0 && weights[1][j] != 0.0 && weights[2][k] != 0.0;
        const double tap = counts ? static_cast<double>(from[offset[0][i]]) : 0.0;
        rowValue += weights[0][i] * tap;
        rowX += weights[0][taps + i] * tap;
      }
      planeValue += weights[1][j] * rowValue;
      planeX += weights[1][j] * rowX;
      planeY += weights[1][taps + j] * rowValue;
    }
    sample.Value += weights[2][k] * planeValue;
    sample.Gradient.X += weights[2][k] * planeX;
    sample.Gradient.Y += weights[2][k] * planeY;
    sample.Gradient.Z += weights[2][taps + k] * planeValue;
  }
  return sample;
}

template <int N>
void SetTapFunctions(FieldFunctions& f)
{
  f.TapValue = TapValue<N>;
  f.SharedTapValues = SharedTapValues<N>;
  f.TapPair = TapPair<N>;
}

/** Returns the functions of an estimator. Functions that the estimator lacks are null. */
template <typename T>
FieldFunctions FunctionsFor(GradientEstimator estimator, int taps)
{
  FieldFunctions f;
  f.Value = TrilinearValue<T, FieldView>;
  f.Pair = TrilinearPair<T, FieldView>;
  f.BlendedValue = TrilinearValue<T, TimeStepBlend>;
  f.SharedValues = SharedTrilinearValues<T>;
  f.BlendedPair = TrilinearPair<T, TimeStepBlend>;
  switch (estimator)
  {
    case GradientEstimator::CentralDifference:
      f.Gradient = CentralDifference<T>;
      f.BlendedGradient = BlendedDifference<T>;
      return f;
    case GradientEstimator::CubicBSpline:
      return { SplineValue<T, FieldView>, SplinePair<T, FieldView>, SplineGradient<T>,
        SplineValue<T, TimeStepBlend>, SharedSplineValues<T>, SplinePair<T, TimeStepBlend>,
        BlendedSpline<T>, FillTaps<T, 4>, RememberedSpline };
    case GradientEstimator::Gaussian:
      break;
  }
  switch (taps)
  {
    case 4:
      f.Gradient = GaussianGradient<T, 4>;
      f.BlendedGradient = BlendedGaussian<T, 4>;
      f.Fill = FillTaps<T, 4>;
      f.Remembered = RememberedGaussian<4>;
      SetTapFunctions<4>(f);
      return f;
    case 6:
      f.Gradient = GaussianGradient<T, 6>;
      f.BlendedGradient = BlendedGaussian<T, 6>;
      f.Fill = FillTaps<T, 6>;
      f.Remembered = RememberedGaussian<6>;
      SetTapFunctions<6>(f);
      return f;
    case 8:
      f.Gradient = GaussianGradient<T, 8>;
      f.BlendedGradient = BlendedGaussian<T, 8>;
      return f;
    default:
      f.Gradient = WideGaussianGradient<T>;
      return f;
  }
}

/** Returns the functions of this translation unit's instruction set. */
FieldFunctions SelectFieldFunctions(const VolumeView& view, GradientEstimator estimator, int taps)
{
  return WithSampleType(
    view.Type, [=](auto sample) { return FunctionsFor<decltype(sample)>(estimator, taps); });
}

} // namespace
} // namespace VolumeHaptics

#endif
