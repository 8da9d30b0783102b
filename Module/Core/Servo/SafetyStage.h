// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The only way from a computed force to a device.
 *
 * In the order in which a force passes:
 * 1. A force or a tip that is not finite gives zero and a fault.
 * 2. The norm is clamped to the smaller of the device's and the user's maximum.
 * 3. Where data are not there, only as much of that is taken as the residency says (Residency.h).
 * 4. The growth of the force is limited (the slew limit, GrowthLimit.h). Where it falls, it falls
 * at once. 5. Stiffness and damping are capped where the force is computed: see
 * HapticSettings::Caps. 6. Joint commands are scaled down together, by the back end:
 * SaturateTogether. 7. A tip faster than the limit gives zero and a fault. 8. After arming, and
 * after every gap in the tip's samples, forces rise from zero over RampTime.
 *
 * Residency and ramp are applied before the slew limit, so that nothing that leaves grows faster
 * than it allows. A fault and disarming cut the force at once. Without fresh samples for
 * WatchdogTime the force retreats: it goes down to zero at MaximumForceRate, in 20 ms at most, also
 * if samples come back meanwhile, but is then no more than what is wanted along it; after a pause
 * of the loop that long it starts from zero. A force that fades out (ResidentServo::FadeOut) goes
 * down by its share, without a step. A fault holds until Arm.
 */
#ifndef SafetyStage_h
#define SafetyStage_h

#include "Core/Math/Vector3.h"
#include "Core/Servo/GrowthLimit.h"

#include <cstdint>

namespace VolumeHaptics
{

enum class SafetyFault : std::uint8_t
{
  None,
  NotFinite,
  OverSpeed,
  DeviceLost,
  Unattended ///< nobody looked after the loop, see SafetyLimits::AttentionTime
};

struct SafetyLimits
{
  double MaximumForce = 0.0;       ///< N; nothing leaves at 0
  double MaximumForceRate = 500.0; ///< N/s, of growth
  double MaximumSpeed = 0.0;       ///< m/s; 0 does not limit
  double RampTime = 0.5;           ///< s
  double WatchdogTime = 0.03;      ///< s
  /**
   * How long (s) the owner may be silent before the loop lets go (ServoLoop::Attend); 0: for ever.
   */
  double AttentionTime = 0.0;
};

/** What the stage needs to know of a tick. */
struct SafetyInput
{
  Vector3 Force;          ///< N, as computed
  double Stiffness = 0.0; ///< N/m, of the spring that the force is the pull of; 0 if there is none
  double Stretch = 0.0;   ///< m, of that spring, whose pull may have been clamped already
  Vector3 Drag;           ///< N, the part of the force that only takes energy, if that is known
  Vector3 Tip;            ///< m
  double Residency = 1.0; ///< 0 to 1; the share of the force that is to be felt
  double Period = 1e-3;   ///< s, nominal: what the slew limit and the ramp go by
  double Elapsed = 0.0;   ///< s since the last tick, measured
  bool Fresh = false;     ///< the tip was measured for this tick
  bool Lost = false;      ///< the device is gone
};

class SafetyStage
{
public:
  /** The force to send. */
  Vector3 Apply(const SafetyInput& input, const SafetyLimits& limits) noexcept;

  /** Forget a fault and start the ramp. */
  void Arm() noexcept;
  /** Let the force rise again as after Arm, with what else holds. */
  void RestartRamp() noexcept { this->Ramp = 0.0; }
  /** No force from the next Apply on. */
  void Disarm() noexcept { this->Armed = false; }
  /**
   * A fault that is found elsewhere: no force from the next Apply on. Nothing where none could
   * flow.
   */
  void Trip(SafetyFault fault) noexcept
  {
    if (this->Armed && this->Fault == SafetyFault::None)
    {
      this->Fault = fault;
    }
  }

  bool IsArmed() const noexcept { return this->Armed; }
  SafetyFault GetFault() const noexcept { return this->Fault; }
  /** Whether the last samples are older than the watchdog allows. */
  bool IsStale() const noexcept { return this->Stale; }
  /** Whether the force goes down to zero, or stays there, since samples did not come. */
  bool IsRetreating() const noexcept { return this->Retreats; }

private:
  Vector3 Cut() noexcept;
  Vector3 Retreat(const SafetyInput& input, const SafetyLimits& limits) noexcept;
  double MeasureSpeed(const SafetyInput& input) noexcept;

  GrowthLimit Growth;
  Vector3 LastTip;
  double SampleAge = 0.0;
  double Ramp = 0.0;
  bool HasTip = false;
  bool Armed = false;
  bool Stale = false;
  bool Retreats = false; ///< goes down to zero, whatever is wanted
  SafetyFault Fault = SafetyFault::None;
};

/**
 * Scales commands down together until the largest is within the limit: the direction is kept. All
 * are zero where one is not finite.
 */
void SaturateTogether(double* commands, int count, double limit) noexcept;

} // namespace VolumeHaptics

#endif
