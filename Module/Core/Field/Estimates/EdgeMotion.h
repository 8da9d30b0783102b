// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far edges move from one time step to the next, against their widths.
 *
 * A blend of two time steps is an edge on its way as long as the edge moves by at most two of its
 * widths; beyond, it is a cross-fade (FieldAtTime.h). An edge between the plateaus V1 and V2 is
 *
 *   width  = (V2 - V1) / (g sqrt(2 pi)),
 *
 * wide, with g its steepest slope: the standard deviation of the Gaussian that blurs it. Its motion
 * is the motion of the place where V is (V1 + V2)/2, along the axis on which the gradient is
 * steepest, times the cosine between axis and gradient; motion along an edge does not show.
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
  int Edges = 0; ///< the number of edges that are in both time steps
  int Fast = 0;  ///< the number of edges that move by more than two widths
  ///@{
  /** Medians over the fast edges, world units. */
  double Motion = 0.0;
  double Width = 0.0;
  ///@}

  /** Returns whether the fast edges are too many to be a few mismatches. */
  bool IsFast() const noexcept { return this->Fast >= 4 && this->Fast * 20 >= this->Edges; }
};

/**
 * Measures up to 256 edges on a lattice of some 8000 places, within 64 samples of each: a few
 * milliseconds. For two time steps of the same geometry.
 * @param indexToWorld the linear part of the map
 * @param blur the width of the kernel that blurs edges before they are felt (samples)
 * @param noise the standard deviation of the samples' noise
 */
EdgeMotion MeasureEdgeMotion(const VolumeView& first, const VolumeView& second,
  const Matrix3& indexToWorld, double blur, double noise);

} // namespace VolumeHaptics

#endif
