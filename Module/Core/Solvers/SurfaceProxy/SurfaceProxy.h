// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polygonal surface haptics, with which the paper compares its method: a sphere that passes through
 * no triangle.
 *
 * After Ruspini, Kolarov and Khatib, "The Haptic Display of Complex Graphical Environments", 1997.
 * The proxy is a sphere of radius HapticSettings::ProxyRadius around x. Every triangle that it
 * touches gives a half-space; the subgoal y is the point in all of them that is nearest to the tip.
 * Friction takes mu times the lag that the surfaces hold,
 *
 *   x' = x + (y - x) max(0, 1 - mu |x_tip - y| / |y - x|),
 *
 * and the sphere moves there or to the first triangle that it meets, repeatedly, until it stands
 * still. It never begins to overlap a triangle: no speed takes it through a surface.
 *
 * With ForceShading the half-spaces first get normals that are interpolated between the points'
 * normals; their subgoal is then the goal for the true half-spaces. So the force turns smoothly
 * over a coarse mesh.
 *
 * If the sphere overlaps a triangle, because it began there or the mesh is new, its radius shrinks
 * to the triangle's distance: nothing throws it out, and surfaces only keep it from going deeper.
 *
 * If the volume moves, triangles go from each time step to the next one along straight ways
 * (SurfaceMesh.h), and before a tick the approaching ones push the sphere: each to the sphere's
 * side of it. If displacements are known, the nearest triangle that it touches takes it along
 * sideways, as far as friction then holds it there. In the next time step the surface has other
 * triangles, at the same place but for the mesh's own roughness.
 *
 * Stiffness and friction belong to the material at HapticSettings::IsoValue. Surfaces hold without
 * limit; there is no drag. A tick takes at most MaximumPasses; if these do not suffice, the next
 * tick goes on.
 */
#ifndef SurfaceProxy_h
#define SurfaceProxy_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** The largest number of rounds of subgoal and motion in a tick. */
constexpr int MaximumPasses = 24;
/**
 * The largest number of the mesh's boxes that a tick visits: half a millisecond. The sphere then
 * stays at the point that it has reached.
 */
constexpr int MaximumVisits = 20000;
/**
 * A sphere that touches more boxes than this at once is too large to be felt: it would spend the
 * budget standing still.
 */
constexpr int MostTouched = MaximumVisits / 4;

/** Computes one tick from record.Tip; writes all of the record. The model must have a mesh. */
void StepSurfaceProxy(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept;

/** See Method::Reach. */
Vector3 FindSurfaceProxyReach(const HapticModel& model) noexcept;

/**
 * Returns the first position (device) of a proxy that another method has left at `place`.
 *
 * Triangles let no proxy through, not even outward. Other methods may leave the proxy inside the
 * isosurface: up to EntryDepth inside, it begins at the nearest position outside; a deeper proxy is
 * held from within. Samples a few hundred values, at a data time.
 */
Vector3 EnterSurface(const HapticModel& model, const Vector3& place, double time = 0.0) noexcept;

/**
 * Returns whether a position (device) is outside the isosurface at a data time, by the value there.
 * True if there is no isosurface.
 */
bool IsOutsideSurface(const HapticModel& model, const Vector3& place, double time = 0.0) noexcept;

/** The depth (kernel lengths) up to which a proxy begins outside. */
constexpr double EntryDepth = 3.0;

} // namespace VolumeHaptics

#endif
