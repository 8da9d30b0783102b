// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LargeLoader_h
#define Explore_LargeLoader_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Returns whether to read a volume from its file region by region: always for VTKHDF and Zarr; for
/// the other formats of LargeFile.cxx (such as NRRD, TIFF or MINC) if `isWanted`, or if the samples
/// take more than half of the free memory.
bool IsLargeVolume(const std::string& path, bool isWanted);

/// Returns the size (bytes) of the samples of a file that can be read region by region; 0 for other
/// files.
double ComputeRegionsSize(const std::string& path);

/// Opens a file to be read region by region. The volume's image is a coarse level, read from the
/// file or made from its samples. For `series`, see vtkHapticRegionSource::OpenFile(). Throws
/// InputError.
Volume LoadLargeVolume(const std::string& path, int series = 0);
} // namespace Explore

#endif
