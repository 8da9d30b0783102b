// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens files that describe the volume that they contain.
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

/** A volume in a file, and its reader. */
struct LargeFile
{
  BoxExtent Extent{};
  int ScalarType = VTK_SHORT;
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 9> Direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  BoxReader Read;
  std::vector<std::string> Notes; ///< notes for the user on what was assumed or left out
  /** Size of a chunk in samples along x, y and z; zeros if there are no chunks. */
  std::array<std::int64_t, 3> ChunkSize{};
  std::vector<LargeFile> Coarser; ///< coarser levels of the same volume, the finest first
};

/**
 * Opens a file, by the ending of its name. If mayBeWhole, also opens a file whose samples can't be
 * read in boxes, and reads it as a whole. Throws std::runtime_error, with the cure.
 */
LargeFile OpenLargeFile(const std::string& name, bool mayBeWhole = false);

/**
 * Returns the format of a file, by its ending, or of a folder, by its files, such as "NRRD"; empty
 * if it is of none.
 */
std::string GetFormatName(const std::string& name);

/** Returns the endings of all formats, such as ".nrrd .tif", with a blank between them. */
std::string ListFileEndings();

/**
 * Returns VTK's type for numbers of a kind and a size (bytes); 0 if there is none. Never throws.
 */
int ChooseScalarType(bool isInteger, bool isSigned, std::size_t size);

} // namespace VolumeHaptics

#endif
