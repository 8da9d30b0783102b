// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Traces the line of a mode that the hand follows, with vtkStreamTracer.
 *
 * The tracer's integrator, vtkRungeKutta4, calls a function that returns the directions that the
 * servo reads, in steps of half a voxel. It does not interpolate an array of the volume, for two
 * reasons. First, the hand does not feel trilinear interpolation: after 24 voxels along a flow with
 * waves of 12 voxels, a line traced by it is up to 0.36 voxel off, this one 0.003. Second, tensors
 * have no vectors, and ridges and guides have no array. The tracer's data set is therefore a single
 * cell around the position, in voxels relative to it. It is as large as lines may become, whatever
 * the volume's size. vtkHyperStreamline is not used, because it accepts no function and makes
 * tubes.
 */
#ifndef FollowedLine_h
#define FollowedLine_h

#include "Core/Math/Vector3.h"

#include <vector>

namespace VolumeHaptics
{
class FollowedShapes;
struct FollowedShape;

/**
 * Computes the points (m) of a line, up to `reach` voxels of length `voxel` (m) to either side of
 * where it was found; only one point if the line is too short. A closed line ends where it begins.
 * For the GUI thread.
 */
std::vector<Vector3> TraceFollowedLine(
  FollowedShapes& shapes, const FollowedShape& line, double voxel, double reach);

} // namespace VolumeHaptics

#endif
