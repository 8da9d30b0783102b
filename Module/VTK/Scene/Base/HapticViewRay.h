// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts a screen position to a position in the scene, and to the first contact along its line of
 * sight.
 */
#ifndef HapticViewRay_h
#define HapticViewRay_h

#include "Core/Math/Vector3.h"

class vtkRenderer;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Returns the world position under a pixel of the renderer, at the depth of another world position.
 */
Vector3 UnderPointer(vtkRenderer* renderer, const int pointer[2], const Vector3& depth);
Vector3 UnderPointer(vtkRenderer* renderer, const double pointer[2], const Vector3& depth);

/** Returns the size (world units) of a pixel at the depth of a position. */
double PixelSize(vtkRenderer* renderer, const Vector3& position);

/** Returns the unit vector of the line of sight at a position, away from the viewer. */
Vector3 LineOfSight(vtkRenderer* renderer, const Vector3& position);

/** Resistance of a surface to a press. */
struct Press
{
  double Depth = 0.0; ///< world units: depth of the tip beyond the contact
  double Force = 0.0; ///< N, at that depth; the largest number if unknown
};

/**
 * Finds the first contact along the line of sight through a position, from where the line enters
 * the image, with the servo's own tick. Sets `position` to half a voxel in front of the contact.
 * Returns false if nothing can be felt along the line. While an isosurface is still being meshed,
 * the image's samples replace the mesh. `press` may be null.
 */
bool FindFirstContact(vtkRenderer* renderer, const Vector3& through, vtkVolumeHapticsFilter* filter,
  Vector3& position, Press* press = nullptr);

/**
 * Finds the first contact along the line of sight like FindFirstContact(), but starting from a
 * position. Outputs the position of the contact, and the outward unit normal of the surface (zero
 * if unknown). Returns false if nothing can be felt ahead.
 */
bool FindContactAhead(vtkRenderer* renderer, const Vector3& from, vtkVolumeHapticsFilter* filter,
  Vector3& contact, Vector3& normal, Press* press = nullptr);

} // namespace VolumeHaptics

#endif
