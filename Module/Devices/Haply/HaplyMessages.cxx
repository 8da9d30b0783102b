// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Haply/HaplyMessages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{

using Json = nlohmann::json;

constexpr const char* NoObject = "sent something that is not a JSON object";
constexpr const char* TooDeep = "sent JSON with too many brackets in brackets";
constexpr const char* TooMany = "listed too many devices";
constexpr const char* NoDevices = "sent an invalid list of devices";
constexpr const char* NoId = "listed an arm without an identifier";
constexpr const char* NoVersion = "does not report its version";
constexpr std::size_t MostDevices = 64;
/** Limit of the nesting of brackets. The messages in the documentation have seven levels. */
constexpr int DeepestBrackets = 64;
/**
 * Largest difference between transforms that count as equal. The service computes in single
 * precision.
 */
constexpr double TransformTolerance = 1e-5;

/** Name of the session in Haply's Hub, in the format that the documentation recommends. */
constexpr const char* Profile = "org.vtk.volumehaptics:touch";
/** The session's request for a full state. */
constexpr const char* FullState = "force_render_full_state";

const Json Nothing;

/** Returns a member of an object, or null if there is none. */
const Json& At(const Json& object, const char* name)
{
  if (object.is_object())
  {
    const auto found = object.find(name);
    if (found != object.end())
    {
      return *found;
    }
  }
  return Nothing;
}

std::string Text(const Json& object, const char* name)
{
  const Json& value = At(object, name);
  return value.is_string() ? value.get<std::string>() : std::string();
}

///@{
/**
 * Reads a member. A missing member leaves `value` unchanged. Returns false if the member has
 * another type.
 */
bool Read(const Json& object, const char* name, bool& value)
{
  const auto found = object.find(name);
  const bool isThere = found != object.end();
  value = isThere && found->is_boolean() ? found->get<bool>() : value;
  return !isThere || found->is_boolean();
}

bool Read(const Json& object, const char* name, double& value)
{
  const auto found = object.find(name);
  const bool isThere = found != object.end();
  value = isThere && found->is_number() ? found->get<double>() : value;
  return !isThere || found->is_number();
}

bool Read(const Json& object, const char* name, Vector3& value)
{
  const auto found = object.find(name);
  return found == object.end() ||
    (found->is_object() && Read(*found, "x", value.X) && Read(*found, "y", value.Y) &&
      Read(*found, "z", value.Z));
}

bool Read(const Json& object, const char* name, Quaternion& value)
{
  const auto found = object.find(name);
  return found == object.end() ||
    (found->is_object() && Read(*found, "w", value.W) && Read(*found, "x", value.X) &&
      Read(*found, "y", value.Y) && Read(*found, "z", value.Z));
}

bool Read(const Json& object, const char* name, HaplyTransform& value)
{
  const auto found = object.find(name);
  return found == object.end() ||
    (found->is_object() && Read(*found, "position", value.Position) &&
      Read(*found, "rotation", value.Rotation) && Read(*found, "scale", value.Scale));
}
///@}

/** Returns a member; empty if it is missing or has another type. */
template <typename Value>
std::optional<Value> Told(const Json& object, const char* name)
{
  Value value{};
  return !At(object, name).is_null() && Read(object, name, value) ? std::optional<Value>(value)
                                                                  : std::nullopt;
}

bool Flag(const Json& object, const char* name, bool missing)
{
  return Told<bool>(object, name).value_or(missing);
}

HaplyArm ReadArm(const Json& device, const char* family)
{
  const Json& config = At(device, "config");
  const Json& state = At(device, "state");
  const Json& status = At(device, "status");
  HaplyArm arm;
  arm.Family = family;
  arm.Type = Text(config, "type");
  arm.Type = arm.Type.empty() ? family : arm.Type;
  arm.Handedness = Text(config, "handedness");
  // The service sends the preset as a name, or as an object that contains the name.
  arm.Preset = Text(config, "preset");
  arm.Preset = arm.Preset.empty() ? Text(At(config, "preset"), "preset") : arm.Preset;
  arm.Position = Told<Vector3>(state, "cursor_position");
  arm.Velocity = Told<Vector3>(state, "cursor_velocity");
  arm.Force = Told<Vector3>(state, "current_cursor_force");
  arm.Orientation = Told<Quaternion>(state, "body_orientation");
  arm.Transform = Told<HaplyTransform>(state, "transform");
  arm.IsSpoilt = (!arm.Position && !At(state, "cursor_position").is_null()) ||
    (!arm.Transform && !At(state, "transform").is_null());
  arm.IsCalibrated = Told<bool>(status, "calibrated");
  arm.IsReady = Told<bool>(status, "ready");
  arm.IsInUse = Told<bool>(status, "in_use");
  return arm;
}

HaplyGrip ReadGrip(const Json& device, const char*)
{
  const Json& state = At(device, "state");
  const Json& buttons = At(state, "buttons");
  HaplyGrip grip;
  grip.Orientation = Told<Quaternion>(state, "orientation");
  grip.IsAwake = Flag(At(device, "status"), "awake", true);
  grip.Buttons = Flag(state, "button", false) || Flag(buttons, "a", false) ? 1U : 0U;
  std::uint32_t bit = 1U;
  for (const char* const name : { "b", "c", "home" })
  {
    bit <<= 1U;
    grip.Buttons |= Flag(buttons, name, false) ? bit : 0U;
  }
  return grip;
}

/** Adds the devices of a family, which is a list or a map with identifiers as keys. */
template <typename Device>
const char* ReadFamily(const Json& message, const char* family,
  Device (*read)(const Json&, const char*), std::vector<Device>& all)
{
  const Json& devices = At(message, family);
  if (!devices.is_structured() && !devices.is_null())
  {
    return NoDevices;
  }
  for (const auto& item : devices.items())
  {
    if (!item.value().is_object())
    {
      return NoDevices;
    }
    if (all.size() == MostDevices)
    {
      return TooMany;
    }
    all.push_back(read(item.value(), family));
    all.back().Id = devices.is_object() ? item.key() : Text(item.value(), "device_id");
  }
  return nullptr;
}

/** Returns whether the brackets outside strings are nested no deeper than DeepestBrackets. */
bool IsShallow(const std::string& text) noexcept
{
  int depth = 0;
  bool isString = false;
  for (std::size_t i = 0; i < text.size() && depth <= DeepestBrackets; ++i)
  {
    const char c = text[i];
    i += isString && c == '\\' ? 1 : 0;
    isString = isString != (c == '"');
    depth += isString ? 0 : (c == '[' || c == '{') - (c == ']' || c == '}');
  }
  return depth <= DeepestBrackets;
}

/**
 * Parses an object. Returns nullptr, or the reason why the text is not valid. Checks the depth
 * first, because the library copies values recursively, which could overflow the thread's stack.
 */
const char* Parse(const std::string& text, Json& value)
{
  if (!IsShallow(text))
  {
    return TooDeep;
  }
  value = Json::parse(text, nullptr, false);
  return value.is_object() ? nullptr : NoObject;
}

/**
 * Returns the data of an HTTP answer, with or without an envelope ("Standard response envelope" in
 * the documentation).
 */
const Json& Unwrap(const Json& answer)
{
  const Json& data = At(answer, "data");
  return data.is_object() ? data : answer;
}

Json MakeForce(const HaplyAddress& address, const Vector3& force)
{
  const Json vector = { { "x", force.X }, { "y", force.Y }, { "z", force.Z } };
  return { { "device_id", address.Id },
    { "commands",
      { { "set_cursor_force", { { address.Version.IsNew() ? "vector" : "values", vector } } } } } };
}

std::string Dump(const Json& message)
{
  // The identifier came from the service. Replace invalid UTF-8 in it, so that this does not throw.
  return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace

const char* const HaplyCentredPreset = "arm_front_centered";

bool HaplyTransform::IsScaled() const noexcept
{
  return !(Norm(this->Scale - Vector3{ 1.0, 1.0, 1.0 }) < TransformTolerance);
}

bool HaplyTransform::IsNear(const HaplyTransform& other) const noexcept
{
  const Quaternion turn = this->Rotation * Conjugate(other.Rotation);
  return Norm(this->Position - other.Position) < TransformTolerance &&
    Norm(this->Scale - other.Scale) < TransformTolerance &&
    Norm(Vector3{ turn.X, turn.Y, turn.Z }) < TransformTolerance;
}

const char* ReadHaplyMessage(const std::string& text, HaplyMessage& message)
{
  message.Arms.clear();
  message.Grips.clear();
  Json whole;
  if (const char* const fault = Parse(text, whole))
  {
    return fault;
  }
  const Json& all = Unwrap(whole);
  for (const char* const family : { "inverse3", "inverse3x", "minverse" })
  {
    if (const char* const fault = ReadFamily(all, family, &ReadArm, message.Arms))
    {
      return fault;
    }
  }
  if (std::any_of(message.Arms.begin(), message.Arms.end(),
        [](const HaplyArm& arm) { return arm.Id.empty(); }))
  {
    return NoId;
  }
  for (const char* const family : { "verse_grip", "wireless_verse_grip", "custom_verse_grip" })
  {
    if (const char* const fault = ReadFamily(all, family, &ReadGrip, message.Grips))
    {
      return fault;
    }
  }
  return nullptr;
}

const char* ReadHaplyEvent(const std::string& text, HaplyEvent& event)
{
  constexpr std::array<const char*, 6> levels{ "info", "notice", "warning", "error", "critical",
    "panic" };
  Json all;
  if (const char* const fault = Parse(text, all))
  {
    return fault;
  }
  const Json& data = At(all, "data");
  event = {};
  event.Name = Text(all, "name");
  event.Device = Text(data, "device_id");
  event.Safety = Text(data, "safety_type");
  event.Text = Text(all, "message");
  const std::string level = Text(all, "level");
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    if (level == levels[i])
    {
      event.Level = static_cast<HaplyLevel>(i);
    }
  }
  return nullptr;
}

const char* ReadHaplyVersion(const std::string& text, HaplyVersion& version)
{
  Json whole;
  if (const char* const fault = Parse(text, whole))
  {
    return fault;
  }
  const Json& data = Unwrap(whole);
  for (const char* const name : { "git_tag", "project_version", "git_describe" })
  {
    const std::string value = Text(data, name);
    if (std::sscanf(value.c_str(), "%4d.%4d", &version.Major, &version.Minor) == 2)
    {
      return nullptr;
    }
  }
  return NoVersion;
}

std::string WriteHaplyForce(const HaplyAddress& address, const Vector3& force, bool asksForAll)
{
  Json message = { { address.Family, Json::array({ MakeForce(address, force) }) } };
  if (asksForAll)
  {
    message["session"][FullState] = Json::object();
  }
  return Dump(message);
}

std::string WriteHaplyGreeting(const HaplyAddress& address)
{
  if (!address.Version.IsNew())
  {
    return WriteHaplyForce(address, {});
  }
  Json arm = MakeForce(address, {});
  arm["configure"] = { { "preset", { { "preset", HaplyCentredPreset } } } };
  Json message = { { address.Family, Json::array({ arm }) } };
  message["session"] = {
    { "configure",
      { { "profile", { { "name", Profile } } }, { "basis", { { "permutation", "XYZ" } } } } },
    { FullState, Json::object() }
  };
  return Dump(message);
}

} // namespace VolumeHaptics
