// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Runs ticks in a region of a volume, where samples may be missing (Residency.h).
 */
#ifndef ResidentServo_h
#define ResidentServo_h

#include "Core/Field/TapMemory.h"
#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class ForceGate;
class HapticModel;
class ToolMemory;
struct LocalSurfaceResult;
struct ServoState;
struct TickRecord;

/**
 * Runs the ticks of a servo whose model may be a region, and sets the gate's opening (ForceGate.h)
 * according to the residency.
 *
 * The opening follows the residency up and down, at most from 0 to 1 in ForceGate::FadeTime. If
 * data for a tick are missing, the tick is not computed: the last force moves along with the tip
 * and fades, and then the proxy stays at the tip. When the data have arrived, a new force begins
 * there at zero. For models of whole volumes, this is the plain Tick() with an opening of 1.
 */
class ResidentServo
{
public:
  /**
   * Runs a tick of a period (s). Computes the whole force, before it is multiplied by the gate's
   * share. `record` contains the last tick's record, and receives the new one. `tool` is the same
   * as for VolumeHaptics::Tick().
   */
  void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, double period,
    TickRecord& record, const LocalSurfaceResult& result, ForceGate& gate,
    ToolMemory* tool = nullptr) noexcept;
  /** Runs a tick without a model. `period` is in s. */
  void Rest(double period, ForceGate& gate) noexcept;

  /** Returns whether missing data have reduced the force of the last tick. */
  bool IsAwaiting() const noexcept { return this->Awaits; }
  /** Returns whether the last tick was not computed, because too many data were missing. */
  bool LacksData() const noexcept { return this->Lacks; }

private:
  bool Awaits = false;
  bool Lacks = false;
  bool IsOut = false; ///< whether the old force must fade before a new one may begin
  Vector3 Force;      ///< the last force, while IsOut is true
  Vector3 Lag;        ///< proxy minus tip, while IsOut is true
  TickMemory Taps;    ///< samples of the last tick
};

} // namespace VolumeHaptics

#endif
