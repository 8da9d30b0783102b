// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ticks on a region of a volume, some of whose samples may be missing (Residency.h).
 */
#ifndef ResidentServo_h
#define ResidentServo_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class ForceGate;
class HapticModel;
struct LocalSurfaceResult;
struct ServoState;
struct TickRecord;

/**
 * The ticks of a servo that may be on a region, and the gate's opening (ForceGate.h) that goes with
 * the data.
 *
 * The opening follows the residency by 1 in ForceGate::FadeTime at most, up and down. A tick whose
 * data are missing is not computed: the last force goes along with the tip and fades; once it is
 * gone the proxy is on the tip, and stays there. When the data have come, the force begins anew
 * from there, at zero. For models of whole volumes all this is Tick() with an opening of 1.
 */
class ResidentServo
{
public:
  /**
   * One tick of a period (s). Computes the whole force, of which the gate's share is felt. The
   * record has to be that of the tick before.
   */
  void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, double period,
    TickRecord& record, const LocalSurfaceResult& result, ForceGate& gate) noexcept;
  /** A tick of a period (s) without a model. */
  void Rest(double period, ForceGate& gate) noexcept;

  /** Whether the last tick's force was less since data were missing. */
  bool IsAwaiting() const noexcept { return this->Awaits; }

private:
  bool Awaits = false;
  bool IsOut = false; ///< the force of before has to end before a new one begins
  Vector3 Force;      ///< while IsOut: the last one
  Vector3 Lag;        ///< while IsOut: proxy minus tip
};

} // namespace VolumeHaptics

#endif
