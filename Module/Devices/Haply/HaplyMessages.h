// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The messages of Haply's Inverse service, without a connection.
 *
 * Written from Haply's public documentation (docs.haply.co/inverseSDK, version 3.5: "WebSocket
 * Protocol", "Simulation Channel", "Control Commands", "Common Types", "Basis Permutation", "Events
 * & Monitoring", "HTTP", tutorials 00 to 06; and "Haply Inverse Service" of 3.0 and 3.1).
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

/** Maps from the device's space to the session's. */
struct HaplyTransform
{
  Vector3 Position; ///< m
  Quaternion Rotation;
  Vector3 Scale{ 1.0, 1.0, 1.0 };

  /** Returns whether the transform changes lengths, and so the work of a force. */
  bool IsScaled() const noexcept;
  /** Returns whether two transforms are equal up to the service's float arithmetic. */
  bool IsNear(const HaplyTransform& other) const noexcept;
};

/** An Inverse3, Inverse3x or Minverse, as in a message; vectors in Haply's axes. */
struct HaplyArm
{
  std::string Family; ///< the name of the arm's list, which the arm's commands must name, too
  std::string Id;
  std::string Type;                      ///< "inverse3", "inverse3x" or "minverse", if reported
  std::string Handedness;                ///< "left" or "right", if reported
  std::optional<Vector3> Position;       ///< m
  std::optional<Vector3> Velocity;       ///< m/s
  std::optional<Vector3> Force;          ///< N: the force that the service commands
  std::optional<Quaternion> Orientation; ///< orientation of the arm's body
  std::optional<HaplyTransform> Transform;
  /** whether the position or the transform exists but has no numbers: NaN is written as null */
  bool IsSpoilt = false;
  ///@{
  /** Flags of the arm; empty if not reported. */
  std::optional<bool> IsCalibrated;
  std::optional<bool> IsReady;
  std::optional<bool> IsInUse;
  ///@}
};

/** A VerseGrip, wired or wireless. */
struct HaplyGrip
{
  std::string Id;
  std::optional<Quaternion> Orientation; ///< orientation in Haply's axes
  std::uint32_t Buttons = 0;             ///< bits 0 to 3: a (or the only button), b, c, home
  bool IsAwake = true;
};

struct HaplyMessage
{
  std::vector<HaplyArm> Arms;
  std::vector<HaplyGrip> Grips;
};

/** How bad an event is; in the order of the documentation. */
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
  std::string Name; ///< name of the event, such as "device-disconnected"
  HaplyLevel Level = HaplyLevel::Info;
  std::string Device; ///< the device's identifier, if the event is about one
  std::string Safety; ///< data.safety_type, such as "ebrake_triggered"
  std::string Text;   ///< text for people
};

struct HaplyVersion
{
  int Major = 0;
  int Minor = 0;
  /// Returns whether sessions have a profile, devices have presets, and a force is a "vector", as
  /// from 3.5 on.
  bool IsNew() const noexcept { return this->Minor >= 5; }
  bool IsKnown() const noexcept { return this->Major == 3; }
};

///@{
/**
 * Reads a text to `message`. Returns nullptr, or the reason for refusing the text; the message is
 * then unspecified.
 */
const char* ReadHaplyMessage(const std::string& text, HaplyMessage& message);
const char* ReadHaplyEvent(const std::string& text, HaplyEvent& event);
const char* ReadHaplyVersion(const std::string& text, HaplyVersion& version);
///@}

/** The address of an arm, which each command carries. */
struct HaplyAddress
{
  HaplyVersion Version;
  std::string Family;
  std::string Id;
};

/** Writes the message that sets a force (N, in Haply's axes) and requests a state. */
std::string WriteHaplyForce(const HaplyAddress& address, const Vector3& force);
/**
 * Writes the first message: no force, and from 3.5 on the session's profile, Haply's own axes and
 * the arm's origin, because the user may have changed axes and origin in Haply's Hub.
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
/** Converts from a grip that points along its y to a stylus that points along its -z. */
constexpr Quaternion ToDevice(const Quaternion& haply) noexcept
{
  return { haply.W, haply.X, haply.Z, -haply.Y };
}
///@}

} // namespace VolumeHaptics

#endif
