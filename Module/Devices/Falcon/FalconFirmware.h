// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the file of the Novint Falcon's firmware, which the user names (see FalconLoader.h).
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
/** Smallest and largest size of an image (bytes). The device has room for about 30 KiB. */
constexpr std::size_t FalconSmallestFirmware = 1024;
constexpr std::size_t FalconLargestFirmware = 128 * 1024;
///@}

/**
 * Reads an image. An empty name means that there is no file. Returns false and writes file, fault
 * and cure to `error` if there is no such file, if it can't be read, or if its size can't be that
 * of an image.
 */
bool ReadFalconFirmware(
  const std::string& file, std::vector<std::uint8_t>& image, std::string& error);

} // namespace VolumeHaptics

#endif
