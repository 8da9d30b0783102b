// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Files that say themselves what volume they hold.
 */
#ifndef LargeFile_h
#define LargeFile_h

#include "VTK/Regions/Formats/LargeVolume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A volume in a file, and what reads it. */
struct LargeFile
{
  BoxExtent Extent{};
  int ScalarType = VTK_SHORT;
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 9> Direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  BoxReader Read;
  std::array<std::int64_t, 3> ChunkSize{}; ///< samples, along x, y and z; zeros if it has none
  std::vector<LargeFile> Coarser;          ///< levels of the same volume, the finest first
};

/** Whether the ending of a name is that of a file which OpenLargeFile knows. */
bool IsLargeFileName(const std::string& name);

/** Opens a file by the ending of its name. Throws std::runtime_error, with the cure. */
LargeFile OpenLargeFile(const std::string& name);

/**
 * VTK's type of numbers that are integers or not, of a size (bytes); 0 if there is none. Throws
 * nothing.
 */
int FindScalarType(bool isInteger, bool isSigned, std::size_t size);

} // namespace VolumeHaptics

#endif
