// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HaplyState.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace emulated
{
namespace
{
using Clock = std::chrono::steady_clock;

/// m: position in the documentation's example of an inventory. The tip is in front of the arm's
/// base.
constexpr Triple BaseToMiddle{ 0.0, -0.12, 0.15 };
// s; a longer pause moves the hand only as far as this time does
constexpr double LongestStep = 5e-3;
constexpr double ShortStep = 1e-4; // s

/// Returns, for each axis of a session, the index and the sign of Haply's axis.
std::array<std::pair<int, double>, 3> ReadBasis(const std::string& basis)
{
  std::array<std::pair<int, double>, 3> axes{};
  double sign = 1.0;
  std::size_t count = 0;
  for (const char c : basis)
  {
    if (c >= 'X' && c <= 'Z' && count < axes.size())
    {
      axes[count++] = { c - 'X', sign };
    }
    sign = c == '-' ? -1.0 : 1.0;
  }
  return axes;
}
} // namespace

Triple HaplyView::ToSession(const Triple& haply) const
{
  const auto axes = ReadBasis(this->Basis);
  Triple session{};
  for (int a = 0; a < 3; ++a)
  {
    session[a] = axes[a].second * haply[axes[a].first];
  }
  return session;
}

Triple HaplyView::FromSession(const Triple& session) const
{
  const auto axes = ReadBasis(this->Basis);
  Triple haply{};
  for (int a = 0; a < 3; ++a)
  {
    haply[axes[a].first] = axes[a].second * session[a];
  }
  return haply;
}

std::array<double, 4> HaplyView::ToSession(const std::array<double, 4>& haply) const
{
  const auto axes = ReadBasis(this->Basis);
  // In axes of the other handedness, rotations have the opposite sign.
  const bool isCyclic = (axes[0].first + 1) % 3 == axes[1].first;
  const double hand = (isCyclic ? 1.0 : -1.0) * axes[0].second * axes[1].second * axes[2].second;
  const Triple axis = this->ToSession(Triple{ haply[1], haply[2], haply[3] });
  return { haply[0], hand * axis[0], hand * axis[1], hand * axis[2] };
}

/// Writes objects as text, with the order and the omissions of a service.
class HaplyState::Writer
{
public:
  explicit Writer(const HaplyShape& shape)
    : Shape(shape)
  {
  }
  std::string Object(Members members) const
  {
    if (this->Shape.IsReordered)
    {
      std::reverse(members.begin(), members.end());
    }
    std::string text = "{";
    for (const auto& [name, value] : members)
    {
      text += (text.size() > 1 ? ",\"" : "\"") + name + "\":" + value;
    }
    return text + "}";
  }
  std::string Numbers(const std::vector<std::pair<std::string, double>>& numbers,
    const std::vector<double>& defaults) const
  {
    Members members;
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      if (!this->Shape.OmitsDefaults || numbers[i].second != defaults[i])
      {
        std::ostringstream out;
        out.imbue(std::locale::classic());
        out.precision(9);
        out << numbers[i].second;
        members.emplace_back(numbers[i].first, out.str());
      }
    }
    return this->Object(members);
  }
  std::string Vector(const Triple& v, double missing = 0.0) const
  {
    return this->Numbers(
      { { "x", v[0] }, { "y", v[1] }, { "z", v[2] } }, { missing, missing, missing });
  }
  std::string Turn(const std::array<double, 4>& q) const
  {
    return this->Numbers(
      { { "w", q[0] }, { "x", q[1] }, { "y", q[2] }, { "z", q[3] } }, { 1.0, 0.0, 0.0, 0.0 });
  }
  std::string Flags(const std::vector<std::pair<std::string, bool>>& flags) const
  {
    Members members;
    for (const auto& [name, value] : flags)
    {
      if (!this->Shape.OmitsDefaults || value)
      {
        members.emplace_back(name, value ? "true" : "false");
      }
    }
    return this->Object(members);
  }
  /// Writes a family of devices as a list, or as a map with identifiers as keys.
  std::string Family(const std::vector<std::pair<std::string, Members>>& devices) const
  {
    if (this->Shape.HasMaps)
    {
      Members members;
      for (const auto& [id, device] : devices)
      {
        members.emplace_back(id, this->Object(device));
      }
      return this->Object(members);
    }
    std::string text = "[";
    for (auto [id, device] : devices)
    {
      device.insert(device.begin(), { "device_id", "\"" + id + "\"" });
      text += (text.size() > 1 ? "," : "") + this->Object(device);
    }
    return text + "]";
  }

private:
  const HaplyShape Shape;
};

void HaplyState::Step()
{
  const Clock::time_point now = Clock::now();
  double time = std::min(std::chrono::duration<double>(now - this->Stepped).count(), LongestStep);
  this->Stepped = now;
  for (; time > 0.0; time -= ShortStep)
  {
    this->Hand.Step(std::min(time, ShortStep), this->Force);
  }
}

HaplyState::Members HaplyState::MakeArm(
  bool hasConfig, const HaplyView& view, const Triple& tip, const Triple& force, bool isInUse) const
{
  const Writer write(this->Shape);
  Members state{ { "cursor_velocity", write.Vector(view.ToSession(this->Hand.Velocity)) },
    { "body_orientation", write.Turn({ 1.0, 0.0, 0.0, 0.0 }) },
    { "current_cursor_force", write.Vector(view.ToSession(force)) },
    { "control_mode", "\"idle\"" } };
  if (this->Fault != HaplyFault::Blind && this->Fault != HaplyFault::SlowBlind)
  {
    state.insert(state.begin(),
      { "cursor_position",
        this->Fault == HaplyFault::NoNumber ? R"({"x":0.0,"y":null,"z":0.0})"
                                            : write.Vector(view.ToSession(tip)) });
  }
  if (this->IsNew())
  {
    state.emplace_back("transform",
      write.Object({ { "position", write.Vector(this->Place) },
        { "rotation", write.Turn({ 1.0, 0.0, 0.0, 0.0 }) },
        { "scale",
          this->Fault == HaplyFault::NoScale
            ? R"({"x":null})"
            : write.Vector({ this->Scale, this->Scale, this->Scale }, 1.0) } }));
  }
  Members arm;
  if (hasConfig)
  {
    Members config{ { "type", "\"" + this->Shape.Type + "\"" }, { "port", "\"COM12\"" },
      { "device_info", "{\"major_version\":7,\"minor_version\":4,\"id\":\"049D\"}" },
      { "handedness", "\"right\"" } };
    if (this->IsNew())
    {
      config.insert(config.end(),
        { { "preset", "\"" + view.Preset + "\"" },
          { "basis", R"({"permutation":")" + view.Basis + "\"}" } });
    }
    arm.emplace_back("config", write.Object(config));
  }
  arm.emplace_back("state", write.Object(state));
  // Write all flags, or omit all that are false: the documentation does not define a missing flag.
  Members status;
  for (const auto& [name, value] : { std::pair("calibrated", this->IsCalibrated),
         std::pair("in_use", isInUse), std::pair("power_supply", true),
         std::pair("ready", this->IsReady), std::pair("started", true) })
  {
    if (value || !this->Shape.OmitsFalseFlags)
    {
      status.emplace_back(name, value ? "true" : "false");
    }
  }
  if (hasConfig || this->Shape.HasStatus)
  {
    arm.emplace_back("status", write.Object(status));
  }
  return arm;
}

std::string HaplyState::MakeMessage(bool hasConfig, const HaplyView& view,
  const std::function<bool(const std::string&)>& isInUse, std::size_t number)
{
  this->Step();
  const Writer write(this->Shape);
  Triple tip = this->Hand.Tip;
  const bool isCentred = this->IsNew() && view.Preset == "arm_front_centered";
  for (int a = 0; a < 3; ++a)
  {
    tip[a] += this->Offset[a] + (isCentred ? 0.0 : BaseToMiddle[a]);
  }
  tip[0] += static_cast<double>(number) * this->Shape.NumberScale;
  std::vector<std::pair<std::string, Members>> arms{ { Other,
    this->MakeArm(hasConfig, view, { 0.3, 0.3, 0.3 }, {}, isInUse(Other)) } };
  if (this->IsPlugged)
  {
    arms.insert(
      arms.begin(), { Id, this->MakeArm(hasConfig, view, tip, this->Force, isInUse(Id)) });
  }
  const Members grip{
    { "state",
      write.Object({ { "orientation", write.Turn(view.ToSession(this->Grip)) }, { "hall", "0" },
        { "buttons",
          write.Flags({ { "a", this->IsPressed }, { "b", false }, { "c", false } }) } }) },
    { "status", "{\"awake\":true}" }
  };
  Members all{ { this->Shape.Family, write.Family(arms) },
    { "wireless_verse_grip", write.Family({ { "61548", grip } }) } };
  if (this->IsNew())
  {
    all.insert(all.begin(), { "session_id", "7" });
  }
  return write.Object(all);
}

} // namespace emulated
