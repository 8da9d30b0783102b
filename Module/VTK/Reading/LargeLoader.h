// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LargeLoader_h
#define Explore_LargeLoader_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Whether a volume is felt from its file, region by region: VTKHDF and Zarr always; raw samples
/// behind a MetaImage or NRRD header on request, or if they take more than half of the free memory.
bool IsLargeVolume(const std::string& path, bool isWanted);

/// Returns the size (bytes) of the samples of a file that can be read region by region; 0 for
/// others.
double ComputeRegionsSize(const std::string& path);

/// Opens such a file. Its image is a coarse level, from the file or made from its samples. Throws
/// InputError.
Volume LoadLargeVolume(const std::string& path);
} // namespace Explore

#endif
