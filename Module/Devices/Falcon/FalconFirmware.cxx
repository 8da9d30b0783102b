// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconFirmware.h"

#include "Core/Platform/SmallFile.h"

namespace VolumeHaptics
{

bool ReadFalconFirmware(
  const std::string& file, std::vector<std::uint8_t>& image, std::string& error)
{
  const std::string cure = " Set the path of the image (" + std::to_string(FalconSmallestFirmware) +
    " to " + std::to_string(FalconLargestFirmware) +
    " bytes) that came with the device's own software, with vtkHapticDevice::SetFirmwareFile() or "
    "--firmware of volumehaptics-device.";
  image.clear();
  if (file.empty())
  {
    error =
      "The Falcon's firmware does not run yet. It may not be distributed, for legal reasons, so "
      "that it is not a part of this software." +
      cure;
    return false;
  }
  std::string bytes;
  std::string fault = ReadSmallFile(file, FalconLargestFirmware, bytes);
  if (fault.empty() && bytes.size() < FalconSmallestFirmware)
  {
    fault = "has " + std::to_string(bytes.size()) + " bytes";
  }
  if (!fault.empty())
  {
    error = "The Falcon's firmware \"" + file + "\" " + fault + "." + cure;
    return false;
  }
  image.assign(bytes.begin(), bytes.end());
  return true;
}

} // namespace VolumeHaptics
