// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchHaply.h"

#include "Dealer.h"
#include "Devices/Haply/HaplyMessages.h"

#include <array>
#include <cmath>

using namespace VolumeHaptics;

namespace
{
constexpr int Deepest = 8;
constexpr int MostMembers = 6;
constexpr std::size_t LongestText = 20000;
constexpr std::size_t MostDevices = 64;

constexpr std::array<const char*, 26> Names{ "inverse3", "inverse3x", "minverse", "verse_grip",
  "wireless_verse_grip", "device_id", "config", "state", "status", "type", "handedness",
  "cursor_position", "current_cursor_force", "orientation", "transform", "scale", "buttons", "a",
  "calibrated", "x", "y", "w", "data", "level", "git_tag", "message" };

constexpr std::array<const char*, 14> Values{ "0", "-1.5", "1e308", "1e999", "-0", "true", "false",
  "null", "\"049D\"", "\"error\"", "\"3.5.0\"", "\"\\ud800\"", "18446744073709551615", "," };

std::string DealJson(Dealer& dealer, int depth, std::size_t& left)
{
  const int kind = depth == 0 ? 0 : dealer.Choose(4);
  if (kind > 1 || depth == Deepest || left == 0)
  {
    return Values[static_cast<std::size_t>(dealer.Choose(Values.size()))];
  }
  std::string text = kind == 0 ? "{" : "[";
  for (int i = dealer.Choose(MostMembers); i > 0 && left > 0; --i)
  {
    --left;
    text += text.size() > 1 ? "," : "";
    if (kind == 0)
    {
      text +=
        std::string("\"") + Names[static_cast<std::size_t>(dealer.Choose(Names.size()))] + "\":";
    }
    text += DealJson(dealer, depth + 1, left);
  }
  return text + (kind == 0 ? "}" : "]");
}

bool IsFiniteTurn(const Quaternion& q)
{
  return std::isfinite(q.W) && std::isfinite(q.X) && std::isfinite(q.Y) && std::isfinite(q.Z);
}

void ReceiveText(const std::string& text)
{
  HaplyMessage message;
  if (ReadHaplyMessage(text, message) == nullptr)
  {
    Check(message.Arms.size() <= MostDevices && message.Grips.size() <= MostDevices,
      "the number of devices is limited");
    for (const HaplyArm& arm : message.Arms)
    {
      for (const std::optional<Vector3>& vector : { arm.Position, arm.Velocity, arm.Force })
      {
        Check(!vector ||
            (std::isfinite(vector->X) && std::isfinite(vector->Y) && std::isfinite(vector->Z)),
          "what is told is finite");
      }
      Check(!arm.Orientation || IsFiniteTurn(*arm.Orientation), "turns are finite");
      for (const int minor : { 0, 5 })
      {
        HaplyMessage ignored;
        const HaplyAddress address{ { 3, minor }, arm.Family, arm.Id };
        // The client may request the state of any arm in the service's list, whatever the arm's
        // name is.
        Check(ReadHaplyMessage(WriteHaplyGreeting(address), ignored) == nullptr &&
            ReadHaplyMessage(WriteHaplyForce(address, { 0.5, -1.0, 2.0 }), ignored) == nullptr &&
            ignored.Arms.size() == 1,
          "a force is written");
      }
    }
    for (const HaplyGrip& grip : message.Grips)
    {
      Check(!grip.Orientation || IsFiniteTurn(*grip.Orientation), "turns are finite");
      Check(grip.Buttons < 16, "there are four buttons");
    }
  }
  HaplyEvent event;
  Check(ReadHaplyEvent(text, event) != nullptr || event.Level <= HaplyLevel::Panic, "a level");
  HaplyVersion version;
  ReadHaplyVersion(text, version);
}
} // namespace

void TouchHaply(const std::uint8_t* bytes, std::size_t size)
{
  ReceiveText(std::string(bytes, bytes + size));
  Dealer dealer(bytes, size);
  while (dealer.HasMore())
  {
    std::size_t left = LongestText;
    ReceiveText(DealJson(dealer, 0, left));
  }
}
