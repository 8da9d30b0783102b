// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's firmware image, from a file that the user names.
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
 * The smallest and the largest image (bytes); the device holds some 30 KiB.
 */
constexpr std::size_t FalconSmallestFirmware = 1024;
constexpr std::size_t FalconLargestFirmware = 128 * 1024;
///@}

/**
 * Reads an image. False, with the file, the fault and the cure, if there is no such file, if it
 * can't be read, or if its size can't be that of an image. An empty name means that there is no
 * file.
 */
bool ReadFalconFirmware(
  const std::string& file, std::vector<std::uint8_t>& image, std::string& error);

} // namespace VolumeHaptics

#endif
