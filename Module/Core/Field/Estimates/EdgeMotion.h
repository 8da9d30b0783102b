// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures how far edges move from one time step to the next, in relation to their widths.
 *
 * A blend of two time steps shows a moving edge as long as the edge moves by at most two of its
 * widths. If it moves farther, the blend is a cross-fade (FieldAtTime.h). The width of an edge
 * between the plateaus V1 and V2 is
 *
 *   width  = (V2 - V1) / (g sqrt(2 pi)),
 *
 * where g is its steepest slope. It is the standard deviation of the Gaussian that blurs the edge.
 * The motion of an edge is the motion of the place where V is (V1 + V2)/2, measured along the axis
 * on which the gradient is steepest and multiplied by the cosine between this axis and the
 * gradient. Motion along the edge can't be measured.
 */
#ifndef EdgeMotion_h
#define EdgeMotion_h

#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** The motion of a volume's edges. */
struct EdgeMotion
{
  int Edges = 0; ///< number of edges that were found in both time steps
  int Fast = 0;  ///< number of edges that move by more than two widths
  ///@{
  /** Medians (world units) over the fast edges. */
  double Motion = 0.0;
  double Width = 0.0;
  ///@}

  /** Returns whether there are more fast edges than a few mismatches would explain. */
  bool IsFast() const noexcept { return this->Fast >= 4 && this->Fast * 20 >= this->Edges; }
};

/**
 * Measures up to 256 edges, in a few milliseconds. Looks for edges at some 8000 places of a
 * lattice, and follows each within 64 samples. Both time steps must have the same geometry.
 * @param indexToWorld the linear part of the map
 * @param blur the width (samples) of the kernel with which the haptic field blurs edges
 * @param noise the standard deviation of the samples' noise
 */
EdgeMotion MeasureEdgeMotion(const VolumeView& first, const VolumeView& second,
  const Matrix3& indexToWorld, double blur, double noise);

} // namespace VolumeHaptics

#endif
