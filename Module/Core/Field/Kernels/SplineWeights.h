// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The weights of the uniform cubic B-spline. The rules in FieldKernels.h also apply here.
 */
#ifndef SplineWeights_h
#define SplineWeights_h

#include "Core/Field/Kernels/LinearKernels.h"
#include "Core/Field/Kernels/SeparableSum.h"

namespace VolumeHaptics
{
namespace
{

/** Computes the first taps and the weights of the uniform cubic B-spline. */
template <bool WithGradient>
VOLUME_HAPTICS_INLINE void LocateSpline(
  const FieldView& view, double x, double y, double z, Footprint<4>& foot)
{
  // Coefficients of 1, t, t^2 and t^3, with a lane for each tap, and the coefficients of their
  // derivatives.
  constexpr double sixth = 1.0 / 6.0;
  const Double4 c0 = { sixth, 4.0 * sixth, sixth, 0.0 };
  const Double4 c1 = { -0.5, 0.0, 0.5, 0.0 };
  const Double4 c2 = { 0.5, -1.0, 0.5, 0.0 };
  const Double4 c3 = { -sixth, 0.5, -0.5, sixth };
  const Double4 d2 = { 1.0, -2.0, 1.0, 0.0 };
  const Double4 d3 = { -0.5, 1.5, -1.5, 0.5 };
  const double position[3] = { x, y, z };
  for (int a = 0; a < 3; ++a)
  {
    const Axis axis = Locate(position[a], view.First[a], view.Last[a]);
    const double t = axis.Fraction;
    const double t2 = t * t;
    foot.First[a] = axis.Cell - 1;
    StoreDouble4((c0 + t * c1) + t2 * (c2 + t * c3), foot.Weights[a]);
    if constexpr (WithGradient)
    {
      StoreDouble4((c1 + t * d2) + t2 * d3, foot.Weights[a] + 4);
    }
  }
}

} // namespace
} // namespace VolumeHaptics

#endif
