// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens stacks of TIFF pages, which micro-CT scanners and microscopes write.
 */
#ifndef TiffFile_h
#define TiffFile_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Whether a name ends with .tif or .tiff, or is that of a folder that contains TIFF files but no
 * Zarr.
 */
bool IsTiffName(const std::string& name);

/**
 * Whether most files of a folder are TIFF files. A folder of DICOM slices may contain some as well.
 */
bool IsTiffFolder(const std::string& folder);

/**
 * Opens a file with a page for each slice, or a folder of files with one page each. Files are
 * ordered by the numbers in their names. Pages of other sizes, such as previews, are left out.
 *
 * The distance between voxels comes from OME-XML (PhysicalSizeX, Y, Z), from ImageJ's description
 * (unit, spacing) with the resolution of the pages, or from the resolution alone, for all three
 * axes; it is converted to mm. Of several channels and times, the first one is read. The notes list
 * what was assumed. Throws std::runtime_error, with the cure.
 */
LargeFile OpenTiff(const std::string& name);

} // namespace VolumeHaptics

#endif
