// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All computed forces pass this stage on their way to a device.
 *
 * A force passes these steps, in this order:
 * 1. If the force, the torque or the tip is not finite, the result is zero and a fault.
 * 2. If the tip is faster than the limit, the result is zero and a fault. The speed is computed
 *    from two measurements and their own times. If the device runs away against its force
 *    (PortObserver.h), the result is zero and a fault, too.
 * 3. The norm is clamped to the smaller of the device's and the user's maximum.
 * 4. The force is multiplied by the gate's share (ForceGate.h), and the growth of the force is
 *    limited (the slew limit). A force may fall at once. GrowthLimit.h keeps an account of both:
 *    work that the hand did not have to do on the way in is not given to it on the way out.
 * 5. If the user allows walls that are stiffer than the loop can render stably by itself, such a
 *    wall is damped, and its energy is limited by an account (ForceAugmentation.h).
 * 6. A pulse may be added at touch-down (ContactTransient.h).
 * 7. If the loop oscillates by itself (EnergyObserver.h), it is damped (PortDamper.h). If this does
 *    not end the oscillation, the force fades, with a fault.
 *
 * The torque has its own stage with the same gate (TorqueStage.h). Stiffness and damping are capped
 * where the force is computed (HapticModel::Caps). A back end scales down its joint commands
 * together (SaturateTogether).
 *
 * No rule adds energy, and no force grows faster than the slew limit allows. A fault or disarming
 * cuts the force at once.
 *
 * If neither a sample nor any sign of the device comes for WatchdogTime, the force retreats: the
 * last force falls to zero at MaximumForceRate, or faster, so that it is gone after 20 ms. A
 * retreat continues to zero even if samples return. It then follows the wanted force, with the same
 * account, so that it never pushes a hand that has moved on. After the loop itself has paused for
 * WatchdogTime, the force starts from zero.
 */
#ifndef SafetyStage_h
#define SafetyStage_h

#include "Core/Math/Vector3.h"
#include "Core/Safety/ContactTransient.h"
#include "Core/Safety/EnergyObserver.h"
#include "Core/Safety/ForceAugmentation.h"
#include "Core/Safety/ForceGate.h"
#include "Core/Safety/GrowthLimit.h"
#include "Core/Safety/PortDamper.h"
#include "Core/Safety/PortObserver.h"

namespace VolumeHaptics
{

struct SafetyLimits
{
  double MaximumForce = 0.0;       ///< largest force (N); with 0, no force is sent
  double MaximumForceRate = 500.0; ///< fastest growth of the force (N/s)
  double MaximumSpeed = 0.0;       ///< largest speed of the tip (m/s); 0 for no limit
  double RampTime = 0.5;           ///< duration of the ramp after Arm (s)
  double WatchdogTime = 0.03;      ///< time without samples (s) after which the force retreats
  /**
   * Time (s) for which the owner may be silent before the force fades out (ServoLoop::Attend). 0
   * for no limit.
   */
  double AttentionTime = 0.0;
  bool MovesTip = false;       ///< whether forces move the tip (DeviceLimits)
  double MaximumDamping = 0.0; ///< largest damping that the device renders (N s/m); 0 for no limit
  double MaximumTorque = 0.0;  ///< largest torque (N m); with 0, none is sent (TorqueStage.h)
  double MaximumTorqueRate = 20.0; ///< fastest growth of the torque (N m/s)
  double TransientGain = 0.0;      ///< gain of ContactTransient.h; 0 for no pulses
};

/** The inputs of the stage in a tick. */
struct SafetyInput
{
  Vector3 Force; ///< computed force (N)
  /** Stiffness (N/m) of the spring that pulls with the force; 0 without a spring. */
  double Stiffness = 0.0;
  double Stretch = 0.0; ///< stretch of the spring (m); its pull may exceed Force
  /**
   * Stiffness (N/m) with which the force grows if the stretch grows, if it is more than Stiffness.
   */
  double Slope = 0.0;
  /**
   * Stiffness (N/m) that the loop renders stably by itself, if Stiffness may be larger
   * (ForceAugmentation.h). Otherwise 0.
   */
  double Feedback = 0.0;
  Vector3 Drag; ///< purely dissipative part of the force (N), if it is known
  /**
   * Work (J) of a moving surface on the spring that pulls the hand, assuming that the whole force
   * is sent.
   */
  double WallWork = 0.0;
  /**
   * Frequency (Hz) of the pulse at the surface that holds the tip (ContactTransient.h); 0 without a
   * surface.
   */
  double Frequency = 0.0;
  bool IsNew = false;   ///< whether the force has changed for a reason other than the tip's motion
  Vector3 Tip;          ///< position of the tip (m)
  double Period = 1e-3; ///< nominal period (s), for the slew limit and the ramp
  double Elapsed = 0.0; ///< measured time since the last tick (s)
  bool Fresh = false;   ///< whether the tip was measured for this tick
  bool Alive = false;   ///< whether the tip is known not to have moved (DeviceSample::Alive)
  /**
   * Time (s) of the tip's motion from its last measured position, by the device's own clock. If it
   * is not known (0), the stage uses the time since the last fresh tip.
   */
  double MotionTime = 0.0;
  double RoundTrip = 0.0; ///< measured round trip (s); 0 if it is not known
  bool Lost = false;      ///< whether the device is lost
  Vector3 Torque;         ///< computed torque (N m); the stage only checks that it is finite
};

class SafetyStage
{
public:
  /**
   * Returns the force to send. Multiplies the input by the gate's share, and reports findings to
   * the gate.
   */
  Vector3 Apply(const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept;

  /**
   * Resets the stage after ForceGate::Arm, so that forces grow from zero and earlier motion of the
   * tip is ignored.
   */
  void Reset() noexcept;

  /** Returns whether the force is damped because the loop oscillates. */
  bool IsDamping() const noexcept { return this->Damper.IsEngaged(); }

  /**
   * Returns whether a wall feels softer than wanted. This lasts until the tip leaves the wall or
   * presses deeper (GrowthLimit.h).
   */
  bool IsSoft() const noexcept { return this->Growth.IsSoft(); }

  /** Returns whether the last samples are older than WatchdogTime. */
  bool IsStale() const noexcept { return this->Stale; }

private:
  bool UpdateSamples(
    const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept;
  Vector3 ComputeCommand(
    const SafetyInput& input, const SafetyLimits& limits, bool gap, ForceGate& gate) noexcept;
  void ObserveGains(const SafetyInput& input, const SafetyLimits& limits, bool finite) noexcept;
  Vector3 Augment(const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits,
    double share) noexcept;
  Vector3 AddTransient(const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits,
    double share) noexcept;
  Vector3 Damp(const Vector3& wall, const SafetyInput& input, const SafetyLimits& limits,
    const ForceGate& gate) noexcept;
  GrowthInput ComputeGrowth(const SafetyInput& input, const SafetyLimits& limits) const noexcept;
  Vector3 Retreat(const SafetyInput& input, const SafetyLimits& limits, ForceGate& gate) noexcept;
  double MeasureSpeed(const SafetyInput& input) noexcept;
  bool IsForceLeft() const noexcept;

  GrowthLimit Growth;
  PortObserver Observer;
  EnergyObserver Energy;
  ForceAugmentation Augmentation;
  ContactTransient Transient;
  PortDamper Damper;
  Vector3 LastCommand; ///< last force sent (N)
  ///@{
  /**
   * Last force (N) after Augment, and after AddTransient. If both are off, it equals the force of
   * Growth.
   */
  Vector3 Augmented;
  Vector3 Touched;
  ///@}
  bool Augments = false;  ///< whether Augmentation is in use
  bool Taps = false;      ///< whether Transient is in use
  Vector3 Pulse;          ///< part of the command that is a pulse of Transient (N)
  double LastShare = 0.0; ///< the gate's last share
  Vector3 LastTip;
  double SampleAge = 0.0; ///< time since the last fresh sample (s)
  double Silence = 0.0;   ///< time since the last sign of the device (s)
  bool HasTip = false;
  bool Stale = false;
};

/**
 * Reduces all commands by the same factor, so that the largest is within the limit and the
 * direction does not change. Sets all commands to zero if one of them is not finite.
 */
void SaturateTogether(double* commands, int count, double limit) noexcept;

} // namespace VolumeHaptics

#endif
