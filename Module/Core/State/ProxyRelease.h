// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The release of a proxy, spread over some milliseconds instead of one tick.
 *
 * Where a surface gives way, the law lets the proxy of solver PRECISE leap to the next place that
 * holds it, and the force changes by newtons in one tick. The solver finds these places as before,
 * and goes on from them; the hand feels g = f + e: the force f of the law plus a remainder e of the
 * force before the leaps. A leap that changes f by L (TickRecord::Leap) subtracts L from e, so that
 * g goes on. From then on e fades, in a tick of dt by
 *
 *   |e| dt/(tau + dt), but at most FastestRelease dt,
 *
 * with tau the ReleaseTime. The force that a wall holds, and when it gives way, do not depend on e.
 * With the kernel's materials, as in the paper, the law alone is felt.
 *
 * ## Steps
 *
 * Until e has faded, a tick changes g by at most max(FastestChange dt, k |dx|), with the stiffness
 * k of the spring and the hand's step dx, whatever the law does meanwhile.
 *
 * ## Energy
 *
 * The spring that has leapt, with the force g and the stiffness k, holds |g|^2/(2k), which the hand
 * has put in. If its end rests, g becomes h = g - k dx, and the work on the hand, by trapezoids as
 * the trace's Energy, is what the spring loses. Any other g' costs
 *
 *   (g' - h).(g' + g)/(2k),
 *
 * which is paid from the energy that earlier ticks have saved in this way; a tick goes from h
 * towards its goal as far as the savings suffice. So a release gives the hand at most the energy
 * that the spring held before, as if it were released slowly. Both limits allow h, and therefore
 * all places between h and the goal.
 */
#ifndef ProxyRelease_h
#define ProxyRelease_h

#include "Core/Model/HapticSettings.h"
#include "Core/State/TickRecord.h"

namespace VolumeHaptics
{

/** The remainder of the forces before leaps. */
struct ReleaseState
{
  Vector3 Force;          ///< e, N
  double Stiffness = 0.0; ///< k, N/m, of the stiffest spring that has leapt; 0: none
  double Saved = 0.0;     ///< J put in by the hand, beyond the energy in the spring of g
};

/** N/s, the fastest change of e: at 1 kHz, 0.15 N in a tick. */
constexpr double FastestRelease = 150.0;
/** N/s, the fastest change of g while e fades: at 1 kHz, 0.24 N in a tick. */
constexpr double FastestChange = 240.0;

/**
 * Adds the remainder to the force of a tick, in which the tip has moved by `step` (m), and sets the
 * proxy to the place from which a spring pulls with that force. A ReleaseTime of 0 changes nothing.
 */
void ReleaseProxy(const HapticSettings& settings, const Vector3& step, ReleaseState& release,
  TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
