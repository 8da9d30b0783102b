// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The narrow interface between the servo and a haptic device.
 *
 * A back end does not depend on volumes, solvers or VTK: it reports the stylus and outputs a force.
 * Everything is in the device's own right-handed frame: metres, newtons, newton metres. To add a
 * vendor's library, derive a class from DeviceBackend.
 *
 * A stylus has axes of its own: it points along its -z, its handle is on the side of +z, and its
 * button on the side of +y. Its orientation is the rotation from the device's axes to the stylus's
 * axes. If the device's axes point right, up and towards the user, the handle of a stylus that is
 * not rotated points towards the user.
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

/** The abilities of a device, and the forces that it can take. */
struct DeviceLimits
{
  double MaximumForce = 0.0;     ///< largest force (N)
  double MaximumStiffness = 0.0; ///< largest stiffness (N/m); 0 if the device does not limit it
  double MaximumDamping = 0.0;   ///< largest damping (N s/m); 0 if the device does not limit it
  /// Largest speed of a tip (m/s) that a hand holds. A faster tip means that the hand has lost the
  /// stylus. 0 if there is no limit.
  double MaximumSpeed = 0.0;
  double Damping = 0.0;         ///< the device's own friction b (N s/m); 0 if it is not known
  double WorkspaceRadius = 0.0; ///< radius of the workspace (m)
  /// Smallest motion (m) that a device reports if it sends only changes and so is silent at rest. 0
  /// if it also reports at rest.
  double LeastMotion = 0.0;
  unsigned ForceAxes = 7;     ///< bit i is set if the device can exert a force along axis i
  bool MovesTip = true;       ///< whether forces move the tip, which PortObserver requires
  bool Vibrates = false;      ///< whether the device only vibrates and can't exert a force
  double MaximumTorque = 0.0; ///< largest torque (N m); 0 if the device exerts no torque
  /// Force (N) that the device gives for any time, if MaximumForce is a peak. 0 if it is not.
  double ContinuousForce = 0.0;
};

/** Round trip (s) for which devices state their largest stiffness and damping. */
constexpr double StatedRoundTrip = 1e-3;

/**
 * Computes the largest stiffness and damping that a device renders stably if forces are late by a
 * round trip of T (s, LoopTiming.h). These are the device's own limits, and a stiffness of 2 b / T,
 * because a stiffer sampled spring adds energy. If b is not known, it follows from the stated
 * limits: b = k T / 2, where k is the largest stated stiffness and T is StatedRoundTrip. The
 * largest damping decreases with 1 / T, too.
 */
inline ForceCaps CapsOf(const DeviceLimits& limits, double roundTrip) noexcept
{
  const double share = std::min(1.0, StatedRoundTrip / roundTrip);
  const double stated = (limits.Damping > 0.0 ? 1.0 : share) * limits.MaximumStiffness;
  const double sampled = 2.0 * limits.Damping / roundTrip;
  return { TighterCap(stated, sampled), share * limits.MaximumDamping };
}

/**
 * Raises the cap of stiffness by a gain above 1, for ForceAugmentation.h. The round trip of the
 * device must have been measured.
 */
inline ForceCaps Augmented(const ForceCaps& caps, double gain) noexcept
{
  return gain > 1.0 && caps.Stiffness > 0.0
    ? ForceCaps{ gain * caps.Stiffness, caps.Damping, caps.Stiffness }
    : caps;
}

/** A force that the device has received. Times are in ns of ServoClock. */
struct TakenForce
{
  /// DeviceSample::Time of the measurement from which the force was computed. 0 if the device does
  /// not report it; -1 if there was no force yet.
  std::int64_t Of = 0;
  std::int64_t At = 0;
};

/** The report of a device in a tick. */
struct DeviceSample
{
  Vector3 Tip;               ///< position of the tip (m)
  std::uint32_t Buttons = 0; ///< bit 0 is the main button
  bool Fresh = false;        ///< whether the tip was measured since the last Read
  /// Whether the device has shown since the last Read that it is connected and that the tip has not
  /// moved. For devices that are silent at rest. Always true if Fresh is true.
  bool Alive = false;
  /** Whether the hand has just taken the stylus up, so that earlier positions must be ignored. */
  bool Begins = false;
  /** Angular velocity (rad/s) at which the hand turns the view; zero for most devices. */
  Vector3 Turn;
  /// Time at which Tip was measured or, if that is not known, received by the computer, in ns of
  /// std::chrono::steady_clock, which is ServoClock. 0 means the time of Read.
  std::int64_t Time = 0;
  /**
   * The last force received. If the device does not report it, the time of Write's return is used.
   */
  TakenForce Taken;
  /// Orientation of the stylus (see above): a unit quaternion, w first. The servo divides it by its
  /// norm. It treats it as invalid if a number is not finite or if the norm differs from 1 by more
  /// than UnitTolerance.
  Quaternion Orientation;
  /** Whether Orientation is valid; false if the device does not measure it. */
  bool HasOrientation = false;
};

/** The force and torque to output in a tick. */
struct DeviceCommand
{
  Vector3 Force;  ///< force on the hand at the tip (N)
  Vector3 Torque; ///< torque on the hand about the tip (N m), for a tool with a shape
};

/** Result of a Read or a Write, for the servo loop in each tick. Users see DeviceStage instead. */
enum class DeviceState : std::uint8_t
{
  Running,  ///< reads and writes succeed
  NotReady, ///< not homed or not loaded yet: there is no position, and arming has no effect yet
  Finished, ///< the samples have ended, for example at the end of a replay
  Lost      ///< unplugged or broken; the back end has to be opened again
};

/** Stages of a device on its way to accepting forces, as displays show them. */
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
    Text{}; ///< instruction for the user, or the fault and its cure; may be empty
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
   * Open and close the device. Called outside the servo loop. Open returns false if the device
   * can't be opened, and writes the reason and the cure to `error`. Close sends zero force first. A
   * device that must be homed opens at once, and is NotReady until it is homed.
   */
  virtual bool Open(std::string& error) = 0;
  virtual void Close() = 0;
  virtual std::string GetName() const = 0;
  virtual DeviceLimits GetLimits() const = 0;
  /** Returns the device's condition. Called on the owner's thread, at any time. */
  virtual DeviceCondition GetCondition() { return {}; }
  /**
   * Returns a name that identifies this device when it is open: its kind and serial number, or its
   * kind and port if it has no serial number. The user's confirmations and calibrations are stored
   * under this name, unless KeepsIdentity returns false. Empty for a back end whose signs and
   * forces need no check.
   */
  virtual std::string GetIdentity() const { return {}; }
  /**
   * Returns whether GetIdentity identifies only this device. Returns false if another device may
   * have the same name, because this device reports neither a serial number nor its port. The
   * user's confirmation and calibration are then valid only until Close.
   */
  virtual bool KeepsIdentity() const { return true; }
  /**
   * Sets the ratio of the force that the device really exerts to the force that it is asked for.
   * Afterwards, forces and limits are in true newtons.
   */
  virtual void SetForceScale(double) noexcept {}
  /**
   * Homes the encoders again, for example after they have lost their zero. The device is NotReady
   * until that is done.
   */
  virtual void Home() noexcept {}
  /**
   * Sets the device's lights by bits. If the argument is negative (the default), the lights show
   * the device's own condition.
   */
  virtual void SetLights(int) noexcept {}
  ///@}

  ///@{
  /**
   * Read, Write and Send are called in the servo loop: no lock, no allocation, no exception, and no
   * wait beyond a fraction of the period. Each tick calls Read first, whose argument still has the
   * last sample's tip, orientation and HasOrientation, and then Send. A device without torque does
   * not override Send, but receives the force by Write.
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
   * thread does not respond.
   */
  virtual void Quench() noexcept = 0;
  /**
   * Returns whether the device has received the command of Quench. Called from any thread, after
   * Quench.
   */
  virtual bool IsAtRest() const noexcept { return true; }
};

} // namespace VolumeHaptics

#endif
