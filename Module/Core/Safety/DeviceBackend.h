// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The narrow interface between the servo and a haptic device.
 *
 * A back end knows nothing of volumes, solvers or VTK: it reports the stylus and takes a force.
 * Everything is in the device's space: metres, newtons, newton metres, a right-handed frame of the
 * device's own. Vendor libraries are added by deriving from this class.
 *
 * A stylus has axes of its own: it points along its -z, so that its handle is on the side of +z,
 * and its button is on the side of +y. Its orientation is the turn from the device's axes to these.
 * On a device whose axes point right, up and towards the user, a stylus that is not turned has its
 * handle towards the user.
 */
#ifndef DeviceBackend_h
#define DeviceBackend_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"
#include "Core/Model/ForceCaps.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** The limits of a device. */
struct DeviceLimits
{
  double MaximumForce = 0.0;     ///< N
  double MaximumStiffness = 0.0; ///< N/m; 0 if the device does not limit it
  double MaximumDamping = 0.0;   ///< N s/m; 0 if the device does not limit it
  /// m/s; a faster tip means that the hand has lost the stylus; 0: no limit
  double MaximumSpeed = 0.0;
  double Damping = 0.0;         ///< N s/m, the device's own friction b; 0 if it is not known
  double WorkspaceRadius = 0.0; ///< m
  /// m: a device that reports only what is new is silent unless it moves by this; 0 if it also
  /// reports at rest
  double LeastMotion = 0.0;
  unsigned ForceAxes = 7;     ///< bit i: it can push along axis i
  bool MovesTip = true;       ///< its forces move the tip, so that PortObserver can judge them
  bool Vibrates = false;      ///< it can't push: it vibrates when the force changes
  double MaximumTorque = 0.0; ///< N m; 0 if it gives none
};

/** The round trip (s) for which devices state the largest stiffness and damping that they hold. */
constexpr double StatedRoundTrip = 1e-3;

/**
 * The largest stiffness and damping that a device holds if forces are late by a round trip of T (s,
 * LoopTiming.h): its own limits, and a stiffness of 2 b / T, above which a sampled spring feeds
 * energy in. If b is not known, that which the device states stands for it: b = k T / 2 with its
 * largest k and the T of StatedRoundTrip. The largest damping falls with 1 / T, too.
 */
inline ForceCaps CapsOf(const DeviceLimits& limits, double roundTrip) noexcept
{
  const double share = std::min(1.0, StatedRoundTrip / roundTrip);
  const double stated = (limits.Damping > 0.0 ? 1.0 : share) * limits.MaximumStiffness;
  const double sampled = 2.0 * limits.Damping / roundTrip;
  return { TighterCap(stated, sampled), share * limits.MaximumDamping };
}

/** A force that the device has taken: which one, and when. Times are in ns of ServoClock. */
struct TakenForce
{
  /// DeviceSample::Time of the measurement that it answers; 0: the device can't tell; -1: none yet
  std::int64_t Of = 0;
  std::int64_t At = 0;
};

/** The report of a device in a tick. */
struct DeviceSample
{
  Vector3 Tip;               ///< m
  std::uint32_t Buttons = 0; ///< bit 0 is the main one
  bool Fresh = false;        ///< news: measured since the last Read
  /// Since the last Read, the device has shown that it is there and has nothing new to say: the tip
  /// is known to be where it was. For devices that are silent at rest; Fresh says as much.
  bool Alive = false;
  bool Begins = false; ///< the stylus is taken up here; earlier positions mean nothing
  Vector3 Turn;        ///< rad/s: how fast the hand asks the view to turn; zero for most devices
  /// ns of std::chrono::steady_clock, which is ServoClock: when Tip was measured, or else, when the
  /// computer got it; 0 stands for Read
  std::int64_t Time = 0;
  TakenForce Taken; ///< the last one; of a device that can't tell, when Write returned counts
  /// Of the stylus, see above: a unit quaternion, w first. The servo divides it by its norm, and
  /// takes it as not valid if that is not 1 within UnitTolerance, or if a number is not finite.
  Quaternion Orientation;
  bool HasOrientation = false; ///< Orientation is valid; false for a device that measures none
};

/** The order to a device in a tick. */
struct DeviceCommand
{
  Vector3 Force;  ///< N, on the hand at the tip
  Vector3 Torque; ///< N m, on the hand about the tip, of a tool with a shape
};

/** For the servo loop, each tick: what came of a Read or a Write. DeviceStage is for people. */
enum class DeviceState : std::uint8_t
{
  Running,  ///< reads and writes succeed
  NotReady, ///< not homed or not loaded yet: there is no position, and arming has no effect
  Finished, ///< nothing more will come, for example at the end of a replay
  Lost      ///< unplugged or broken; the back end has to be opened again
};

/** For people, now and then: how far a device is from taking forces. */
enum class DeviceStage : std::uint8_t
{
  Firmware, ///< its firmware is being loaded
  Homing,   ///< its encoders wait for the hand
  Ready,
  Lost ///< unplugged or broken
};

/** The condition of a device, with a text for the user. */
struct DeviceCondition
{
  DeviceStage Stage = DeviceStage::Ready;
  std::array<char, 320>
    Text{}; ///< the request to the hand, or the fault and the cure; may be empty
};

class DeviceBackend
{
public:
  DeviceBackend() = default;
  virtual ~DeviceBackend() = default;
  DeviceBackend(const DeviceBackend&) = delete;
  DeviceBackend& operator=(const DeviceBackend&) = delete;

  ///@{
  /**
   * Outside the servo loop. Open returns false, with the reason and the cure, if the device can't
   * be opened; Close sends zero force first. A device that has to be homed opens at once, and is
   * NotReady until it is homed.
   */
  virtual bool Open(std::string& error) = 0;
  virtual void Close() = 0;
  virtual std::string GetName() const = 0;
  virtual DeviceLimits GetLimits() const = 0;
  /** At any time, from the owner's thread. */
  virtual DeviceCondition GetCondition() { return {}; }
  /**
   * A name that this very device keeps, such as its kind and serial number, or its kind and port if
   * it has none, once it is open. The user's confirmations and calibrations are remembered under
   * it, unless KeepsIdentity is false. Empty for a back end whose signs and newtons are right by
   * themselves.
   */
  virtual std::string GetIdentity() const { return {}; }
  /**
   * Whether GetIdentity names this very device. False if another device may have that name, since
   * this one tells neither a serial number nor its port: then the user's confirmation and
   * calibration hold until Close.
   */
  virtual bool KeepsIdentity() const { return true; }
  /**
   * The newtons that the device really gives for each newton that it is asked for, as the user has
   * measured it. From then on forces and limits are true newtons.
   */
  virtual void SetForceScale(double) noexcept {}
  /**
   * Looks for the zero of the encoders again, for example after they lost it: NotReady until then.
   */
  virtual void Home() noexcept {}
  /** Bits of the device's lights; below zero (the default) the device shows its own condition. */
  virtual void SetLights(int) noexcept {}
  ///@}

  ///@{
  /**
   * Once a tick each, in the servo loop: no lock, no allocation, no exception, and no wait beyond a
   * fraction of the period. Read comes first; the sample that it gets has the tip, the orientation
   * and its validity of the last one. The loop calls Send; a device without torque leaves it as it
   * is, and takes the force by Write.
   */
  virtual DeviceState Read(double period, DeviceSample& sample) noexcept = 0;
  virtual DeviceState Write(const Vector3& force) noexcept = 0;
  virtual DeviceState Send(const DeviceCommand& command) noexcept
  {
    return this->Write(command.Force);
  }
  ///@}

  /**
   * From any thread, if the servo thread does not answer: no force and no torque from now on until
   * Write or Send is called again.
   */
  virtual void Quench() noexcept = 0;
  /** From any thread, after Quench: whether the device has got the order. */
  virtual bool IsAtRest() const noexcept { return true; }
};

} // namespace VolumeHaptics

#endif
