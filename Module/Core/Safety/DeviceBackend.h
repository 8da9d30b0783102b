// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The narrow interface between the servo and a haptic device.
 *
 * A back end does not depend on volumes, solvers or VTK: it reports the stylus and takes a force.
 * Everything is in the device's space: metres, newtons, newton metres, in the device's own
 * right-handed frame. Vendor libraries are added by deriving from this class.
 *
 * A stylus has its own axes: it points along its -z, with the handle on the side of +z and the
 * button on the side of +y. Its orientation is the rotation from the device's axes to the stylus's
 * axes. On a device whose axes point right, up and towards the user, a stylus that is not turned
 * has its handle towards the user.
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
  /// The smallest motion (m) that a device reports if it sends only what is new, so that it is
  /// silent at rest; 0 if it also reports at rest.
  double LeastMotion = 0.0;
  unsigned ForceAxes = 7;     ///< bit i is set if the device can push along axis i
  bool MovesTip = true;       ///< whether forces move the tip, so that PortObserver can judge them
  bool Vibrates = false;      ///< whether the device can't push, but only vibrates
  double MaximumTorque = 0.0; ///< N m; 0 if the device gives no torque
};

/** The round trip (s) to which the largest stiffness and damping that devices state refer. */
constexpr double StatedRoundTrip = 1e-3;

/**
 * Computes the largest stiffness and damping that a device holds if forces are late by a round trip
 * of T (s, LoopTiming.h): its own limits, and a stiffness of 2 b / T, above which a sampled spring
 * feeds energy in. If b is not known, the stated limits of the device give it: b = k T / 2 with the
 * largest stated k and the T of StatedRoundTrip. The largest damping falls with 1 / T, too.
 */
inline ForceCaps CapsOf(const DeviceLimits& limits, double roundTrip) noexcept
{
  const double share = std::min(1.0, StatedRoundTrip / roundTrip);
  const double stated = (limits.Damping > 0.0 ? 1.0 : share) * limits.MaximumStiffness;
  const double sampled = 2.0 * limits.Damping / roundTrip;
  return { TighterCap(stated, sampled), share * limits.MaximumDamping };
}

/** A force that the device has taken. Times are in ns of ServoClock. */
struct TakenForce
{
  /// DeviceSample::Time of the measurement that the force answers; 0: the device can't tell; -1: no
  /// force yet
  std::int64_t Of = 0;
  std::int64_t At = 0;
};

/** The report of a device in a tick. */
struct DeviceSample
{
  Vector3 Tip;               ///< m
  std::uint32_t Buttons = 0; ///< bit 0 is the main button
  bool Fresh = false;        ///< whether the tip was measured since the last Read
  /// Since the last Read, the device has shown that it is connected and that the tip has not moved.
  /// For devices that are silent at rest; always true if Fresh is.
  bool Alive = false;
  bool Begins = false; ///< the stylus is taken up here; earlier positions mean nothing
  Vector3 Turn;        ///< rad/s: how fast the hand asks the view to turn; zero for most devices
  /// ns of std::chrono::steady_clock, which is ServoClock: when Tip was measured or, if that is not
  /// known, when the computer received it; 0 stands for the time of Read
  std::int64_t Time = 0;
  TakenForce Taken; ///< the last force taken; if the device can't tell, the return of Write counts
  /// The stylus's orientation (see above): a unit quaternion, w first. The servo divides it by its
  /// norm, and treats it as invalid if the norm is not 1 within UnitTolerance, or if a number is
  /// not finite.
  Quaternion Orientation;
  bool HasOrientation = false; ///< whether Orientation is valid; false if the device measures none
};

/** The order to a device in a tick. */
struct DeviceCommand
{
  Vector3 Force;  ///< N, on the hand at the tip
  Vector3 Torque; ///< N m, on the hand about the tip, for a tool with a shape
};

/**
 * The result of a Read or a Write, for the servo loop in each tick. DeviceStage is the condition
 * that users see.
 */
enum class DeviceState : std::uint8_t
{
  Running,  ///< reads and writes succeed
  NotReady, ///< not homed or not loaded yet: there is no position, and arming has no effect
  Finished, ///< no more samples will come, for example at the end of a replay
  Lost      ///< unplugged or broken; the back end has to be opened again
};

/** How far a device is from accepting forces, for displays. */
enum class DeviceStage : std::uint8_t
{
  Firmware, ///< the device's firmware is being loaded
  Homing,   ///< the encoders wait until the hand moves them
  Ready,
  Lost ///< unplugged or broken
};

/** The condition of a device, with a text for the user. */
struct DeviceCondition
{
  DeviceStage Stage = DeviceStage::Ready;
  std::array<char, 320>
    Text{}; ///< what the user has to do, or the fault and the cure; may be empty
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
   * Open and Close the device; called outside the servo loop. If the device can't be opened, Open
   * returns false and writes the reason and the cure to `error`. Close sends zero force first. A
   * device that has to be homed opens at once, and is NotReady until it is homed.
   */
  virtual bool Open(std::string& error) = 0;
  virtual void Close() = 0;
  virtual std::string GetName() const = 0;
  virtual DeviceLimits GetLimits() const = 0;
  /** Returns the device's condition. Called at any time, from the owner's thread. */
  virtual DeviceCondition GetCondition() { return {}; }
  /**
   * Returns a name that identifies this device, once it is open: its kind and serial number, or its
   * kind and port if it has no serial number. The user's confirmations and calibrations are stored
   * under this name, unless KeepsIdentity is false. Empty for a back end whose signs and newtons
   * need no check.
   */
  virtual std::string GetIdentity() const { return {}; }
  /**
   * Returns whether GetIdentity identifies this device only. False if another device may have the
   * same name, because this device reports neither a serial number nor its port; the user's
   * confirmation and calibration then hold until Close.
   */
  virtual bool KeepsIdentity() const { return true; }
  /**
   * Sets how many newtons the device really gives for each newton that it is asked for. Forces and
   * limits are true newtons after that.
   */
  virtual void SetForceScale(double) noexcept {}
  /**
   * Homes the encoders again, for example after they lost their zero. The device is NotReady until
   * then.
   */
  virtual void Home() noexcept {}
  /**
   * Sets the device's lights by bits; if negative (the default), they show the device's own
   * condition.
   */
  virtual void SetLights(int) noexcept {}
  ///@}

  ///@{
  /**
   * Each is called once in a tick, in the servo loop: no lock, no allocation, no exception, and no
   * wait beyond a fraction of the period. Read is called first; its argument still has the last
   * sample's tip, orientation and HasOrientation. The loop calls Send; a device without torque does
   * not override it, and takes the force by Write.
   */
  virtual DeviceState Read(double period, DeviceSample& sample) noexcept = 0;
  virtual DeviceState Write(const Vector3& force) noexcept = 0;
  virtual DeviceState Send(const DeviceCommand& command) noexcept
  {
    return this->Write(command.Force);
  }
  ///@}

  /**
   * Ends force and torque until Write or Send is called again. Called from any thread if the servo
   * thread does not answer.
   */
  virtual void Quench() noexcept = 0;
  /**
   * Returns whether the device has received the order of Quench. Called from any thread, after
   * Quench.
   */
  virtual bool IsAtRest() const noexcept { return true; }
};

} // namespace VolumeHaptics

#endif
