// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The sampling kernels, as templates. Included by one translation unit per instruction set only.
 *
 * Nothing here may call an inline function with external linkage (of the standard library or of
 * Vector3.h): the linker keeps one copy of those, and it could be the one with AVX2 in it.
 */
#ifndef FieldKernels_h
#define FieldKernels_h

#include "FieldSampler.h"
#include "SeparableSum.h"

#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** One axis of a kernel's footprint: its first tap and the fraction of a voxel behind it. */
struct Axis
{
  std::int64_t Cell;
  double Fraction;
};

/** The cell of a position within [0, samples - 1]; positions outside are clamped. */
VOLUME_HAPTICS_INLINE Axis LocateCell(double position, std::int64_t samples)
{
  const double last = static_cast<double>(samples - 1);
  const double inside = position > 0.0 ? (position < last ? position : last) : 0.0;
  std::int64_t cell = static_cast<std::int64_t>(inside);
  // The last sample belongs to the last cell, with fraction 1, so that no tap is out of bounds.
  cell = cell > samples - 2 ? samples - 2 : cell;
  return { cell, inside - static_cast<double>(cell) };
}

template <typename T>
VOLUME_HAPTICS_INLINE double Trilinear(const VolumeView& view, double x, double y, double z)
{
  const Axis ax = LocateCell(x, view.Dimensions[0]);
  const Axis ay = LocateCell(y, view.Dimensions[1]);
  const Axis az = LocateCell(z, view.Dimensions[2]);
  const std::int64_t sx = view.Stride[0];
  const std::int64_t sy = view.Stride[1];
  const std::int64_t sz = view.Stride[2];
  const T* const p = static_cast<const T*>(view.Data) + ax.Cell * sx + ay.Cell * sy + az.Cell * sz;
  const auto along = [&](const T* q)
  {
    const double a = static_cast<double>(q[0]);
    return a + ax.Fraction * (static_cast<double>(q[sx]) - a);
  };
  const double near = along(p) + ay.Fraction * (along(p + sy) - along(p));
  const double far = along(p + sz) + ay.Fraction * (along(p + sy + sz) - along(p + sz));
  const double value = near + az.Fraction * (far - near);
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
double TrilinearValue(const VolumeView& view, const KernelView&, const Vector3& index) noexcept
{
  return Trilinear<T>(view, index.X, index.Y, index.Z);
}

template <typename T>
FieldSample CentralDifference(
  const VolumeView& view, const KernelView& kernel, const Vector3& index) noexcept
{
  const double r = kernel.Radius;
  const double scale = 0.5 / r;
  const double x0 = Trilinear<T>(view, index.X - r, index.Y, index.Z);
  const double x1 = Trilinear<T>(view, index.X + r, index.Y, index.Z);
  const double y0 = Trilinear<T>(view, index.X, index.Y - r, index.Z);
  const double y1 = Trilinear<T>(view, index.X, index.Y + r, index.Z);
  const double z0 = Trilinear<T>(view, index.X, index.Y, index.Z - r);
  const double z1 = Trilinear<T>(view, index.X, index.Y, index.Z + r);
  return { (x0 + x1 + y0 + y1 + z0 + z1) / 6.0,
    Vector3{ scale * (x1 - x0), scale * (y1 - y0), scale * (z1 - z0) } };
}

VOLUME_HAPTICS_INLINE void LocateSpline(
  const VolumeView& view, const Vector3& index, Footprint<4>& foot)
{
  const double position[3] = { index.X, index.Y, index.Z };
  for (int a = 0; a < 3; ++a)
  {
    const Axis axis = LocateCell(position[a], view.Dimensions[a]);
    const double t = axis.Fraction;
    const double u = 1.0 - t;
    foot.First[a] = axis.Cell - 1;
    foot.Smooth[a][0] = u * u * u / 6.0;
    foot.Smooth[a][1] = (4.0 + t * t * (3.0 * t - 6.0)) / 6.0;
    foot.Smooth[a][2] = (4.0 + u * u * (3.0 * u - 6.0)) / 6.0;
    foot.Smooth[a][3] = t * t * t / 6.0;
    foot.Slope[a][0] = -0.5 * u * u;
    foot.Slope[a][1] = t * (1.5 * t - 2.0);
    foot.Slope[a][2] = u * (2.0 - 1.5 * u);
    foot.Slope[a][3] = 0.5 * t * t;
  }
}

template <typename T, Layout L>
double SplineValue(const VolumeView& view, const KernelView&, const Vector3& index) noexcept
{
  Footprint<4> foot;
  LocateSpline(view, index, foot);
  return Separable<T, 4, L, false>(view, foot).Value;
}

template <typename T, Layout L>
FieldSample SplineGradient(const VolumeView& view, const KernelView&, const Vector3& index) noexcept
{
  Footprint<4> foot;
  LocateSpline(view, index, foot);
  return Separable<T, 4, L, true>(view, foot);
}

/** Taps and weights of the Gaussian along one axis, from the kernel's table. */
VOLUME_HAPTICS_INLINE std::int64_t LocateGaussian(const KernelView& kernel, double position,
  std::int64_t samples, int taps, double* smooth, double* slope)
{
  constexpr int intervals = GradientKernel::Intervals;
  const Axis axis = LocateCell(position, samples);
  const double scaled = axis.Fraction * intervals;
  int row = static_cast<int>(scaled);
  row = row < intervals ? row : intervals - 1;
  const double t = scaled - row;
  const double u = 1.0 - t;
  const double h0 = u * u * (1.0 + 2.0 * t);
  const double h1 = t * t * (3.0 - 2.0 * t);
  const double g0 = t * u * u;
  const double g1 = -t * t * u;
  const double* const a = kernel.Table + static_cast<std::int64_t>(row) * 4 * taps;
  const double* const b = a + 4 * taps;
  for (int i = 0; i < taps; ++i)
  {
    smooth[i] = (h0 * a[i] + h1 * b[i]) + (g0 * a[2 * taps + i] + g1 * b[2 * taps + i]);
    slope[i] =
      (h0 * a[taps + i] + h1 * b[taps + i]) + (g0 * a[3 * taps + i] + g1 * b[3 * taps + i]);
  }
  return axis.Cell - kernel.Radius;
}

template <typename T, int N, Layout L>
FieldSample GaussianGradient(
  const VolumeView& view, const KernelView& kernel, const Vector3& index) noexcept
{
  Footprint<N> foot;
  const double position[3] = { index.X, index.Y, index.Z };
  for (int a = 0; a < 3; ++a)
  {
    foot.First[a] =
      LocateGaussian(kernel, position[a], view.Dimensions[a], N, foot.Smooth[a], foot.Slope[a]);
  }
  return Separable<T, N, L, true>(view, foot);
}

/** The same for any number of taps, in plain loops. */
template <typename T>
FieldSample WideGaussianGradient(
  const VolumeView& view, const KernelView& kernel, const Vector3& index) noexcept
{
  constexpr int most = GradientKernel::MaximumTaps;
  const int taps = kernel.Taps;
  const double position[3] = { index.X, index.Y, index.Z };
  double smooth[3][most];
  double slope[3][most];
  std::int64_t offset[3][most];
  for (int a = 0; a < 3; ++a)
  {
    const std::int64_t first =
      LocateGaussian(kernel, position[a], view.Dimensions[a], taps, smooth[a], slope[a]);
    for (int i = 0; i < taps; ++i)
    {
      offset[a][i] = ClampedOffset(view, a, first + i);
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
      const T* const from = static_cast<const T*>(view.Data) + offset[2][k] + offset[1][j];
      double rowValue = 0.0;
      double rowX = 0.0;
      for (int i = 0; i < taps; ++i)
      {
        const bool counts = HasWeight(smooth[0], slope[0], i) &&
          HasWeight(smooth[1], slope[1], j) && HasWeight(smooth[2], slope[2], k);
        const double tap = counts ? static_cast<double>(from[offset[0][i]]) : 0.0;
        rowValue += smooth[0][i] * tap;
        rowX += slope[0][i] * tap;
      }
      planeValue += smooth[1][j] * rowValue;
      planeX += smooth[1][j] * rowX;
      planeY += slope[1][j] * rowValue;
    }
    sample.Value += smooth[2][k] * planeValue;
    sample.Gradient.X += smooth[2][k] * planeX;
    sample.Gradient.Y += smooth[2][k] * planeY;
    sample.Gradient.Z += slope[2][k] * planeValue;
  }
  return sample;
}

template <typename T, Layout L>
FieldFunctions FunctionsFor(GradientEstimator estimator, int taps)
{
  switch (estimator)
  {
    case GradientEstimator::CentralDifference:
      return { TrilinearValue<T>, CentralDifference<T> };
    case GradientEstimator::CubicBSpline:
      return { SplineValue<T, L>, SplineGradient<T, L> };
    case GradientEstimator::Gaussian:
      break;
  }
  switch (taps)
  {
    case 4:
      return { TrilinearValue<T>, GaussianGradient<T, 4, L> };
    case 6:
      return { TrilinearValue<T>, GaussianGradient<T, 6, L> };
    case 8:
      return { TrilinearValue<T>, GaussianGradient<T, 8, L> };
    default:
      return { TrilinearValue<T>, WideGaussianGradient<T> };
  }
}

template <typename T>
FieldFunctions FunctionsFor(const VolumeView& view, GradientEstimator estimator, int taps)
{
  return view.Stride[0] == 1 ? FunctionsFor<T, Layout::Contiguous>(estimator, taps)
                             : FunctionsFor<T, Layout::Strided>(estimator, taps);
}

/** The functions of this translation unit's instruction set. */
FieldFunctions SelectFieldFunctions(const VolumeView& view, GradientEstimator estimator, int taps)
{
  switch (view.Type)
  {
    case ScalarType::Int8:
      return FunctionsFor<std::int8_t>(view, estimator, taps);
    case ScalarType::UInt8:
      return FunctionsFor<std::uint8_t>(view, estimator, taps);
    case ScalarType::Int16:
      return FunctionsFor<std::int16_t>(view, estimator, taps);
    case ScalarType::UInt16:
      return FunctionsFor<std::uint16_t>(view, estimator, taps);
    case ScalarType::Int32:
      return FunctionsFor<std::int32_t>(view, estimator, taps);
    case ScalarType::UInt32:
      return FunctionsFor<std::uint32_t>(view, estimator, taps);
    case ScalarType::Int64:
      return FunctionsFor<std::int64_t>(view, estimator, taps);
    case ScalarType::UInt64:
      return FunctionsFor<std::uint64_t>(view, estimator, taps);
    case ScalarType::Float32:
      return FunctionsFor<float>(view, estimator, taps);
    case ScalarType::Float64:
      break;
  }
  return FunctionsFor<double>(view, estimator, taps);
}

} // namespace
} // namespace VolumeHaptics

#endif
