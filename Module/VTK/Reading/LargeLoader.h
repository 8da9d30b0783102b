// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LargeLoader_h
#define Explore_LargeLoader_h

#include "VTK/Reading/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Returns whether a volume is read from its file region by region: VTKHDF and Zarr always; files
/// of the other formats of LargeFile.cxx (such as NRRD, TIFF or MINC) if `isWanted`, or if their
/// samples take more than half of the free memory.
bool IsLargeVolume(const std::string& path, bool isWanted);

/// Returns the size (bytes) of the samples of a file that can be read region by region; 0 for other
/// files.
double ComputeRegionsSize(const std::string& path);

/// Opens a file that is read region by region. The volume's image is a coarse level, which comes
/// from the file or is made from its samples. For `series`, see vtkHapticRegionSource::OpenFile().
/// Throws InputError.
Volume LoadLargeVolume(const std::string& path, int series = 0);
} // namespace Explore

#endif
