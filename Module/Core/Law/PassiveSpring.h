// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A spring whose stiffness changes with the tissue without adding energy to the hand.
 *
 * Let the proxy rest at a distance d from the tip. If the tissue's stiffness K rises there, using
 * the new K at once would store energy that the hand has not put in (T15 in
 * Documentation/evaluation.md). To avoid this, the force stays the same, and the spring gets slack
 * s,
 *
 *   |f| = K (|d| - s)   for |d| > s, else 0,
 *
 * so that the new stiffness is felt when the hand presses on. If K falls, the stretch |d| - s stays
 * the same, and the spring loses energy, which is added to a reserve. The reserve pays for later
 * rises first, so that sliding over uneven tissue does not wear the force down. The stored energy K
 * (|d| - s)^2 / 2 plus the reserve rises only by the hand's work. Slack and reserve end with the
 * contact.
 */
#ifndef PassiveSpring_h
#define PassiveSpring_h

#include <algorithm>

namespace VolumeHaptics
{

struct PassiveSpring
{
  double Tissue = 0.0;  ///< K, the tissue's stiffness (N/m)
  double Tension = 1.0; ///< stretch / |d|; 1 without slack
  double Reserve = 0.0; ///< energy in J that pays for later rises of K

  /** Returns f / |d| in N/m; at most the tissue's stiffness. */
  double GetEffective() const noexcept { return std::max(this->Tension, Least) * this->Tissue; }

  /**
   * Changes the stretch when the tip moves and its distance from the proxy changes from one length
   * (m) to another.
   */
  void Stretch(double from, double to) noexcept
  {
    if (this->Tension < 1.0)
    {
      const double slack = (1.0 - this->Tension) * from;
      this->Tension = to > slack ? 1.0 - slack / to : (to > 0.0 ? 0.0 : 1.0);
    }
  }

  /**
   * Sets the tissue's stiffness (N/m) when the proxy passes into other tissue. d (m) is the tip's
   * present distance.
   */
  void Pass(double stiffness, double d) noexcept
  {
    const double before = this->Tissue;
    const double stretch = this->Tension * d;
    this->Tissue = stiffness;
    const double gained = 0.5 * (stiffness - before) * stretch * stretch;
    if (gained <= this->Reserve)
    {
      this->Reserve -= gained;
      return;
    }
    // Keep the stretch as far as the reserve pays for it. Beyond that, keep the force.
    const double paid = before + 2.0 * this->Reserve / (stretch * stretch);
    this->Tension *= paid / stiffness;
    this->Reserve = 0.0;
  }

  /** Ends the contact: removes slack and reserve, and sets the tissue's stiffness (N/m). */
  void Relax(double stiffness) noexcept
  {
    this->Tissue = stiffness;
    this->Tension = 1.0;
    this->Reserve = 0.0;
  }

  /** Discards the reserve, so that earlier falls do not pay for later rises. */
  void DropReserve() noexcept { this->Reserve = 0.0; }

  /**
   * Smallest tension in use. It keeps the law's quotients finite if the whole distance is slack.
   */
  static constexpr double Least = 1e-6;
};

} // namespace VolumeHaptics

#endif
