// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Makes unlikely scenes: random volumes, materials, settings and walks.
 */
#ifndef RandomScene_h
#define RandomScene_h

#include "Random.h"
#include "SampledImage.h"
#include "Scene.h"

namespace reference
{
enum class Curves
{
  Linear, // straight lines between the points
  Curved  // curves with midpoints, sharpness and steep edges
};

/// Returns a smooth random function of the position with values in [-1, 1]. Its wavelengths are 1
/// to 5 times `shortest` voxels.
Field RandomField(Random& random, const Geometry& geometry, double shortest = 5.0);

/// Returns a random size, spacing, origin, direction (also left-handed) and first index.
Geometry RandomGeometry(Random& random, int kernelRadius);

/// Returns the scalars of the scene that the hand feels.
vtkDataArray* FeltScalars(const Scene& scene);

/// Makes a volume of `scalarType`. Its scalars may be one component of several, in an inactive
/// array.
void RandomVolume(
  Scene& scene, Random& random, const Geometry& geometry, int scalarType, double shortest = 5.0);

/// Sets random functions of the scalar for every property of the material.
void RandomMaterial(Scene& scene, Random& random, Curves curves);

/// Sets functions with mild slopes between the ends of the scalar range, and a small depth, so that
/// rounding errors do not grow. The paper's solver chatters if the tip is deeper than the surface's
/// radius of curvature (T13), and its drag amplifies an error if the stiffness falls steeply.
void GentleMaterial(Scene& scene, double low, double high);

/// Makes a smooth walk that presses, slides, sometimes jumps, and occasionally leaves the volume.
void RandomWalk(Scene& scene, Random& random, const Geometry& geometry, int ticks);

/// Returns the walk with a stop of 20 ticks at every 30th point.
std::vector<Vec3> WithStops(const std::vector<Vec3>& path);

/// Sets a constant random stiffness of 50 to 2000 N/m.
void ConstantStiffness(Scene& scene, Random& random);

/// Makes a random volume, material, settings and walk.
void RandomScene(Scene& scene, Random& random, Curves curves, int ticks);

/// Makes a field with long waves, a gentle material and a walk. Returns the random geometry of the
/// field.
Geometry GentleScene(Scene& scene, Random& random, int ticks);

/// Transforms the volume and the path: each x becomes rotation x + translation.
void MoveScene(
  Scene& scene, const Geometry& geometry, const Mat3& rotation, const Vec3& translation);
} // namespace reference

#endif
