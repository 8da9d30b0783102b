// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Zarr arrays and OME-Zarr images, by their published specifications.
 */
#ifndef ZarrFile_h
#define ZarrFile_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * A Zarr array, or an OME-Zarr image with its coarser levels. Of times and channels it is the first
 * one. Throws std::runtime_error, with the cure.
 */
LargeFile OpenZarr(const std::string& name);

} // namespace VolumeHaptics

#endif
