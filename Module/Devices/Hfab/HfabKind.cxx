// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Hfab/HfabKind.h"

#include "Devices/Hfab/HfabDriver.h"

namespace VolumeHaptics
{
namespace
{

/**
 * Lists the boards without sending anything, because boards with other programs have the same name.
 */
std::vector<DeviceListing> ListBoards()
{
  std::vector<DeviceListing> all;
  for (const SerialPortInfo& port : HfabDriver::ListBoardPorts())
  {
    all.push_back({ "hfab:" + port.Path, "Arm with an hfab controller, if it is one: " + port.Name,
      SerialPort::StateOf(port.Path), HfabDriver::MakeIdentity(port) });
  }
  return all;
}

/**
 * Returns the obstacle if there is no board. Whether a board is a controller is known only after
 * opening it; its listing shows whether the user has permission to open it.
 */
std::string WhyNoBoards()
{
  return HfabDriver::ListBoardPorts().empty() ? std::string("no serial port of a board named \"") +
      HfabDriver::Board + "\" is in " + SerialPort::NamesFolder +
      ". Plug the controller in, or give its port, such as \"hfab:" + SerialPort::Example + "\"."
                                              : std::string();
}

std::unique_ptr<DeviceBackend> MakeHfab(
  const std::string& id, const DeviceOptions&, std::string& error)
{
  const std::size_t colon = id.find(':');
  const std::string port = colon == std::string::npos ? std::string() : id.substr(colon + 1);
  if (colon != std::string::npos && (port.empty() || !SerialPort::IsPath(port)))
  {
    error = "\"" + id + "\" is not a device id: give \"hfab\" or \"hfab:PORT\", such as " +
      "\"hfab:" + SerialPort::Example + "\".";
    return nullptr;
  }
  return std::make_unique<HardwareDevice>(std::make_unique<HfabDriver>(port));
}

} // namespace

DeviceKind GetHfabKind()
{
  return { "hfab", &ListBoards, &MakeHfab, &WhyNoBoards };
}

} // namespace VolumeHaptics
