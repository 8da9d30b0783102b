// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Haply/HaplyKind.h"

#include "Devices/Haply/HaplyDriver.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Requests the list of devices from the service. On failure, returns false and writes the reason to
 * `error`.
 */
bool ReceiveHaplys(HaplyMessage& message, std::string& error)
{
  HaplyPorts ports;
  HaplyVersion version;
  std::string text;
  if (!HaplyPorts::Read(ports, error) || !DetectHaplyService(ports, version, error))
  {
    return false;
  }
  const char* const fault = AskHaply(ports, "/devices", text, error)
    ? ReadHaplyMessage(text, message)
    : "does not list its devices";
  if (fault != nullptr)
  {
    error = std::string("Haply's Inverse service ") + fault + ". Start it again.";
  }
  return fault == nullptr;
}

std::vector<DeviceListing> ListHaplys()
{
  std::vector<DeviceListing> all;
  HaplyMessage message;
  std::string error;
  if (ReceiveHaplys(message, error))
  {
    for (const HaplyArm& arm : message.Arms)
    {
      const char* const state = arm.IsInUse.value_or(false) ? "in use"
        : !arm.IsCalibrated.value_or(false) ? "not calibrated: put its handle into the inkwell"
                                            : "available";
      all.push_back({ "haply:" + arm.Id, NameOfHaply(arm), state, "haply:" + arm.Id });
    }
  }
  return all;
}

/**
 * Returns the reason why this computer has no Haply device, usually that the service does not run.
 * Returns an empty text if the service answers.
 */
std::string WhyNoHaplys()
{
  HaplyMessage message;
  std::string error;
  return ReceiveHaplys(message, error) ? "" : error;
}

std::unique_ptr<DeviceBackend> MakeHaply(
  const std::string& id, const DeviceOptions&, std::string& error)
{
  const std::string wanted = id.substr(std::min(id.size(), std::string("haply:").size()));
  if (id != "haply" && wanted.empty())
  {
    error = "\"" + id +
      "\" is not a device id: give \"haply\", or \"haply:ID\" with the name that Haply's Hub "
      "shows.";
    return nullptr;
  }
  return std::make_unique<HardwareDevice>(std::make_unique<HaplyDriver>(wanted));
}

} // namespace

DeviceKind GetHaplyKind()
{
  return { "haply", &ListHaplys, &MakeHaply, &WhyNoHaplys };
}

} // namespace VolumeHaptics
