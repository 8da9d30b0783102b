// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/DeviceTexts.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace VolumeHaptics
{

int ReadDeviceNumber(const std::string& id, const std::string& kind, std::string& error)
{
  if (id == kind)
  {
    return 0;
  }
  const std::string digits = id.substr(std::min(id.size(), kind.size() + 1));
  const bool isNumber = !digits.empty() && digits.size() < 4 &&
    std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (id.compare(0, kind.size() + 1, kind + ":") != 0 || !isNumber)
  {
    error = "\"" + id + "\" is not a device id: give \"" + kind + "\" or \"" + kind +
      ":N\", with N counting from 0.";
    return -1;
  }
  return std::atoi(digits.c_str());
}

std::string PermissionCure(
  const char* subsystem, std::uint16_t vendor, std::uint16_t product, bool isBluetooth)
{
  const bool isUsb = std::string(subsystem) == "usb";
  char rule[200];
  if (isBluetooth)
  {
    std::snprintf(rule, sizeof(rule),
      "SUBSYSTEM==\"%s\", KERNELS==\"0005:%04X:%04X.*\", TAG+=\"uaccess\"", subsystem, vendor,
      product);
  }
  else
  {
    std::snprintf(rule, sizeof(rule),
      "SUBSYSTEM==\"%s\", %s{idVendor}==\"%04x\", %s{idProduct}==\"%04x\", TAG+=\"uaccess\"",
      subsystem, isUsb ? "ATTR" : "ATTRS", vendor, isUsb ? "ATTR" : "ATTRS", product);
  }
  return std::string("no permission. Put this line into a file of /etc/udev/rules.d named ") +
    "70-volume-haptics.rules (one of that name is installed with this library): " + rule +
    " - then run \"sudo udevadm control --reload\" and plug the device in again" +
    (isBluetooth ? ", or connect it again." : ".");
}

} // namespace VolumeHaptics
