// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface between the servo and a haptic device.
 *
 * A back end does not depend on volumes, solvers or VTK. It only reports the stylus and outputs a
 * force, both in the device's own right-handed frame (metres, newtons, newton metres). To support a
 * vendor's library, derive a class from DeviceBackend.
 *
 * A stylus has its own axes: it points along its -z, its handle is on the side of +z, and its
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

/** The abilities of a device, and the limits of its forces. */
struct DeviceLimits
{
  double MaximumForce = 0.0;     ///< largest force (N)
  double MaximumStiffness = 0.0; ///< largest stiffness (N/m); 0 if the device does not limit it
  double MaximumDamping = 0.0;   ///< largest damping (N s/m); 0 if the device does not limit it
  /// Largest speed of the tip (m/s) while a hand holds the stylus. A faster tip means that the hand
  /// has lost it. 0 if there is no limit.
  double MaximumSpeed = 0.0;
  double Damping = 0.0;         ///< the device's own friction b (N s/m); 0 if it is not known
  double WorkspaceRadius = 0.0; ///< radius of the workspace (m)
  /// Smallest motion (m) that is reported by a device that sends only changes, and is therefore
  /// silent at rest. 0 if the device also reports at rest.
  double LeastMotion = 0.0;
  unsigned ForceAxes = 7;     ///< bit i is set if the device can exert a force along axis i
  bool MovesTip = true;       ///< whether forces move the tip, which PortObserver requires
  bool Vibrates = false;      ///< whether the device only vibrates and can't exert a force
  double MaximumTorque = 0.0; ///< largest torque (N m); 0 if the device exerts no torque
  /// Force (N) that the device can exert for any time, if MaximumForce is only a peak. Otherwise 0.
  double ContinuousForce = 0.0;
};

/** Round trip (s) for which vendors specify the largest stiffness and damping. */
constexpr double StatedRoundTrip = 1e-3;

/**
 * Computes the largest stiffness and damping that a device renders stably if forces are late by a
 * round trip of T (s, LoopTiming.h). The stiffness is limited by the device's own limit, and by 2 b
 * / T, because a stiffer sampled spring adds energy. If b is not known, it follows from the
 * specified limits: b = k T / 2, where k is the largest specified stiffness and T is
 * StatedRoundTrip. The largest damping decreases with 1 / T, too.
 */
inline ForceCaps CapsOf(const DeviceLimits& limits, double roundTrip) noexcept
{
  const double share = std::min(1.0, StatedRoundTrip / roundTrip);
  const double stated = (limits.Damping > 0.0 ? 1.0 : share) * limits.MaximumStiffness;
  const double sampled = 2.0 * limits.Damping / roundTrip;
  return { TighterCap(stated, sampled), share * limits.MaximumDamping };
}

/**
 * Multiplies the cap of stiffness by a gain above 1, for ForceAugmentation.h. The round trip of the
 * device must have been measured.
 */
inline ForceCaps Augmented(const ForceCaps& caps, double gain) noexcept
{
  return gain > 1.0 && caps.Stiffness > 0.0
    ? ForceCaps{ gain * caps.Stiffness, caps.Damping, caps.Stiffness }
    : caps;
}

/** A force that has reached the device. Times are in ns of ServoClock. */
struct TakenForce
{
  /// DeviceSample::Time of the measurement from which the force was computed. 0 if the device does
  /// not report it; -1 if there was no force yet.
  std::int64_t Of = 0;
  std::int64_t At = 0;
};

/** The data that a device reports in a tick. */
struct DeviceSample
{
  Vector3 Tip;               ///< position of the tip (m)
  std::uint32_t Buttons = 0; ///< bit 0 is the main button
  bool Fresh = false;        ///< whether the tip was measured since the last Read
  /// Whether the device has confirmed since the last Read that it is connected and that the tip has
  /// not moved. For devices that are silent at rest. Always true if Fresh is true.
  bool Alive = false;
  /** Whether the hand has just picked up the stylus, so that earlier positions must be ignored. */
  bool Begins = false;
  /** Angular velocity (rad/s) with which the hand turns the view; zero for most devices. */
  Vector3 Turn;
  /// Time at which Tip was measured or, if it is not known, received by the computer, in ns of
  /// std::chrono::steady_clock, which is ServoClock. 0 stands for the time of Read.
  std::int64_t Time = 0;
  /**
   * The last force that reached the device. If the device does not report it, the return of Write
   * counts as its arrival.
   */
  TakenForce Taken;
  /// Orientation of the stylus (see above): a unit quaternion, w first. The servo divides it by its
  /// norm. It is invalid if a number is not finite, or if the norm differs from 1 by more than
  /// UnitTolerance.
  Quaternion Orientation;
  /** Whether Orientation is valid. False if the device does not measure it. */
  bool HasOrientation = false;
};

/** The force and torque to output in a tick. */
struct DeviceCommand
{
  Vector3 Force;  ///< force on the hand at the tip (N)
  Vector3 Torque; ///< torque on the hand about the tip (N m), for a tool with a shape
};

/** Result of a Read or a Write in a tick, for the servo loop. Users see DeviceStage instead. */
enum class DeviceState : std::uint8_t
{
  Running,  ///< reads and writes succeed
  NotReady, ///< not homed or not loaded yet: there is no position, and arming has no effect yet
  Finished, ///< the samples have ended, for example at the end of a replay
  Lost      ///< unplugged or broken; the back end has to be opened again
};

/** Stages of a device until it accepts forces, as displays show them. */
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
    Text{}; ///< instruction for the user, or the fault and its remedy; may be empty
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
   * Open and close the device, outside the servo loop. Open returns false if the device can't be
   * opened, and writes the reason and the remedy to `error`. Close sends zero force first. A device
   * that must be homed can be opened, but reports NotReady until it is homed.
   */
  virtual bool Open(std::string& error) = 0;
  virtual void Close() = 0;
  virtual std::string GetName() const = 0;
  virtual DeviceLimits GetLimits() const = 0;
  /** Returns the device's condition. Called at any time on the owner's thread. */
  virtual DeviceCondition GetCondition() { return {}; }
  /**
   * Returns a name that identifies this device while it is open: its kind and serial number, or its
   * kind and port if it has no serial number. The user's confirmations and calibrations are stored
   * under this name, unless KeepsIdentity returns false. Empty if the signs and forces of this back
   * end need no check.
   */
  virtual std::string GetIdentity() const { return {}; }
  /**
   * Returns whether GetIdentity identifies only this device. If not, another device may have the
   * same name, because this one reports neither a serial number nor its port. The user's
   * confirmation and calibration are then valid only until Close.
   */
  virtual bool KeepsIdentity() const { return true; }
  /**
   * Sets the ratio of the force that the device really exerts to the requested force. Afterwards,
   * forces and limits are in true newtons.
   */
  virtual void SetForceScale(double) noexcept {}
  /**
   * Homes the encoders again, for example after they have lost their zero. The device is NotReady
   * until they are homed.
   */
  virtual void Home() noexcept {}
  /**
   * Sets the device's lights by bits. With a negative argument (the default), the lights show the
   * device's own condition.
   */
  virtual void SetLights(int) noexcept {}
  ///@}

  ///@{
  /**
   * Read, Write and Send are called in the servo loop. They must not lock, allocate, throw, or wait
   * for more than a fraction of the period. Each tick first calls Read, whose argument still
   * contains the last sample's tip, orientation and HasOrientation, and then Send. A device without
   * torque does not override Send, and receives the force by Write.
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
   * Returns whether the command of Quench has reached the device. Called from any thread, after
   * Quench.
   */
  virtual bool IsAtRest() const noexcept { return true; }
};

} // namespace VolumeHaptics

#endif
