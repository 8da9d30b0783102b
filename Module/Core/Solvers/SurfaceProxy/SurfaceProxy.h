// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Polygonal surface haptics, with which the paper compares its method: a sphere that does not pass
 * through triangles.
 *
 * After Ruspini, Kolarov and Khatib, "The Haptic Display of Complex Graphical Environments", 1997.
 * The proxy is a sphere of radius HapticSettings::ProxyRadius around x. Each triangle that it
 * touches defines a half-space. The subgoal y is the point in all half-spaces that is nearest to
 * the tip. Friction holds mu times the lag that the surfaces hold,
 *
 *   x' = x + (y - x) max(0, 1 - mu |x_tip - y| / |y - x|),
 *
 * and the sphere moves there or to the first triangle that it meets. This is repeated until it
 * stands still. The sphere never begins to overlap a triangle, so that no speed moves it through a
 * surface.
 *
 * With ForceShading, the half-spaces first have normals that are interpolated between the points'
 * normals. Their subgoal is then the goal for the true half-spaces. So the direction of the force
 * changes smoothly over a coarse mesh.
 *
 * If the sphere overlaps a triangle because it began there or because the mesh is new, its radius
 * shrinks to the triangle's distance. So nothing pushes it out, and surfaces only keep it from
 * going deeper.
 *
 * If the volume moves, triangles move from each time step to the next one along straight lines
 * (SurfaceMesh.h). Before a tick, each approaching triangle pushes the sphere to the triangle's
 * side on which the sphere is. If displacements are known, the nearest triangle that the sphere
 * touches also moves it sideways, as far as friction then holds it there. In the next time step the
 * surface has other triangles, which are at the same place except for the mesh's own roughness.
 *
 * Stiffness and friction are those of the material at HapticSettings::IsoValue. Surfaces hold
 * forces of any size, and there is no drag. A tick has at most MaximumPasses passes. If they do not
 * suffice, the next tick continues.
 */
#ifndef SurfaceProxy_h
#define SurfaceProxy_h

#include "Core/Solvers/Method.h"

namespace VolumeHaptics
{

/** Limit of the rounds of subgoal and motion in a tick. */
constexpr int MaximumPasses = 24;
/**
 * Limit of the mesh's boxes that a tick visits, which take half a millisecond. When it is reached,
 * the sphere stays where it is.
 */
constexpr int MaximumVisits = 20000;
/**
 * Number of boxes that a sphere may touch at once. A larger sphere can't be felt, because it would
 * use up the budget without moving.
 */
constexpr int MostTouched = MaximumVisits / 4;

/** Computes a tick for record.Tip, and writes the whole record. The model must have a mesh. */
void StepSurfaceProxy(
  const HapticModel& model, ServoState& state, TickRecord& record, const MethodInput&) noexcept;

/** Returns Method::Reach. */
Vector3 FindSurfaceProxyReach(const HapticModel& model) noexcept;

/**
 * Returns the first position (device) of a proxy that another method has left at `place`.
 *
 * Triangles do not let a proxy through, not even outward. Other methods, however, may leave the
 * proxy inside the isosurface. If it is not deeper than EntryDepth, it begins at the nearest
 * position outside; if it is deeper, surfaces hold it inside. Reads a few hundred values at a data
 * time.
 */
Vector3 EnterSurface(const HapticModel& model, const Vector3& place, double time = 0.0) noexcept;

/**
 * Returns whether the volume's value at a position (device) and data time is on the outer side of
 * the isovalue. Returns true if there is no isosurface.
 */
bool IsOutsideSurface(const HapticModel& model, const Vector3& place, double time = 0.0) noexcept;

/** Depth (kernel lengths) up to which a proxy begins outside the isosurface. */
constexpr double EntryDepth = 3.0;

} // namespace VolumeHaptics

#endif
