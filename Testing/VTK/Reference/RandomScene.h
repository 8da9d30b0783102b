// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Scenes no one would think of: random volumes, materials, settings and walks.
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
  Linear, // straight between the points
  Curved  // midpoints, sharpness, steep edges
};

/// A smooth random function of the position, in [-1, 1]: waves of 1 to 5 times `shortest` voxels.
Field RandomField(Random& random, const Geometry& geometry, double shortest = 5.0);

/// Random size, spacing, origin, direction (left-handed too) and first index.
Geometry RandomGeometry(Random& random, int kernelRadius);

/// The scalars of the scene that are felt.
vtkDataArray* FeltScalars(const Scene& scene);

/// A volume of `scalarType`, maybe one component of several in an array that is not the active one.
void RandomVolume(
  Scene& scene, Random& random, const Geometry& geometry, int scalarType, double shortest = 5.0);

/// Random functions of the scalar for every property of the material.
void RandomMaterial(Scene& scene, Random& random, Curves curves);

/// Mild slopes between the ends of the scalar range and little depth: neither lets rounding grow.
/// The paper's solver chatters if the tip is deeper than the surface's radius of curvature (T13),
/// and its drag multiplies an error if the stiffness falls steeply.
void GentleMaterial(Scene& scene, double low, double high);

/// A smooth walk that presses, slides, jumps now and then and strays out of the volume.
void RandomWalk(Scene& scene, Random& random, const Geometry& geometry, int ticks);

/// The walk, stopping for 20 ticks at every 30th.
std::vector<Vec3> WithStops(const std::vector<Vec3>& path);

/// The same stiffness, of 50 to 2000 N/m, everywhere.
void ConstantStiffness(Scene& scene, Random& random);

/// A random volume, material, settings and walk.
void RandomScene(Scene& scene, Random& random, Curves curves, int ticks);

/// A long-waved field of some random geometry, which is returned, a gentle material and a walk.
Geometry GentleScene(Scene& scene, Random& random, int ticks);

/// Moves the volume and the path: x -> rotation x + translation.
void MoveScene(
  Scene& scene, const Geometry& geometry, const Mat3& rotation, const Vec3& translation);
} // namespace reference

#endif
