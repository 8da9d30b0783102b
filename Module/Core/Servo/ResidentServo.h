// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ticks on a region of a volume, whose samples may not be there (Residency.h).
 */
#ifndef ResidentServo_h
#define ResidentServo_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class HapticModel;
struct LocalSurfaceResult;
struct ServoState;
struct TickRecord;

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
    TickRecord& record, const LocalSurfaceResult& result) noexcept;
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
  /**
   * Lets the share go to zero in the same way for as long as this is on; at once where nothing is
   * felt anyway.
   */
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
