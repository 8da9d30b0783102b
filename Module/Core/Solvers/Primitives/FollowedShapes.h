// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the modes of a model hold the hand on, near a place: lines and fronts, to be drawn.
 *
 * They are made of the primitives that a tick reads (ModePrimitives.h), so that what is seen is
 * what is felt:
 *
 * | mode          | shape                                                     |
 * | ------------- | --------------------------------------------------------- |
 * | VectorFollow  | the stream line through the place                         |
 * | VectorFront   | the front through the place, and where its free side is   |
 * | TwoSidedFront | the same                                                  |
 * | VortexTube    | the core line of the vortex around the place              |
 * | Shear         | the line through the place, along the largest stretch     |
 * | TensorFollow  | the fibre through the place; or its sheet; and the tensor |
 * | Ridge, Guide  | the line that the hand is drawn to                        |
 * | GuideSurface  | its tangent plane, as a front                             |
 * | Surface       | nothing: the volume shows it                              |
 *
 * Lines are followed by Runge and Kutta's method of fourth order, in steps of half a voxel; those
 * with an anchor of their own return to it in every step. For the GUI thread: this allocates.
 */
#ifndef FollowedShapes_h
#define FollowedShapes_h

#include "Core/Model/HapticModel.h"

#include <vector>

namespace VolumeHaptics
{

struct FollowedShape
{
  int Mode = 0;              ///< its number
  std::vector<Vector3> Line; ///< m, in the order along it; empty for a front or tensor
  bool IsClosed = false;     ///< the line ends where it begins
  ///@{
  /** Of a front: its place (m), and the unit normal to its free side; both sides may be held. */
  Vector3 Centre;
  Vector3 Normal;
  ///@}
  ///@{
  /** Of a tensor, in world axes, at Centre: divided by its first eigenvalue, which is positive. */
  bool IsTensor = false;
  Matrix3 Tensor;
  ///@}
};

/**
 * The shapes at a place (m), as far as `reach` voxels along lines to either side. Modes that hold
 * nothing there have none, and so have other methods than Primitives.
 */
std::vector<FollowedShape> FindFollowedShapes(
  const HapticModel& model, const Vector3& place, double reach);

} // namespace VolumeHaptics

#endif
