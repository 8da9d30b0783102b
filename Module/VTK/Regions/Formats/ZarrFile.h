// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens Zarr arrays and OME-Zarr images, following their published specifications.
 */
#ifndef ZarrFile_h
#define ZarrFile_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Opens a Zarr array, or an OME-Zarr image with its coarser levels. Of several times and channels,
 * reads the first one. Throws std::runtime_error, with the cure.
 */
LargeFile OpenZarr(const std::string& name);

} // namespace VolumeHaptics

#endif
