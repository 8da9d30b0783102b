// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Haply/HaplyService.h"

#include "Core/Platform/Files.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Transport/Local/LocalListener.h"
#include "Devices/Transport/WebSocket/WebSocketClient.h"

namespace VolumeHaptics
{
namespace
{

constexpr double AskTime = 0.5; // s; short, because the service runs on this computer

} // namespace

const char* const HowToStartHaply =
  "Start Haply's Hub, or the service itself (on Linux: systemctl start haply-inverse-service). If "
  "it listens to other ports, name them in VOLUMEHAPTICS_HAPLY, such as 10001,10020: those of the "
  "states and of the events, and as a third one that of HTTP if it has its own.";

std::string NameOfHaply(const HaplyArm& arm)
{
  const std::string kind = arm.Type == "inverse3" ? "Inverse3"
    : arm.Type == "inverse3x"                     ? "Inverse3x"
    : arm.Type == "minverse"                      ? "Minverse"
                                                  : arm.Type;
  const std::string hand = arm.Handedness.empty() ? "" : ", " + arm.Handedness + "-handed";
  return "Haply " + kind + " (" + arm.Id + hand + ")";
}

bool HaplyPorts::Read(HaplyPorts& ports, std::string& error)
{
  const std::string text = Files::GetVariable("VOLUMEHAPTICS_HAPLY");
  std::size_t begin = text.empty() ? std::string::npos : 0;
  bool areRight = true;
  for (std::uint16_t* const port : { &ports.States, &ports.Events, &ports.Http })
  {
    if (begin != std::string::npos)
    {
      const std::size_t comma = text.find(',', begin);
      areRight = ReadPort(text.substr(begin, comma - begin), *port) && areRight;
      begin = comma == std::string::npos ? comma : comma + 1;
    }
  }
  if (!areRight || begin != std::string::npos)
  {
    error = "The environment variable VOLUMEHAPTICS_HAPLY is \"" + text +
      "\". Give the ports of the Inverse service, such as 10001,10020, or unset it.";
    return false;
  }
  return true;
}

bool AskHaply(
  const HaplyPorts& ports, const std::string& target, std::string& text, std::string& error)
{
  for (const std::uint16_t port : { ports.States, ports.Http })
  {
    const std::int64_t asked = ServoClock::Now();
    for (const char* const prefix : { "", "/3.1", "/3.0" })
    {
      const double left = AskTime - ServoClock::SecondsSince(asked);
      std::string reason;
      if (left > 0.0 && FetchText(port, prefix + target, left, text, reason))
      {
        return true;
      }
      error = error.empty() ? reason : error;
    }
  }
  return false;
}

bool DetectHaplyService(const HaplyPorts& ports, HaplyVersion& version, std::string& error)
{
  for (const std::uint16_t port : { ports.States, ports.Http, ports.Events })
  {
    if (!IsOwnListener(port, error))
    {
      error += HowToStartHaply;
      return false;
    }
  }
  const std::string where =
    " at port " + std::to_string(ports.States) + " or " + std::to_string(ports.Http);
  std::string text;
  std::string reason;
  if (!AskHaply(ports, "/version", text, reason))
  {
    error =
      "Haply's Inverse service does not answer" + where + " (" + reason + "). " + HowToStartHaply;
    return false;
  }
  if (const char* const fault = ReadHaplyVersion(text, version))
  {
    error = "The program" + where + " " + fault + ", so it is not Haply's Inverse service. " +
      HowToStartHaply;
    return false;
  }
  if (!version.IsKnown())
  {
    error = "Haply's Inverse service" + where + " is of version " + std::to_string(version.Major) +
      "." + std::to_string(version.Minor) + ". Versions 3 are supported.";
    return false;
  }
  return true;
}

} // namespace VolumeHaptics
