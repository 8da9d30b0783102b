// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomFolder_h
#define Explore_DicomFolder_h

#include "Applications/Explorer/Volume/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Reads one series of uncompressed DICOM slices, sorted by their position, with the rescale to
/// Hounsfield units applied. Throws InputError if the folder holds something else.
Volume ReadDicomFolder(const std::string& path);
} // namespace Explore

#endif
