// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Touching a region of a volume that is somewhere else: how much of what a tick reads is there.
 *
 * A model of a region (VolumeView::Whole) knows which of its borders are the volume's own, where
 * surfaces fade (HapticModel::BorderFade), and which are merely the region's, where they must not.
 * At those it says how *resident* a tick is instead. With c the voxels between the region's border
 * and what the tick can read (kernels, x_s, x_v, and the way between tip and proxy), over all
 * borders that are not the volume's own,
 *
 *   residency = s(c / ResidencyBand),   s(t) = t^2 (3 - 2 t) on 0 ... 1,
 *
 * so that it is 1 well inside, 0 from where a tick could read what is not there, and everything is
 * true in between. Models of whole volumes have a residency of 1.
 */
#ifndef Residency_h
#define Residency_h

#include "Vector3.h"
#include "VolumeView.h"

namespace VolumeHaptics
{
class HapticModel;
struct HapticSettings;
struct LocalAnswer;
struct ServoState;
struct TickRecord;

/** Voxels over which the residency falls from 1 to 0. */
constexpr double ResidencyBand = 4.0;

/**
 * Voxels that a kernel reads beyond its radius, that a motion bulges out between tip and proxy, and
 * one to spare.
 */
constexpr double ResidencySpare = 3.0;

/** Where the samples of a region end and the volume goes on, in index steps. */
class ResidentBox
{
public:
  explicit ResidentBox(const VolumeView& view) noexcept;

  /** Whether there is nothing but these samples. */
  bool IsWhole() const noexcept { return this->Whole; }

  /** The residency of what lies between two corners, with a margin along each axis. */
  double Find(const Vector3& low, const Vector3& high, const Vector3& margin) const noexcept;

private:
  Vector3 Low; ///< infinite where the border is the volume's own
  Vector3 High;
  bool Whole = true;
};

/** How far (index steps along each axis) a tick reads around tip and proxy. */
Vector3 FindReadReach(const HapticModel& model) noexcept;

/** The residency of the tick that takes a state to a tip (device): 0 to 1. */
double FindResidency(
  const HapticModel& model, const ServoState& state, const Vector3& tip) noexcept;

/**
 * The ticks of a servo that may be on a region, and the share of their force that is to be felt.
 *
 * The share follows the residency by 1 in FadeTime at most, up and down. A tick whose data are not
 * there is not computed: the last force goes along with the tip and fades; once it is gone the
 * proxy is on the tip, and stays there. What is felt begins anew from there, without force, when
 * the data have come. For models of whole volumes all this is Tick() with a share of 1.
 */
class ResidentServo
{
public:
  static constexpr double FadeTime = 0.05; ///< s

  /**
   * One tick of a period (s). Computes the whole force, of which GetShare() is to be felt. The
   * record has to be that of the tick before.
   */
  void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, double period,
    TickRecord& record, const LocalAnswer& answer) noexcept;
  /** A tick of a period (s) without a model. */
  void Rest(double period) noexcept;

  double GetShare() const noexcept { return this->Share; }
  /** Whether the last tick's force was less since data were not there. */
  bool IsAwaiting() const noexcept { return this->Awaits; }

  ///@{
  /** Lets the share go to zero, data or not, until Recover. */
  void FadeOut() noexcept { this->FadesOut = true; }
  void Recover() noexcept { this->FadesOut = false; }
  bool IsFadingOut() const noexcept { return this->FadesOut; }
  /** Whether FadeOut has come to its end. */
  bool IsFadedOut() const noexcept { return this->FadesOut && this->Share == 0.0; }
  ///@}

  ///@{
  /** Lets the share go to zero in the same way for as long as this is on; at once where nothing is felt anyway. */
  void SetHeld(bool held) noexcept { this->Held = held; }
  bool IsHeld() const noexcept { return this->Held; }
  void DropShare() noexcept { this->Share = 0.0; }
  ///@}

private:
  void Follow(double target, double period) noexcept;

  double Share = 1.0;
  bool Awaits = false;
  bool IsOut = false; ///< what is felt has to end before anything is felt anew
  bool FadesOut = false;
  bool Held = false;
  Vector3 Force; ///< while IsOut: the last one
  Vector3 Lag;   ///< while IsOut: of the proxy behind the tip
};

} // namespace VolumeHaptics

#endif
