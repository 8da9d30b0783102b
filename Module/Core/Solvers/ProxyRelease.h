// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The release of a proxy, which takes some milliseconds instead of a tick.
 *
 * Where a surface gives way, the law lets the proxy of solver PRECISE leap to the next place that
 * holds it, and the force changes by newtons in one tick. The solver finds these places as before,
 * and goes on from them; the hand feels the force f of the law and a remainder e of the forces
 * before the leaps. A leap that changes f by L (TickRecord::Leap) subtracts L from e, so that f + e
 * goes on. From then on e fades, in a tick of dt by
 *
 *   |e| dt/(tau + dt), but no more than FastestRelease dt,
 *
 * with tau the ReleaseTime. What a wall holds, and when it gives way, does not depend on e. With
 * the kernel's materials, as the paper has them, the law alone is felt.
 *
 * ## Energy
 *
 * The law dissipates the energy of a spring that is released. Where the hand goes along with e, as
 * a hand that is on its way back when the proxy slides off a speck, it gets a part of this energy
 * back, and never more: the hand gets no energy that it has not put in. The work of e on the hand,
 * by trapezoids as the trace's Energy, is summed from the first leap on. Where it would exceed what
 * the springs have lost by the leaps (TickRecord::LeapEnergy), e loses the part along the hand's
 * step that would make it so.
 */
#ifndef ProxyRelease_h
#define ProxyRelease_h

#include "Core/Model/HapticSettings.h"
#include "Core/Solvers/TickRecord.h"

namespace VolumeHaptics
{

/** What remains of the forces before leaps. */
struct ReleaseState
{
  Vector3 Force;          ///< e, N
  double Stiffness = 0.0; ///< N/m, of the spring before the last leap
  double Absorbed = 0.0;  ///< J, that the leaps have lost and e has taken from the hand
};

/** N/s: at 1 kHz, 0.15 N in a tick. */
constexpr double FastestRelease = 150.0;

/**
 * Adds what remains to the force of a tick, in which the tip has moved by `step` (m), and shows the
 * proxy from which a spring pulls with it. A ReleaseTime of 0 changes nothing.
 */
void ReleaseProxy(const HapticSettings& settings, const Vector3& step, ReleaseState& release,
  TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif
