// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Moves the points of an isosurface from one time step of a moving volume to the next.
 *
 * A point follows its level through the blends of the time steps (FieldAtTime.h), along the
 * gradient, by Newton's method; where displacements are known, it moves with its material first,
 * and the level in the next time step only corrects that. If the level vanishes on the way, because
 * its structure disappears, the point stays where it lost the level.
 */
#ifndef IsoMotion_h
#define IsoMotion_h

#include "Core/Field/DisplacementField.h"
#include "Core/Field/VolumeView.h"
#include "Core/Math/Vector3.h"

#include <vector>

namespace VolumeHaptics
{

/** Two time steps of the same geometry. */
struct IsoTimeSteps
{
  VolumeView First;
  VolumeView Second;
  /** Displacements on the points of First, to Second; without Data, the motion is not known. */
  DisplacementView Displacements;
  Affine3 IndexToWorld;
};

/**
 * Computes the motions of points of the isosurface in the first time step (both in world units).
 */
std::vector<Vector3> MeasureIsoMotions(
  const std::vector<Vector3>& points, double value, const IsoTimeSteps& timeSteps);

} // namespace VolumeHaptics

#endif
