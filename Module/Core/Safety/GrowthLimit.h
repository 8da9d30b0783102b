// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limits the growth of the force on the hand (slew limit), and keeps an energy account of
 * everything that lowers a force. Forces thus grow slowly, may fall at once, and give no energy to
 * the hand.
 *
 * Only growth is limited. If falls were limited, too, the force would continue after the tip has
 * left a wall, and push the hand out with energy that it never put in. Let W be the wanted force, w
 * its direction, F the force that is sent, and F' the one sent before. Then F = s W, where the
 * share s is between 0 and the gate's share (ForceGate.h), and
 *
 *   |F| <= max(0, F'.w) + rate * period.                                                       (1)
 *
 * The new direction takes effect at once, and only the component of F' along it counts as present.
 * A reversed force therefore starts from zero, and a force that turns by a few degrees per tick is
 * not held back.
 *
 * With (1) alone, a stiff wall would still add energy. On the way in, W rises faster than the rate,
 * so the hand works against less than W; on the way out, it gets all of W back. The gate's share
 * has the same effect if it rises while the hand presses. The limit therefore keeps an account of
 * each contact, which begins when W is zero or turns by a right angle:
 *
 *   Work = the work of the hand against W,   Paid = its work against F,   dPaid = s dWork,
 *
 * both computed from the motion of the tip, and sends at most
 *
 *   s <= p(Paid / Work),   p(r) = 2 r / (1 + r).                                               (2)
 *
 * If s = p(r), then dr / d(ln Work) = p(r) - r = r (1 - r) / (1 + r), both on the way in and on the
 * way out. On the way out, r returns along the same curve, and reaches 0 together with Work. Paid
 * therefore never becomes negative: the hand never gets back more than it put in, whatever the
 * wanted force is. Because a tick is a finite step, s is limited further: if the next tick takes
 * back as much of Work as this one did, Paid must suffice for it. On the way in, r rises to 1:
 * pressing on restores the force that the limit has held back, and a hand at rest feels no change.
 * For a spring, with Work = k x^2 / 2, the stiffness of F is
 *
 *   k (p + 2 (p - r) dp/dr) <= k.
 *
 * This is the reason for the choice of p: the sampled loop is as stable with the limit as without
 * it. Until some force is held back, Paid = Work, s = 1, and F = W to the bit. A wall that was
 * pressed while the gate's share was small stays soft until the tip leaves it or presses deeper.
 *
 * A device may report more slowly than the servo ticks. The tip then seems to rest for some ticks
 * and to leap, although the hand moved all the time, and s has changed in these ticks. To count at
 * most the work that the hand really did, dPaid uses the smallest s since the last measurement if
 * the hand did work, and the largest s if it got work back. This includes the s of the previous
 * tick, because a force may take a tick to reach the hand.
 *
 * Work that was used up by friction, drag and yielding tissue does not come back, and must not hide
 * the debt to a spring that the tip meets later in the same contact. A source that knows how much
 * energy can come back therefore passes it as `recoverable`, and Work and Paid are scaled down to
 * it. A source that knows its drag passes it, too, and the account leaves it out, because drag
 * takes energy at any share. If a source passes neither, its drag counts as work that can come
 * back.
 */
#ifndef GrowthLimit_h
#define GrowthLimit_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** A wanted force and the data by which its growth is limited. */
struct GrowthInput
{
  Vector3 Wanted; ///< the wanted force (N)
  Vector3 Drag;   ///< purely dissipative part of Wanted (N), if it is known
  Vector3 Tip;    ///< position of the tip (m)
  /** Whether the tip was measured since the last Apply, even if it did not move. */
  bool IsMeasured = false;
  double Share = 1.0;  ///< fraction of Wanted that may be sent, 0 to 1
  double Growth = 0.0; ///< largest growth of the force over the last one (N)
  /** Largest energy (J) that the hand can get back from Wanted; negative if it is not known. */
  double Recoverable = -1.0;
};

class GrowthLimit
{
public:
  /**
   * Resets the limit after a force was cut, or if the motion of the tip is unknown. The next force
   * grows from zero in a new contact.
   */
  void Reset() noexcept;

  /**
   * Returns the force to send: at most `Share` of the wanted force, and at most `Growth` more than
   * the last force.
   */
  Vector3 Apply(const GrowthInput& input) noexcept;

  /**
   * Records that a smaller force in the direction of the last one was sent. The contact continues,
   * but the tip counts as unknown until the next Apply.
   */
  void Lower(const Vector3& force) noexcept;

  /**
   * Returns whether the account holds back more than a tenth of the wanted force. This happens if
   * the hand did less work on the way in and has not pressed deeper since.
   */
  bool IsSoft() const noexcept { return this->ComputeMostShare() < 0.9; }

  /** Returns the last force sent (N). */
  const Vector3& GetForce() const noexcept { return this->Sent; }

private:
  void Account(const Vector3& source, const Vector3& tip, double recoverable) noexcept;
  void BeginContact() noexcept;
  double ComputeMostShare() const noexcept;

  Vector3 Source; ///< the wanted force without drag (N)
  Vector3 Sent;
  Vector3 Tip;
  bool HasTip = false;
  double LeastShare = 1.0; ///< smallest s since the last measurement of the tip
  double MostShare = 1.0;  ///< largest s since the last measurement of the tip
  double LastShare = 1.0;  ///< s of the last tick
  double Work = 0.0;       ///< work (J) of the hand against the wanted force W
  double Unpaid = 0.0;     ///< Work - Paid (J); exactly 0 until some force is held back
  double Return = 0.0;     ///< part of Work (J) that the hand got back when the tip last moved
};

} // namespace VolumeHaptics

#endif
