// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The polygonal surface haptics that the paper compares itself with: a sphere that no triangle lets
 * through.
 *
 * After Ruspini, Kolarov and Khatib, "The Haptic Display of Complex Graphical Environments", 1997.
 * The proxy is a sphere of radius HapticSettings::ProxyRadius round x. Every triangle it touches
 * gives a half-space; the subgoal y is the point of all these that is nearest to the tip. Friction
 * takes mu times what the surfaces hold,
 *
 *   x' = x + (y - x) max(0, 1 - mu |x_tip - y| / |y - x|),
 *
 * and the sphere goes there or to the first triangle on its way, again and again, until it does not
 * move. It never overlaps what it did not overlap before: there is no way through, at any speed.
 *
 * With ForceShading the half-spaces are first taken with the normals that are interpolated between
 * the points', and the subgoal of these is the goal of the true ones: the force turns smoothly over
 * a coarse mesh.
 *
 * Where it overlaps a triangle, since it began there or the mesh came, it is as large as its
 * distance: nothing throws it out, and nothing holds it but what it would go deeper into.
 *
 * Stiffness and friction are those of the material at HapticSettings::IsoValue. Surfaces hold
 * without limit; there is no drag. A tick takes MaximumPasses; if these do not do, the next one
 * goes on.
 */
#ifndef SurfaceProxy_h
#define SurfaceProxy_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class HapticModel;
struct ServoState;
struct TickRecord;

/** Rounds of subgoal and motion in a tick, at most. */
constexpr int MaximumPasses = 24;
/**
 * Boxes of the mesh that a tick looks at, at most: half a millisecond. Then the sphere stays where
 * it came to.
 */
constexpr int MaximumVisits = 20000;
/**
 * A sphere that touches more than this at once is too large to be felt: it would use that up
 * standing still.
 */
constexpr int MostTouched = MaximumVisits / 4;

/** One tick from record.Tip; writes all of the record. The model must have a mesh. */
void StepSurfaceProxy(
  const HapticModel& model, const ServoState& state, TickRecord& record) noexcept;

/**
 * Where the proxy (device) begins that another method has left at a place. As nothing is let
 * through, out again neither, one that is up to EntryDepth inside the isosurface, where other
 * methods may be, begins on the nearest outside of it; deeper ones are held from within. Looks at a
 * few hundred values.
 */
Vector3 EnterSurface(const HapticModel& model, const Vector3& place) noexcept;

/** In lengths of the kernel. */
constexpr double EntryDepth = 3.0;

} // namespace VolumeHaptics

#endif
