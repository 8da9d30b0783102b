// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_MaskFolder_h
#define Explore_MaskFolder_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Lists the files of a folder that has a mask for each organ, as TotalSegmentator writes them.
/// Returns none for any other folder, such as that of the frames of a film, whose names differ in
/// their numbers only.
std::vector<std::string> ListMasks(const std::string& folder);

/// Reads masks as labels, whose names are those of the files. If `series` is not 0, only the mask
/// with this number is read, from 1 on. Throws InputError if they are not of one grid.
Volume ReadMasks(const std::string& folder, const std::vector<std::string>& masks, int series);
} // namespace Explore

#endif
