// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Spreads the release of a proxy over some milliseconds, so that the force does not jump within one
 * tick.
 *
 * Where a surface gives way, the law lets the proxy of the solver Precise leap to the next place
 * that holds it, and the force changes by newtons in one tick. The solver finds these places as
 * before, and continues from them. The hand, however, feels g = f + e: the force f of the law plus
 * a remainder e of the force before the leaps. A leap that changes f by L (TickRecord::Leap)
 * subtracts L from e, so that g does not jump. From then on e fades: in a tick of length dt, |e|
 * falls by
 *
 *   |e| dt/(tau + dt), but at most by FastestRelease dt,
 *
 * where tau is the ReleaseTime. The remainder affects neither the force that a wall holds nor the
 * instant at which the wall gives way. With the kernel's materials, as in the paper, only the force
 * of the law is felt.
 *
 * ## Steps
 *
 * Until e has faded, a tick changes g by at most max(FastestChange dt, k |dx|), whatever the law
 * does. Here, k is the spring's stiffness and dx the hand's step.
 *
 * ## Energy
 *
 * After a leap, the spring with the force g and the stiffness k contains the energy |g|^2/(2k),
 * which the hand has put in. If the spring's far end rests, g becomes h = g - k dx, and the spring
 * loses the work on the hand (computed with trapezoids, like the trace's Energy). Any other force
 * g' costs
 *
 *   (g' - h).(g' + g)/(2k),
 *
 * which is paid from energy that earlier ticks have saved in the same way. A tick changes h towards
 * its goal as far as the saved energy suffices. A release thus gives the hand at most the energy
 * that the spring contained before, as if it were released slowly. Both limits allow h, and
 * therefore all forces between h and the goal.
 */
#ifndef ProxyRelease_h
#define ProxyRelease_h

#include "Core/Model/HapticSettings.h"
#include "Core/State/TickRecord.h"

namespace VolumeHaptics
{

/** The remainder of the forces before leaps, and the energy that pays for its changes. */
struct ReleaseState
{
  Vector3 Force; ///< e, the remainder (N)
  /** Stiffness k (N/m) of the stiffest spring that has leapt; 0 if none has. */
  double Stiffness = 0.0;
  /** Energy (J) that the hand has put in, in addition to the energy in the spring of g. */
  double Saved = 0.0;
};

/** Limit (N/s) of the change of e. At 1 kHz, it is 0.15 N per tick. */
constexpr double FastestRelease = 150.0;
/** Limit (N/s) of the change of g while e fades. At 1 kHz, it is 0.24 N per tick. */
constexpr double FastestChange = 240.0;

/**
 * Adds the remainder to the force of a tick in which the tip has moved by `step` (m). Then moves
 * the proxy to the place from which a spring pulls with this force. Changes nothing if ReleaseTime
 * is 0.
 */
void ReleaseProxy(const HapticSettings& settings, const Vector3& step, ReleaseState& release,
  TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
