// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The taps of the Gaussian kernel at a position. The rules of FieldKernels.h hold here too.
 */
#ifndef GaussianTaps_h
#define GaussianTaps_h

#include "Core/Field/LinearKernels.h"

namespace VolumeHaptics
{
namespace
{

/** First tap and weights of the Gaussian along one axis, from the kernel's table. */
VOLUME_HAPTICS_INLINE std::int64_t LocateGaussian(
  const FieldView& view, int axis, double position, int taps, double* weights)
{
  constexpr int intervals = GradientKernel::Intervals;
  const KernelView& kernel = view.Kernel;
  const Axis place =
    Locate(position * intervals, view.First[axis] * intervals, view.Last[axis] * intervals);
  const auto interval = static_cast<std::uint64_t>(place.Cell);
  const double t = place.Fraction;
  const double t2 = t * t;
  const int count = 2 * taps;
  const double* const c =
    kernel.Table + (interval % intervals) * GradientKernel::Coefficients * count;
  for (int i = 0; i < count; i += 4)
  {
    const auto term = [&](int power) { return LoadDouble4(c + power * count + i); };
    const Double4 low = term(0) + t * term(1);
    const Double4 middle = term(2) + t * term(3);
    const Double4 high = term(4) + t * term(5);
    StoreDouble4(low + t2 * (middle + t2 * high), weights + i);
  }
  return static_cast<std::int64_t>(interval / intervals) - kernel.Radius;
}

} // namespace
} // namespace VolumeHaptics

#endif
