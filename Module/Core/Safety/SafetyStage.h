// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The only way from a computed force to a device.
 *
 * In the order in which a force passes:
 * 1. A force, a torque or a tip that is not finite gives zero and a fault.
 * 2. A tip that is faster than the limit gives zero and a fault. The speed is taken between two
 *    measurements, by their own times. A device that runs away against its force (PortObserver.h)
 *    gives zero and a fault, too.
 * 3. The norm is clamped to the smaller of the device's and the user's maximum.
 * 4. The force is multiplied by the gate's share (ForceGate.h), and the growth of the force is
 *    limited (the slew limit). A force may fall at once. GrowthLimit.h keeps the account of both:
 *    work that the hand was spared on the way in is not given to it on the way out.
 * 5. If the loop swings by itself (EnergyObserver.h), it is damped (PortDamper.h). If that does not
 *    end it, the force fades, with a fault.
 *
 * The torque has its own stage with the same gate: TorqueStage.h. Stiffness and damping are capped
 * in the computation of the force: see HapticModel::Caps. Joint commands are scaled down together,
 * by the back end: SaturateTogether.
 *
 * No rule adds energy, and nothing grows faster than the slew limit allows. A fault and disarming
 * cut the force at once.
 *
 * If no sample and no sign of the device comes for WatchdogTime, the force retreats: the last force
 * falls to zero at MaximumForceRate, or faster, so that it is gone after 20 ms. A retreat goes on
 * to zero even if samples come back. It then follows the wanted force, by the same account, so that
 * it never pushes a hand that has moved on. After the loop itself stood still for WatchdogTime, the
 * force starts from zero.
 */
#ifndef SafetyStage_h
#define SafetyStage_h

#include "Core/Math/Vector3.h"
#include "Core/Safety/EnergyObserver.h"
#include "Core/Safety/ForceGate.h"
#include "Core/Safety/GrowthLimit.h"
#include "Core/Safety/PortDamper.h"
#include "Core/Safety/PortObserver.h"

namespace VolumeHaptics
{

struct SafetyLimits
{
  double MaximumForce = 0.0;       ///< N; 0 lets no force through
  double MaximumForceRate = 500.0; ///< N/s, the fastest growth
  double MaximumSpeed = 0.0;       ///< m/s; 0: no limit
  double RampTime = 0.5;           ///< s
  double WatchdogTime = 0.03;      ///< s
  /**
   * How long (s) the owner may be silent before the force fades out (ServoLoop::Attend); 0: without
   * limit.
   */
  double AttentionTime = 0.0;
  bool MovesTip = false;           ///< whether forces move the tip: see DeviceLimits
  double MaximumDamping = 0.0;     ///< N s/m, the largest that the device holds; 0: no limit
  double MaximumTorque = 0.0;      ///< N m; 0 lets no torque through: see TorqueStage.h
  double MaximumTorqueRate = 20.0; ///< N m/s, the fastest growth
};

/** The input of the stage in a tick. */
struct SafetyInput
{
  Vector3 Force;          ///< N, as computed
  double Stiffness = 0.0; ///< N/m, of the spring that pulls with the force; 0 if there is none
  double Stretch = 0.0;   ///< m, of the spring; Force may be less than it pulls
  Vector3 Drag;           ///< N, the purely dissipative part of the force, if known
  /**
   * J: the work of a moving surface on the spring that pulls the hand, if the whole force flows.
   */
  double WallWork = 0.0;
  bool IsNew = false;   ///< whether the force changed for another reason than the motion of the tip
  Vector3 Tip;          ///< m
  double Period = 1e-3; ///< s, nominal, for the slew limit and the ramp
  double Elapsed = 0.0; ///< s since the last tick, measured
  bool Fresh = false;   ///< whether the tip was measured for this tick
  bool Alive = false;   ///< whether the tip has not moved: see DeviceSample
  /**
   * The time (s) that a fresh tip took to get here, by the device's own clock; 0 if that time is
   * not known. The stage then uses the time since the last fresh tip.
   */
  double MotionTime = 0.0;
  double RoundTrip = 0.0; ///< s, measured; 0 if it is not known
  bool Lost = false;      ///< whether the device is gone
  Vector3 Torque;         ///< N m, as computed: only checked for finite numbers here
};

class SafetyStage
{
public:
  /**
   * Returns the force to send. Reports the stage's findings to the gate, and applies the gate's
   * share.
   */
  Vector3 Apply(const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept;

  /**
   * Resets the stage after ForceGate::Arm: forces grow from zero, and earlier motion of the tip
   * does not count.
   */
  void Reset() noexcept;

  /** Returns whether the force is damped, because the loop swings by itself. */
  bool IsDamping() const noexcept { return this->Damper.IsEngaged(); }

  /** Returns whether a wall feels softer than wanted until the tip leaves it: see GrowthLimit. */
  bool IsSoft() const noexcept { return this->Growth.IsSoft(); }

  /** Returns whether the last samples are older than the watchdog allows. */
  bool IsStale() const noexcept { return this->Stale; }

private:
  bool UpdateSamples(
    const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept;
  Vector3 ComputeCommand(
    const SafetyInput& input, const SafetyLimits& limits, bool gap, ForceGate& gate) noexcept;
  Vector3 Damp(const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits,
    const ForceGate& gate) noexcept;
  GrowthInput ComputeGrowth(const SafetyInput& input, const SafetyLimits& limits) const noexcept;
  Vector3 Retreat(const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept;
  double MeasureSpeed(const SafetyInput& input) noexcept;
  bool IsForceLeft() const noexcept;

  GrowthLimit Growth;
  PortObserver Observer;
  EnergyObserver Energy;
  PortDamper Damper;
  Vector3 LastCommand;    ///< N
  double LastShare = 0.0; ///< the gate's last share
  Vector3 LastTip;
  double SampleAge = 0.0; ///< s, age of the last fresh sample
  double Silence = 0.0;   ///< s, time without a sign of the device
  bool HasTip = false;
  bool Stale = false;
};

/**
 * Scales commands down together until the largest is within the limit, so that the direction stays.
 * All commands become zero if one is not finite.
 */
void SaturateTogether(double* commands, int count, double limit) noexcept;

} // namespace VolumeHaptics

#endif
