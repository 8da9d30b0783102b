// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the motion of a proxy through a field of primitives during a tick.
 *
 * The primitives of a mode are read at the proxy, so they change along its path: a flow turns, and
 * strengths rise and fall. Let b(x) be the balance of the primitives at x (PrimitiveSolver.h). Then
 * D(x) = b(x) - x is the rest of the motion, and the proxy is at rest where D = 0. With a single
 * step by D in each tick, the proxy would leave a bent line along its tangent, and drift. The proxy
 * therefore follows the lines of D: along the lines of the flow as far as the spring pulls along
 * them, and across them where the spring exceeds the local strength.
 *
 * ## Steps
 *
 * A step follows D/|D| by Ralston's method of third order, whose stages are at 0, 1/2 and 3/4 of
 * the step. It is at most a quarter of a voxel long: on a circle of 20 voxels, the proxy leaves its
 * line by less than 0.001 voxels in a hundred turns. The length of the last step is |D|/r, where r
 * is the rate at which D falls along the path: 1 in a uniform field, and less or more where lines
 * bend around the tip or strengths change. r is learned from step to step. A step that proves too
 * long at its middle is restarted, because a rising strength would hold the proxy where it went too
 * far. The end of a step is moved by up to a tenth to the place where D ends according to the
 * stages, so that one step in a tick is usually enough. Where primitives yield, the rest across the
 * path after such a step follows a known rule that determines its rate, so that one more evaluation
 * completes it. Other corrections are short, and use the midpoint method with the same limit. The
 * motion ends when D is less than FinishedFraction of a step. After MostSteps, or if the sweeps of
 * a tick are used up, the next tick continues. The force then belongs to the balance at the place
 * reached, so that it never exceeds the strengths.
 */
#ifndef PrimitiveFollower_h
#define PrimitiveFollower_h

#include "Core/Solvers/Primitives/PrimitiveSolver.h"

namespace VolumeHaptics
{

/** The primitives as a function of the place. Does not own the context. */
struct PrimitiveField
{
  /**
   * Adds the primitives at a place (m) to an empty set. The place is the anchor of most of them.
   */
  using Function = void (*)(const void* context, const Vector3& place, PrimitiveSet& set) noexcept;
  Function Collect = nullptr;
  const void* Context = nullptr;
};

struct PrimitiveMotion
{
  Vector3 Proxy; ///< position (m)
  Vector3 Force; ///< force on the hand (N)
  int Steps = 0;
  bool IsUnfinished = false; ///< whether the tick made all its steps without reaching the balance
};

namespace PrimitiveFollower
{
constexpr int MostSteps = 32;
/** A step shorter than this fraction of the longest step uses the midpoint method. */
constexpr double ShortFraction = 0.1;
/** A last step shorter than this fraction of the longest step needs no stages. */
constexpr double FinishedFraction = 1e-3;
} // namespace PrimitiveFollower

/**
 * Distance (voxels) by which a mode's push, or a bent line, can move the proxy out of the box
 * around proxy and tip.
 */
constexpr double ModeWay = 0.25 * PrimitiveFollower::MostSteps;

/**
 * Computes the proxy's motion from a place (m) to the balance with a tip (m).
 *
 * @param longestStep a quarter of a voxel (m)
 *
 * If the tip is not finite, or if k or longestStep is not a positive number, the result is the tip.
 */
PrimitiveMotion SolvePrimitives(const PrimitiveField& field, double k, double longestStep,
  const Vector3& from, const Vector3& tip, PrimitiveMemory& memory) noexcept;

} // namespace VolumeHaptics

#endif
