// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LargeLoader_h
#define Explore_LargeLoader_h

#include "Applications/Explorer/Volume/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Whether a volume is felt from its file, region by region: VTKHDF and Zarr always; raw samples
/// behind a MetaImage or NRRD header if that is wanted, or if they take more than half of the
/// memory that is free.
bool IsLargeVolume(const std::string& path, bool isWanted);

/// Opens such a file. Its image is a coarse level, of the file or made of its samples. Throws
/// InputError.
Volume LoadLargeVolume(const std::string& path);
} // namespace Explore

#endif
