// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomFolder_h
#define Explore_DicomFolder_h

#include "Applications/Explorer/Volume/VolumeLoader.h"

#include <string>

namespace Explore
{
/// Reads one series of uncompressed DICOM slices, sorted by their position, with the rescale to
/// Hounsfield units applied, from a folder or the folders below it. `series` is its number in the
/// list of all, from 1 on; 0 is the series with most pixels, and a note lists the others. Throws
/// InputError if the folder holds something else.
Volume ReadDicomFolder(const std::string& path, int series = 0);

/// As ReadDicomFolder, from the folder of a file: the series to which the slice belongs, or for the
/// directory of a medium (DICOMDIR) as from a folder.
Volume ReadDicomFile(const std::string& path, int series = 0);

/// Whether a file is a DICOM slice, or the directory of a medium.
bool IsDicomFile(const std::string& path);
} // namespace Explore

#endif
