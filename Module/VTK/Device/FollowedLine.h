// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The line of a mode that the hand follows, traced by vtkStreamTracer.
 *
 * The tracer gets the directions that the servo reads, as the function of its integrator,
 * vtkRungeKutta4, in steps of half a voxel. It interpolates no array of the volume: that would be
 * trilinear, which is not what is felt (24 voxels along a flow with waves of 12 voxels, that line
 * is up to 0.36 voxel off; this one 0.003), tensors have no vectors, and ridges and guides no
 * array. So its data set is a single cell around the place, in voxels from there, of the size that
 * lines may have, whatever the volume's. vtkHyperStreamline takes no function, and makes tubes.
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
 * The places (m) along a line, as far as `reach` voxels of a length (m) to either side of where it
 * was found; 1 if it is too short. One that is closed ends where it begins. For the GUI thread.
 */
std::vector<Vector3> TraceFollowedLine(
  FollowedShapes& shapes, const FollowedShape& line, double voxel, double reach);

} // namespace VolumeHaptics

#endif
