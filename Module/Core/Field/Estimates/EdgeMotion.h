// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far edges move from one frame to the next, against their widths.
 *
 * A blend of two frames is an edge on its way as long as the edge moves by no more than two of its
 * widths; beyond, it is a cross-fade (FieldAtTime.h). An edge between the plateaus V1 and V2 is
 *
 *   width  = (V2 - V1) / (g sqrt(2 pi)),
 *
 * wide, with g its steepest slope: the standard deviation of the Gaussian that blurs it. Its motion
 * is that of the place where V is (V1 + V2)/2, along the axis on which the gradient is steepest,
 * times the cosine between the two; motion along an edge does not show.
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
  int Edges = 0; ///< that are in both frames
  int Fast = 0;  ///< that move by more than two widths
  ///@{
  /** Medians of the fast ones, world units. */
  double Motion = 0.0;
  double Width = 0.0;
  ///@}

  /** Whether enough edges are fast not to be a few that were mistaken for others. */
  bool IsFast() const noexcept { return this->Fast >= 4 && this->Fast * 20 >= this->Edges; }
};

/**
 * Looks at up to 256 edges that lie on a lattice of some 8000 places, within 64 samples of each: a
 * few milliseconds. For two frames of the same geometry.
 * @param indexToWorld the linear part of the map
 * @param blur by which a kernel widens edges before they are felt (samples)
 * @param noise of the samples, their standard deviation
 */
EdgeMotion FindEdgeMotion(const VolumeView& first, const VolumeView& second,
  const Matrix3& indexToWorld, double blur, double noise);

} // namespace VolumeHaptics

#endif
