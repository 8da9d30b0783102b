// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the Novint Falcon's firmware from a file that the user names (see FalconLoader.h).
 */
#ifndef FalconFirmware_h
#define FalconFirmware_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

///@{
/**
 * Smallest and largest accepted size of an image (bytes). The device has about 30 KiB of memory.
 */
constexpr std::size_t FalconSmallestFirmware = 1024;
constexpr std::size_t FalconLargestFirmware = 128 * 1024;
///@}

/**
 * Reads an image. Returns false and writes the file, the fault and the cure to `error` if `file` is
 * empty, if the file is missing or can't be read, or if its size is outside the limits.
 */
bool ReadFalconFirmware(
  const std::string& file, std::vector<std::uint8_t>& image, std::string& error);

} // namespace VolumeHaptics

#endif
