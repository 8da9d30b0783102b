// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Ticks on a region of a volume, some of whose samples may be missing (Residency.h).
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
 * Runs the ticks of a servo that may work on a region, and sets the gate's opening (ForceGate.h) by
 * the residency.
 *
 * The opening follows the residency, by 1 in ForceGate::FadeTime at most, up and down. If the data
 * of a tick are missing, the tick is not computed: the last force moves along with the tip and
 * fades. Then the proxy stays on the tip. When the data have come, a new force begins there, at
 * zero. For models of whole volumes this is Tick() with an opening of 1.
 */
class ResidentServo
{
public:
  /**
   * Runs one tick of a period (s). Computes the whole force, of which the gate's share is felt.
   * `record` holds the record of the last tick, and receives the new record; `tool` is as for
   * VolumeHaptics::Tick.
   */
  void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, double period,
    TickRecord& record, const LocalSurfaceResult& result, ForceGate& gate,
    ToolMemory* tool = nullptr) noexcept;
  /** Runs a tick of a period (s) without a model. */
  void Rest(double period, ForceGate& gate) noexcept;

  /** Returns whether missing data reduced the last tick's force. */
  bool IsAwaiting() const noexcept { return this->Awaits; }
  /** Returns whether so many data were missing that the last tick was not computed. */
  bool LacksData() const noexcept { return this->Lacks; }

private:
  bool Awaits = false;
  bool Lacks = false;
  bool IsOut = false; ///< whether the old force has to end before a new one begins
  Vector3 Force;      ///< while IsOut: the last force
  Vector3 Lag;        ///< while IsOut: proxy minus tip
  TickMemory Taps;    ///< memory of the last tick
};

} // namespace VolumeHaptics

#endif
