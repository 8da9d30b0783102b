// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Moves the points of an isosurface from one frame of a moving volume to the next.
 *
 * A point follows its level through the blends of the frames (FieldAtTime.h), along the gradient,
 * by Newton's method; where displacements are known, it moves with its material first, and the
 * level in the next frame only corrects that. If the level vanishes on the way, because its
 * structure disappears, the point stays where it lost the level.
 */
#ifndef IsoMotion_h
#define IsoMotion_h

#include "Core/Field/DisplacementField.h"
#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

#include <vector>

namespace VolumeHaptics
{

/** Two frames of the same geometry. */
struct IsoFrames
{
  VolumeView First;
  VolumeView Second;
  /** On the points of First, to Second; without Data, the motion is not known. */
  DisplacementView Displacements;
  Affine3 IndexToWorld;
};

/** The motions of points of the isosurface in the first frame (both in world units). */
std::vector<Vector3> FindIsoMotions(
  const std::vector<Vector3>& points, double value, const IsoFrames& frames);

} // namespace VolumeHaptics

#endif
