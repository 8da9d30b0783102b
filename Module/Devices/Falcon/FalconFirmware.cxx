// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconFirmware.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace VolumeHaptics
{
namespace
{

constexpr const char* Cure =
  " Set the path of the image that came with the device's own software, with "
  "vtkHapticDevice::SetFirmwareFile() or --firmware of volumehaptics-device.";

std::string SizeText(std::uintmax_t size)
{
  return "has " + std::to_string(size) + " bytes; an image has " +
    std::to_string(FalconSmallestFirmware) + " to " + std::to_string(FalconLargestFirmware);
}

/** Empty if the image was read. */
std::string Read(const std::string& file, std::vector<std::uint8_t>& image)
{
  std::error_code trouble;
  const std::filesystem::file_status status = std::filesystem::status(file, trouble);
  if (!std::filesystem::exists(status))
  {
    return "does not exist";
  }
  if (!std::filesystem::is_regular_file(status))
  {
    return std::filesystem::is_directory(status) ? "is a folder" : "is no regular file";
  }
  const std::uintmax_t size = std::filesystem::file_size(file, trouble);
  if (!trouble && (size < FalconSmallestFirmware || size > FalconLargestFirmware))
  {
    return SizeText(size);
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  image.resize(trouble ? 0 : static_cast<std::size_t>(size));
  stream.read(reinterpret_cast<char*>(image.data()), static_cast<std::streamsize>(image.size()));
  if (trouble || !stream || image.empty())
  {
    return std::string("can't be read (") + std::strerror(errno) + ")";
  }
  return "";
}

} // namespace

bool ReadFalconFirmware(
  const std::string& file, std::vector<std::uint8_t>& image, std::string& error)
{
  image.clear();
  if (file.empty())
  {
    error =
      std::string("The Falcon's firmware does not run yet. It may not be distributed, for legal "
                  "reasons, so that it is not a part of this software.") +
      Cure;
    return false;
  }
  const std::string trouble = Read(file, image);
  if (!trouble.empty())
  {
    image.clear();
    error = "The Falcon's firmware \"" + file + "\" " + trouble + "." + Cure;
    return false;
  }
  return true;
}

} // namespace VolumeHaptics
