// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file The slew limit of the force on the hand, and the energy account of everything that lowers a
 * force: forces grow slowly, fall at once, and give no energy to the hand.
 *
 * Only growth is limited. A limit on falls would hold the force after the tip has left a wall, and
 * push the hand out with energy that it never put in. Let W be the wanted force, w its direction, F
 * the force that is sent and F' the one sent before. Then F = s W with a share s from 0 to 1, at
 * most the gate's (ForceGate.h), and
 *
 *   |F| <= max(0, F'.w) + rate * period.                                                       (1)
 *
 * The new direction takes effect at once, and only the part of F' along it counts as present: a
 * force that is reversed starts from zero, one that turns by a few degrees a tick is not held back.
 *
 * (1) alone still makes a stiff wall active. On the way in W rises faster than the rate, so the
 * hand works against less than W; on the way out it gets all of W back. The gate's share does the
 * same if it rises while the hand presses. So the limit keeps an account of the contact, which
 * begins when W is zero or turns by a right angle:
 *
 *   Work = the work of the hand against W,   Paid = its work against F,   dPaid = s dWork,
 *
 * both from the motion of the tip, and sends at most
 *
 *   s <= p(Paid / Work),   p(r) = 2 r / (1 + r).                                               (2)
 *
 * If s = p(r), then dr / d(ln Work) = p(r) - r = r (1 - r) / (1 + r), on the way in and out alike.
 * On the way out r runs back along the same curve, and reaches 0 together with Work. So Paid never
 * becomes negative: the hand never gets back more than it put in, for any wanted force. A tick is a
 * finite step, so s is limited once more: if the next tick takes back as much of Work as this one
 * did, Paid must suffice for it. On the way in r rises to 1: pressing on brings back the force that
 * the limit took, and a still hand feels no change. For a spring, with Work = k x^2 / 2, the
 * stiffness of F is
 *
 *   k (p + 2 (p - r) dp/dr) <= k,
 *
 * which is why p is this function: the sampled loop is as stable with the limit as without. Until
 * something is held back, Paid = Work, s = 1, and F = W to the bit. A wall that was pressed while
 * the gate's share was small stays soft until the tip leaves it or presses deeper.
 *
 * A device may report more slowly than the servo ticks. The tip then stands still for some ticks
 * and leaps, although the hand moved all the time, and s has changed meanwhile. So dPaid takes the
 * least s since the tip was last measured if the hand did work, and the largest if it got work
 * back: the account never counts more than the hand really put in. The s of the tick before is
 * among them, since a force may take a tick to reach the hand.
 *
 * Work that friction, drag and yielding tissue have used up does not come back, and must not hide
 * the debt to a spring that the tip meets later in the same contact. So a source that knows how
 * much energy can come back gives it as `recoverable`, and Work and Paid are scaled down to it. A
 * source that knows its drag gives it, too, and the account leaves it out: drag takes energy at any
 * share. If a source gives neither, its drag counts as work that can come back.
 */
#ifndef GrowthLimit_h
#define GrowthLimit_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** A wanted force, with the values that the limit needs. */
struct GrowthInput
{
  Vector3 Wanted;          ///< N
  Vector3 Drag;            ///< N, the purely dissipative part of Wanted, if known
  Vector3 Tip;             ///< m
  bool IsMeasured = false; ///< whether the tip was measured since the last Apply, even if it rests
  double Share = 1.0;      ///< the share of Wanted that may be sent: 0 to 1
  double Growth = 0.0;     ///< N, the largest growth above the last force
  /** The most energy (J) that the hand can get back from Wanted; negative if it is not known. */
  double Recoverable = -1.0;
};

class GrowthLimit
{
public:
  /**
   * Resets the limit after a force was cut, or if the motion of the tip is unknown: the next force
   * grows from zero, in a new contact.
   */
  void Reset() noexcept;

  /**
   * Returns the force to send: at most `Share` of the wanted force, and at most `Growth` above the
   * last force.
   */
  Vector3 Apply(const GrowthInput& input) noexcept;

  /**
   * Records that a smaller force in the direction of the last force was sent. The contact goes on;
   * the tip is unknown until the next Apply.
   */
  void Lower(const Vector3& force) noexcept;

  /**
   * Returns whether the account holds back more than a tenth of the wanted force, because the hand
   * was spared work on the way in and has not pressed deeper since.
   */
  bool IsSoft() const noexcept { return this->ComputeMostShare() < 0.9; }

  /** Returns the last force sent (N). */
  const Vector3& GetForce() const noexcept { return this->Sent; }

private:
  void Account(const Vector3& source, const Vector3& tip, double recoverable) noexcept;
  void BeginContact() noexcept;
  double ComputeMostShare() const noexcept;

  Vector3 Source; ///< N, the wanted force without drag
  Vector3 Sent;
  Vector3 Tip;
  bool HasTip = false;
  double LeastShare = 1.0; ///< smallest s since the tip was last measured
  double MostShare = 1.0;  ///< largest s since the tip was last measured
  double LastShare = 1.0;  ///< the last s
  double Work = 0.0;       ///< J
  double Unpaid = 0.0;     ///< J, Work - Paid: exactly 0 until something is held back
  double Return = 0.0;     ///< J, the part of Work that the hand got back when the tip last moved
};

} // namespace VolumeHaptics

#endif
