// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Synthetic scans for presets for which no scan with a known truth exists: a ball of metal in air
 * as an industrial CT shows it ("Micro-CT"), and a ball of a label ("Labels").
 *
 * The true surface is a sphere. A hand whose tip moves on a circle at a depth d under a sphere of
 * radius R, in a plane through its middle, lags behind until the friction is sliding friction. Then
 * the force, from the tip T to the proxy P on the sphere, is off the normal by a with tan a = mu,
 * and the triangle of T, P and the middle gives its length:
 *
 *   (R - d)^2 = R^2 + L^2 - 2 R L cos a,   |F| = k L.
 */
#ifndef Evaluation_Parts_h
#define Evaluation_Parts_h

#include "Surfaces.h"
#include "Table.h"

namespace evaluation
{

/** mm: radius of the balls about OddCentre, in voxels of 1 mm. */
constexpr double PartRadius = 40.0;

/**
 * Returns the grey value of the metal ball without noise: a step blurred by 1.2 voxels, lower by
 * 12 % in the middle because of beam hardening.
 */
double MetalValue(const Vector3& x);

/**
 * Returns the metal ball with 1.7 % of noise, and a ball in a label image, both with strokes along
 * great circles.
 */
std::vector<FeltSurface> MakePartSurfaces(const Effort& effort);

/** Returns the force (N) of the formula above; R and d in mm, k in N/m. */
double SlidingForce(double radius, double depth, double stiffness, double friction);

/** Results of strokes over a part with the default settings, and the formula's prediction. */
struct PartFeel
{
  double Distance = 0.0; ///< mm: mean distance between proxy and true surface
  double Largest = 0.0;  ///< mm: largest distance
  double Force = 0.0;    ///< N, mean of the measured forces
  double Expected = 0.0; ///< N, mean of SlidingForce() at the depths of the tips
  std::size_t Ticks = 0;
};

PartFeel FeelPart(const FeltSurface& part);

Table ComparePartsWithFormulas(const std::vector<FeltSurface>& parts);

} // namespace evaluation

#endif
