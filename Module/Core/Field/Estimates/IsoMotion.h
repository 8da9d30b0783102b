// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes where the points of an isosurface move from one time step of a volume to the next.
 *
 * A point follows its level through the blends of both time steps (FieldAtTime.h), along the
 * gradient, by Newton's method. Where displacements are known, it moves with its material first,
 * and the level in the next time step only corrects its position. If the level vanishes on the way
 * because its structure disappears, the point stays where it lost the level.
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
  /**
   * Displacements from First to Second, at the points of First. Without Data, the motion is not
   * known.
   */
  DisplacementView Displacements;
  Affine3 IndexToWorld;
};

/**
 * Returns how far each point moves to the next time step. The points lie on the isosurface `value`
 * of the first time step. Points and motions are in world units.
 */
std::vector<Vector3> MeasureIsoMotions(
  const std::vector<Vector3>& points, double value, const IsoTimeSteps& timeSteps);

} // namespace VolumeHaptics

#endif
