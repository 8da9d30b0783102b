// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_MaskFolder_h
#define Explore_MaskFolder_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Lists the files of a folder with one mask per organ, as TotalSegmentator writes it. Returns none
/// for any other folder, such as one with numbered time steps, whose names differ only in their
/// digits.
std::vector<std::string> ListMasks(const std::string& folder);

/// Reads masks as labels, named after their files. If `series` is not 0, reads only the mask with
/// this number, counted from 1. Throws InputError unless all have the same grid.
Volume ReadMasks(const std::string& folder, const std::vector<std::string>& masks, int series);
} // namespace Explore

#endif
