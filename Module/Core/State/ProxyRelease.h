// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The release of a proxy, which takes some milliseconds instead of a tick.
 *
 * Where a surface gives way, the law lets the proxy of solver PRECISE leap to the next place that
 * holds it, and the force changes by newtons in one tick. The solver finds these places as before,
 * and goes on from them; the hand feels g = f + e: the force f of the law and a remainder e of the
 * forces before the leaps. A leap that changes f by L (TickRecord::Leap) subtracts L from e, so
 * that g goes on. From then on e fades, in a tick of dt by
 *
 *   |e| dt/(tau + dt), but no more than FastestRelease dt,
 *
 * with tau the ReleaseTime. What a wall holds, and when it gives way, does not depend on e. With
 * the kernel's materials, as the paper has them, the law alone is felt.
 *
 * ## Steps
 *
 * Until e has faded, a tick changes g by no more than max(FastestChange dt, k |dx|), with the
 * stiffness k of the spring and the hand's step dx, whatever the law does meanwhile.
 *
 * ## Energy
 *
 * The spring that has leapt, with the force g and the stiffness k, holds |g|^2/(2k), which the hand
 * has put in. If its end rests, g becomes h = g - k dx, and the work on the hand, by trapezoids as
 * the trace's Energy, is what the spring loses. Any other g' costs
 *
 *   (g' - h).(g' + g)/(2k),
 *
 * which is paid from what earlier ticks have saved so; a tick goes from h as far towards its goal
 * as that suffices. So a release gives the hand no more than the spring held before it, as if it
 * were released slowly. Both limits allow h, and therefore all places between h and the goal.
 */
#ifndef ProxyRelease_h
#define ProxyRelease_h

#include "Core/Model/HapticSettings.h"
#include "Core/State/TickRecord.h"

namespace VolumeHaptics
{

/** What remains of the forces before leaps. */
struct ReleaseState
{
  Vector3 Force;          ///< e, N
  double Stiffness = 0.0; ///< k, N/m, of the stiffest spring that has leapt; 0: nothing remains
  double Saved = 0.0;     ///< J, that the hand has put in and the spring of g does not hold
};

/** N/s, of e: at 1 kHz, 0.15 N in a tick. */
constexpr double FastestRelease = 150.0;
/** N/s, of g while e fades: at 1 kHz, 0.24 N in a tick. */
constexpr double FastestChange = 240.0;

/**
 * Adds what remains to the force of a tick, in which the tip has moved by `step` (m), and shows the
 * proxy from which a spring pulls with it. A ReleaseTime of 0 changes nothing.
 */
void ReleaseProxy(const HapticSettings& settings, const Vector3& step, ReleaseState& release,
  TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
