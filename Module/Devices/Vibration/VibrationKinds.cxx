// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/VibrationKinds.h"

#include "Devices/Guard/GuardWish.h"
#include "Devices/Transport/Local/LocalListener.h"
#include "Devices/Vibration/BhapticsService.h"
#include "Devices/Vibration/HapbeatService.h"
#include "Devices/Vibration/ServiceMessages.h"
#include "Devices/Vibration/VibrationDevice.h"
#include "Devices/Vibration/VibrationDriver.h"
#include "Devices/Vibration/WeartService.h"
#if defined(__linux__)
#include "Devices/Guard/GuardedDevice.h"
#endif

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr double ListTime = 0.3; // s
constexpr std::uint16_t HapbeatPort = 7700;
constexpr const char* BhapticsId = "vibration:bhaptics";
constexpr const char* WeartId = "vibration:weart";
constexpr const char* HapbeatId = "vibration:hapbeat";
constexpr const char* VibratesOnly = ": vibration, not force";

/** Returns the part of an id after the kind's name and a colon. */
std::string RestOf(const std::string& id, const char* kind)
{
  return id.substr(std::min(id.size(), std::string(kind).size() + 1));
}

std::unique_ptr<DeviceBackend> MakeShown(std::unique_ptr<VibrationService> service)
{
  return std::make_unique<VibrationDevice>(
    std::make_unique<HardwareDevice>(std::make_unique<VibrationDriver>(std::move(service))));
}

std::unique_ptr<VibrationDriver> MakeWeartDriver(const std::string& hand)
{
  return std::make_unique<VibrationDriver>(std::make_unique<WeartService>(hand));
}

std::vector<DeviceListing> ListBhaptics()
{
  std::vector<DeviceListing> all;
  WebSocketClient player;
  std::vector<std::string> places;
  std::string error;
  AskBhaptics(player, ListTime, places, error);
  for (const std::string& place : BhapticsPlaces)
  {
    if (std::find(places.begin(), places.end(), place) != places.end())
    {
      all.push_back(
        { BhapticsId + (":" + place), "bHaptics " + place + VibratesOnly, "available" });
    }
  }
  return all;
}

std::string WhyNoBhaptics()
{
  WebSocketClient player;
  std::vector<std::string> places;
  std::string error;
  return AskBhaptics(player, ListTime, places, error) ? "" : error;
}

std::unique_ptr<DeviceBackend> MakeBhaptics(
  const std::string& id, const DeviceOptions&, std::string& error)
{
  const std::string place = RestOf(id, BhapticsId);
  const auto& known = BhapticsPlaces;
  if (id != BhapticsId && std::find(known.begin(), known.end(), place) == known.end())
  {
    error = "\"" + id + "\" is not a device id. Give one of";
    for (const std::string& name : known)
    {
      error += std::string(" ") + BhapticsId + ":" + name + ",";
    }
    error += std::string(" or ") + BhapticsId + ".";
    return nullptr;
  }
  return MakeShown(std::make_unique<BhapticsService>(place));
}

bool AskWeartBriefly(WeartStatus& status, std::string& error)
{
  LineSocket middleware(WeartSeparator);
  return AskWeart(middleware, ListTime, status, error);
}

std::vector<DeviceListing> ListWeart()
{
  std::vector<DeviceListing> all;
  WeartStatus status;
  std::string error;
  if (AskWeartBriefly(status, error))
  {
    for (const char* const hand : { "RIGHT", "LEFT" })
    {
      if (std::find(status.Hands.begin(), status.Hands.end(), hand) != status.Hands.end())
      {
        all.push_back({ std::string(WeartId) + ":" + hand,
          std::string("WEART TouchDIVER (") + hand + ")" + VibratesOnly, "available" });
      }
    }
  }
  return all;
}

std::string WhyNoWeart()
{
  WeartStatus status;
  std::string error;
  return AskWeartBriefly(status, error) ? "" : error;
}

std::unique_ptr<DeviceBackend> MakeWeart(
  const std::string& id, [[maybe_unused]] const DeviceOptions& options, std::string& error)
{
  const std::string hand = RestOf(id, WeartId);
  if (id != WeartId && hand != "LEFT" && hand != "RIGHT")
  {
    error = "\"" + id +
      "\" is not a device id: give \"vibration:weart\", \"vibration:weart:LEFT\" or "
      "\"vibration:weart:RIGHT\".";
    return nullptr;
  }
  if (!IsGuardWanted(options))
  {
    return std::make_unique<VibrationDevice>(
      std::make_unique<HardwareDevice>(MakeWeartDriver(hand)));
  }
#if defined(__linux__)
  std::unique_ptr<DeviceBackend> guarded =
    GuardedDevice::Make(MakeWeartDriver(hand), { "weart", hand.empty() ? "ANY" : hand }, error);
  return guarded ? std::make_unique<VibrationDevice>(std::move(guarded)) : nullptr;
#else
  error = MakeNoGuardText("TouchDIVER");
  return nullptr;
#endif
}

std::unique_ptr<DeviceBackend> MakeHapbeat(
  const std::string& id, const DeviceOptions&, std::string& error)
{
  const std::string rest = RestOf(id, HapbeatId);
  const std::size_t colon = rest.find(':');
  const std::string address = rest.empty() ? "127.0.0.1" : rest.substr(0, colon);
  std::uint16_t port = HapbeatPort;
  if ((id != HapbeatId && rest.empty()) ||
    (colon != std::string::npos && !ReadPort(rest.substr(colon + 1), port)))
  {
    error = "\"" + id +
      "\" is not a device id: give the address of a Hapbeat, as "
      "\"vibration:hapbeat:192.168.1.50\", and its port if that is not 7700.";
    return nullptr;
  }
  return MakeShown(std::make_unique<HapbeatService>(address, port));
}

} // namespace

std::vector<DeviceKind> GetVibrationKinds()
{
  return { { BhapticsId, &ListBhaptics, &MakeBhaptics, &WhyNoBhaptics },
    { WeartId, &ListWeart, &MakeWeart, &WhyNoWeart },
    { HapbeatId, [] { return std::vector<DeviceListing>(); }, &MakeHapbeat } };
}

std::unique_ptr<HardwareDriver> MakeVibrationFromWords(const std::vector<std::string>& words)
{
  return words.size() == 2 && words[0] == "weart"
    ? MakeWeartDriver(words[1] == "ANY" ? std::string() : words[1])
    : nullptr;
}

} // namespace VolumeHaptics
