// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes the messages of Haply's Inverse service, without a connection.
 *
 * Written from Haply's public documentation (docs.haply.co/inverseSDK, version 3.5: "WebSocket
 * Protocol", "Simulation Channel", "Device Configuration", "Mount & Workspace", "Control Commands",
 * "Common Types", "Basis Permutation", "Events & Monitoring", "HTTP", tutorials 00 to 06; and
 * "Haply Inverse Service" of 3.0 and 3.1).
 *
 * The service answers each message with one message. Fields come in any order. A field with its
 * default value may be missing: a number is then 0, the w of an orientation 1, a button not
 * pressed. If a whole position is missing, it counts as not reported, because the documentation
 * states defaults only for the components of a transform. If a coordinate is present but is not a
 * number, its vector counts as not reported, and an arm's position or transform as spoilt. Services
 * of version 3.0 use maps from identifiers to devices instead of the later lists.
 *
 * JSON is parsed by nlohmann's header-only library. It copies values recursively, so input that is
 * nested deeper than any real message is refused. VTK's jsoncpp is not used, because this folder
 * must not depend on VTK, whose copy also has different names in Debian and in VTK's wheels.
 *
 * Haply's axes point right (x), forward (y) and up (z). ToDevice and FromDevice convert them to the
 * axes of DeviceBackend.h (right, up, towards the hand) and back. A grip points along its own y
 * axis.
 */
#ifndef HaplyMessages_h
#define HaplyMessages_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** The transform from the device's space to the session's space. */
struct HaplyTransform
{
  Vector3 Position; ///< m
  Quaternion Rotation;
  Vector3 Scale{ 1.0, 1.0, 1.0 };

  /** Returns whether the transform changes lengths, and thus the work of a force. */
  bool IsScaled() const noexcept;
  /**
   * Returns whether two transforms are equal except for the service's rounding to single precision.
   */
  bool IsNear(const HaplyTransform& other) const noexcept;
};

/** An Inverse3, Inverse3x or Minverse as described in a message. Vectors are along Haply's axes. */
struct HaplyArm
{
  /** Name of the list that contains the arm. Commands to the arm must use the same name. */
  std::string Family;
  std::string Id;
  std::string Type;                      ///< "inverse3", "inverse3x" or "minverse", if reported
  std::string Handedness;                ///< "left" or "right", if reported
  std::string Preset;                    ///< name of the arm's preset, if reported
  std::optional<Vector3> Position;       ///< m
  std::optional<Vector3> Velocity;       ///< m/s
  std::optional<Vector3> Force;          ///< force that the service currently applies (N)
  std::optional<Quaternion> Orientation; ///< orientation of the arm's body
  std::optional<HaplyTransform> Transform;
  /** Whether the position or the transform contains null, which the service writes for NaN. */
  bool IsSpoilt = false;
  ///@{
  /** Flags of the arm. A flag that was not reported is empty. */
  std::optional<bool> IsCalibrated;
  std::optional<bool> IsReady;
  std::optional<bool> IsInUse;
  ///@}
};

/** A VerseGrip, wired or wireless. */
struct HaplyGrip
{
  std::string Id;
  std::optional<Quaternion> Orientation; ///< orientation along Haply's axes
  std::uint32_t Buttons = 0;             ///< bits 0 to 3: a (or the only button), b, c, home
  bool IsAwake = true;
};

struct HaplyMessage
{
  std::vector<HaplyArm> Arms;
  std::vector<HaplyGrip> Grips;
};

/** The severity of an event, in the order of the documentation. */
enum class HaplyLevel : std::uint8_t
{
  Info,
  Notice,
  Warning,
  Error,
  Critical,
  Panic
};

struct HaplyEvent
{
  std::string Name; ///< such as "device-disconnected"
  HaplyLevel Level = HaplyLevel::Info;
  std::string Device; ///< identifier of the device if the event concerns one
  std::string Safety; ///< data.safety_type, such as "ebrake_triggered"
  std::string Text;   ///< text for the user
};

struct HaplyVersion
{
  int Major = 0;
  int Minor = 0;
  /// Returns whether the service has version 3.5 or later: sessions have a profile, devices have
  /// presets, and a force is sent as a "vector".
  bool IsNew() const noexcept { return this->Minor >= 5; }
  bool IsKnown() const noexcept { return this->Major == 3; }
};

///@{
/**
 * Parse a text into the second argument. Return nullptr, or the reason why the text is not valid;
 * the second argument must not be used then.
 */
const char* ReadHaplyMessage(const std::string& text, HaplyMessage& message);
const char* ReadHaplyEvent(const std::string& text, HaplyEvent& event);
const char* ReadHaplyVersion(const std::string& text, HaplyVersion& version);
///@}

/** The address of an arm, which each command contains. */
struct HaplyAddress
{
  HaplyVersion Version;
  std::string Family;
  std::string Id;
};

/** The preset that the greeting sets. Its origin is the centre of the workspace. */
extern const char* const HaplyCentredPreset;

/**
 * Writes the message that sets a force (N, in Haply's axes) and requests a state. With
 * `asksForAll`, it requests a full state, which includes the configuration.
 */
std::string WriteHaplyForce(
  const HaplyAddress& address, const Vector3& force, bool asksForAll = false);
/**
 * Writes the first message, which has no force, and requests a full state, which reports the preset
 * in use. For version 3.5 and later, the message also sets the session's profile, Haply's own axes
 * and the arm's origin, because the user may have changed axes and origin in Haply's Hub.
 */
std::string WriteHaplyGreeting(const HaplyAddress& address);

///@{
/** Convert between Haply's axes and the axes of DeviceBackend.h. */
constexpr Vector3 ToDevice(const Vector3& haply) noexcept
{
  return { haply.X, haply.Z, -haply.Y };
}
constexpr Vector3 FromDevice(const Vector3& device) noexcept
{
  return { device.X, -device.Z, device.Y };
}
/**
 * Converts the orientation of a grip, which points along its y axis, to that of a stylus, which
 * points along its -z axis.
 */
constexpr Quaternion ToDevice(const Quaternion& haply) noexcept
{
  return { haply.W, haply.X, haply.Z, -haply.Y };
}
///@}

} // namespace VolumeHaptics

#endif
