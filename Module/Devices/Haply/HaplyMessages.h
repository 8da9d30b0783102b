// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The messages of Haply's Inverse service, without a connection.
 *
 * Written from Haply's public documentation (docs.haply.co/inverseSDK, version 3.5: "WebSocket
 * Protocol", "Simulation Channel", "Device Configuration", "Mount & Workspace", "Control Commands",
 * "Common Types", "Basis Permutation", "Events & Monitoring", "HTTP", tutorials 00 to 06; and
 * "Haply Inverse Service" of 3.0 and 3.1).
 *
 * The service answers each message with one message. Fields come in any order. A field that has its
 * default may be missing: a number is then 0, the w of an orientation 1, a button not pressed. A
 * position that is missing as a whole counts as not reported, because the documentation gives
 * defaults only for the parts of a transform. A coordinate that is there and is no number has no
 * default: its vector counts as not reported, and an arm's position or transform as spoilt.
 * Services of 3.0 have maps from identifiers to devices where later ones have lists.
 *
 * JSON is read by nlohmann's library: headers only. Its copies recurse, so input that is nested
 * deeper than any message is refused. VTK's jsoncpp is not used: this room does not depend on VTK,
 * whose copy has other names in Debian than in its wheels.
 *
 * Haply's axes point right (x), forward (y) and up (z). ToDevice and FromDevice turn them into
 * those of DeviceBackend.h (right, up, towards the hand) and back. A grip points along its own y.
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

/** The map from the device's space to the session's space. */
struct HaplyTransform
{
  Vector3 Position; ///< m
  Quaternion Rotation;
  Vector3 Scale{ 1.0, 1.0, 1.0 };

  /** Returns whether the transform changes lengths, and so the work of a force. */
  bool IsScaled() const noexcept;
  /**
   * Returns whether two transforms are equal apart from the rounding of the service's float
   * arithmetic.
   */
  bool IsNear(const HaplyTransform& other) const noexcept;
};

/** An Inverse3, Inverse3x or Minverse as described in a message. Vectors are along Haply's axes. */
struct HaplyArm
{
  /** Name of the list that contains the arm, which commands to the arm must name, too. */
  std::string Family;
  std::string Id;
  std::string Type;                      ///< "inverse3", "inverse3x" or "minverse", if reported
  std::string Handedness;                ///< "left" or "right", if reported
  std::string Preset;                    ///< the name of its preset, if reported
  std::optional<Vector3> Position;       ///< m
  std::optional<Vector3> Velocity;       ///< m/s
  std::optional<Vector3> Force;          ///< force that the service commands (N)
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
  /// Returns whether the service is of version 3.5 or later: sessions have a profile, devices have
  /// presets, and a force is a "vector".
  bool IsNew() const noexcept { return this->Minor >= 5; }
  bool IsKnown() const noexcept { return this->Major == 3; }
};

///@{
/**
 * Read a text to the second argument. Return nullptr, or the reason why the text is not valid; the
 * second argument must not be used then.
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

/** The preset that the greeting sets: the origin is the middle of the workspace. */
extern const char* const HaplyCentredPreset;

/**
 * Writes the message that sets a force (N, in Haply's axes) and requests a state; a full one, which
 * has the configuration, too, on demand.
 */
std::string WriteHaplyForce(
  const HaplyAddress& address, const Vector3& force, bool asksForAll = false);
/**
 * Writes the first message, which has no force. For version 3.5 and later, it also sets the
 * session's profile, Haply's own axes and the arm's origin, because the user may have changed axes
 * and origin in Haply's Hub. It also requests a full state, which reports the preset in use.
 */
std::string WriteHaplyGreeting(const HaplyAddress& address);

///@{
/** Convert between Haply's axes and the device's. */
constexpr Vector3 ToDevice(const Vector3& haply) noexcept
{
  return { haply.X, haply.Z, -haply.Y };
}
constexpr Vector3 FromDevice(const Vector3& device) noexcept
{
  return { device.X, -device.Z, device.Y };
}
/**
 * Converts the orientation of a grip, which points along its y, to that of a stylus, which points
 * along its -z.
 */
constexpr Quaternion ToDevice(const Quaternion& haply) noexcept
{
  return { haply.W, haply.X, haply.Z, -haply.Y };
}
///@}

} // namespace VolumeHaptics

#endif
