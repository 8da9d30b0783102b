// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Haptics for polygonal surfaces, with which the paper compares its method. The proxy is a sphere
 * that does not pass through triangles.
 *
 * The method follows Ruspini, Kolarov and Khatib, "The Haptic Display of Complex Graphical
 * Environments", 1997. The proxy is a sphere of radius HapticSettings::ProxyRadius around x. Each
 * triangle that it touches defines a half-space. The subgoal y is the point in all half-spaces that
 * is nearest to the tip. Friction carries mu times the lag that the surfaces carry,
 *
 *   x' = x + (y - x) max(0, 1 - mu |x_tip - y| / |y - x|),
 *
 * and the sphere moves to x', or to the first triangle in its path. This is repeated until the
 * sphere rests. The sphere never starts to overlap a triangle, so it can't pass through a surface
 * at any speed.
 *
 * With ForceShading, a first subgoal is computed for half-spaces whose normals are interpolated
 * between the points' normals. It is then the goal for the true half-spaces. The direction of the
 * force thus changes smoothly over a coarse mesh.
 *
 * If the sphere overlaps a triangle because it began there, or because the mesh is new, its radius
 * shrinks to the triangle's distance. Nothing pushes the sphere out, and surfaces only keep it from
 * going deeper.
 *
 * If the volume moves, triangles move from each time step to the next one along straight lines
 * (SurfaceMesh.h). Before a tick, each approaching triangle pushes the sphere, which remains on the
 * same side of it. If displacements are known, the nearest triangle that the sphere touches also
 * moves it sideways, as far as friction then holds it there. In the next time step the surface has
 * other triangles, at the same place except for the mesh's own roughness.
 *
 * Stiffness and friction are those of the material at HapticSettings::IsoValue. Surfaces withstand
 * any force, and there is no drag. A tick has at most MaximumPasses passes. If they are not enough,
 * the next tick continues.
 */
#ifndef SurfaceProxy_h
#define SurfaceProxy_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Limit of the rounds in a tick. Each round computes a subgoal and moves the sphere. */
constexpr int MaximumPasses = 24;
/**
 * Limit of the mesh's boxes that a tick visits, which takes half a millisecond. When it is reached,
 * the sphere stays where it is.
 */
constexpr int MaximumVisits = 20000;
/**
 * Largest number of boxes that a sphere may touch at once. A larger sphere can't be felt, because
 * it would use up the budget without moving.
 */
constexpr int MostTouched = MaximumVisits / 4;

/** Computes a tick for record.Tip, and writes the whole record. The model must have a mesh. */
void StepSurfaceProxy(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept;

/** Implements Method::Reach. */
Vector3 FindSurfaceProxyReach(const HapticModel& model) noexcept;

/**
 * Returns the initial position (device) of a proxy that another method has left at `place`.
 *
 * Triangles do not let a proxy through, not even outward, but other methods may leave the proxy
 * inside the isosurface. If it is not deeper than EntryDepth, it starts at the nearest position
 * outside; if it is deeper, surfaces hold it inside. Reads a few hundred values at a data time.
 */
Vector3 EnterSurface(const HapticModel& model, const Vector3& place, double time = 0.0) noexcept;

/**
 * Returns whether the volume's value at a position (device) and data time is on the outer side of
 * the isovalue. Returns true if there is no isosurface.
 */
bool IsOutsideSurface(const HapticModel& model, const Vector3& place, double time = 0.0) noexcept;

/** A proxy starts outside the isosurface if it is at most this deep (kernel lengths) in it. */
constexpr double EntryDepth = 3.0;

} // namespace VolumeHaptics

#endif
