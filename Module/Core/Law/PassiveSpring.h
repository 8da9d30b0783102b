// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A spring whose stiffness follows the tissue without giving energy to the hand.
 *
 * Let the proxy rest at a distance d from the tip. If the tissue's stiffness K rises there, k = K
 * at once would store energy that the hand has not put in (T15 in Documentation/evaluation.md). So
 * a rise keeps the force instead: the spring gets slack s,
 *
 *   |f| = K (|d| - s)   for |d| > s, else 0,
 *
 * and pressing on is felt with the new stiffness. A fall of K keeps the stretch |d| - s and loses
 * energy, which goes to a reserve. A later rise is first paid from the reserve, so that sliding
 * over uneven tissue does not wear the force down. The stored energy K (|d| - s)^2 / 2 plus the
 * reserve rises only by the hand's work. Slack and reserve end with the contact.
 */
#ifndef PassiveSpring_h
#define PassiveSpring_h

#include <algorithm>

namespace VolumeHaptics
{

struct PassiveSpring
{
  double Tissue = 0.0;  ///< K, N/m
  double Tension = 1.0; ///< stretch / |d|
  double Reserve = 0.0; ///< J

  /** Returns f / |d| in N/m; at most the tissue's stiffness. */
  double GetEffective() const noexcept { return std::max(this->Tension, Least) * this->Tissue; }

  /** Follows the tip: d grows or shrinks from one length (m) to another. */
  void Stretch(double from, double to) noexcept
  {
    if (this->Tension < 1.0)
    {
      const double slack = (1.0 - this->Tension) * from;
      this->Tension = to > slack ? 1.0 - slack / to : (to > 0.0 ? 0.0 : 1.0);
    }
  }

  /** Takes over the tissue's stiffness (N/m) at the proxy, with the tip d (m) away. */
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
    // The stretch stays as far as the reserve pays for it; beyond that, the force stays.
    const double paid = before + 2.0 * this->Reserve / (stretch * stretch);
    this->Tension *= paid / stiffness;
    this->Reserve = 0.0;
  }

  /** Ends the contact: no slack, no reserve. */
  void Relax(double stiffness) noexcept
  {
    this->Tissue = stiffness;
    this->Tension = 1.0;
    this->Reserve = 0.0;
  }

  /** Discards the energy that falls have lost so far, so that it does not pay for later rises. */
  void DropReserve() noexcept { this->Reserve = 0.0; }

  /** Keeps the law's quotients finite if the spring is all slack. */
  static constexpr double Least = 1e-6;
};

} // namespace VolumeHaptics

#endif
