// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The slew limit of the force on the hand: forces grow slowly, fall at once, and give no energy
 * away.
 *
 * Only growth is limited. A limit on falls would hold the force after the tip has left a wall, and
 * push the hand out with energy that it never put in. Let W be the wanted force, w its direction, F
 * the force that is sent and F' the one sent before. Then F = s W with a share s from 0 to 1, and
 *
 *   |F| <= max(0, F'.w) + rate * period.                                                       (1)
 *
 * The new direction takes effect at once, and only the part of F' along it counts as being there
 * already: a force that is reversed starts from zero, one that turns by a few degrees a tick is not
 * held back.
 *
 * (1) alone still makes a stiff wall active: on the way in, where W rises faster than the rate, the
 * hand works against less than W, and on the way out it gets all of W back. So the limit keeps an
 * account of the contact, which begins where W is zero or turns by a right angle:
 *
 *   Work = the work of the hand against W,   Paid = its work against F,   dPaid = s dWork,
 *
 * both from the motion of the tip, and sends at most
 *
 *   s <= p(Paid / Work),   p(r) = 2 r / (1 + r).                                               (2)
 *
 * Where s = p(r), dr / d(ln Work) = p(r) - r = r (1 - r) / (1 + r), on the way in and out alike: on
 * the way out r runs back along the curve, and with Work reaches 0 but never falls below it. So
 * Paid stays positive: the hand never gets back more than it put in, whatever the wanted force is a
 * function of, up to the finite step of a tick: the share is also no more than takes all of Paid
 * where the next tick takes back as much of Work as this one. On the way in r rises to 1: pressing
 * on brings back what the limit took, and a still hand feels no change. For a spring, where Work =
 * k x^2 / 2, the stiffness of F is
 *
 *   k (p + 2 (p - r) dp/dr) <= k,
 *
 * which is why p is this function: the sampled loop is as stable with the limit as without. As long
 * as (1) has not held anything back, Paid = Work, s = 1, and F = W to the bit.
 *
 * A device may report slower than the servo ticks: then the tip stands for some ticks and leaps,
 * while the hand moved all the time, and s with it. For dPaid the least s since the tip last moved
 * counts where the hand has worked, and the largest where it gets work back, so that no share is
 * paid for that was not there.
 *
 * Work that friction, drag and yielding tissue have used up does not come back, and must not hide
 * what is owed to a spring that the tip meets later in the same contact. A source that knows how
 * much energy can come back says so, and Work and Paid are scaled down to that. One that knows its
 * drag says so, too, and the account is that of the rest: drag takes energy at any share. Of forces
 * that tell neither, drag counts as work that can come back.
 */
#ifndef GrowthLimit_h
#define GrowthLimit_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

class GrowthLimit
{
public:
  /**
   * For a force that was cut, or a tip whose motion is unknown: the next force grows from zero, in
   * a new contact.
   */
  void Reset() noexcept;

  /**
   * The force to send for a wanted one (N) with the tip at a place (m), at most `growth` (N) above
   * the last one. `recoverable` (J) is the most that the hand can get back from the wanted force;
   * negative if that is not known. `drag` (N) is the part of the wanted force that only takes
   * energy.
   */
  Vector3 Apply(const Vector3& wanted, const Vector3& tip, double growth, double recoverable,
    const Vector3& drag = {}) noexcept;

  /** Sends this instead of what Apply returned; in a new contact. */
  void Override(const Vector3& force) noexcept;

  /** The last force sent (N). */
  const Vector3& GetForce() const noexcept { return this->Sent; }

private:
  void Account(const Vector3& source, const Vector3& tip, double recoverable) noexcept;
  void BeginContact() noexcept;
  double FindMostShare() const noexcept;

  Vector3 Source; ///< N, what was wanted without drag
  Vector3 Sent;
  Vector3 Tip;
  bool HasTip = false;
  double LeastShare = 1.0; ///< of s, since the tip last moved
  double MostShare = 1.0;
  double Work = 0.0;   ///< J
  double Unpaid = 0.0; ///< J, Work - Paid: exactly 0 while nothing was held back
  double Return = 0.0; ///< J, what the hand got back of Work when the tip last moved
};

} // namespace VolumeHaptics

#endif
