// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens files that describe the volume that they contain.
 */
#ifndef LargeFile_h
#define LargeFile_h

#include "VTK/Regions/Formats/LargeVolume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** A volume in a file, and its reader. */
struct LargeFile
{
  BoxExtent Extent{};
  int ScalarType = VTK_SHORT;
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 9> Direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  BoxReader Read;
  std::vector<std::string> Notes; ///< notes for the user on what was assumed or left out
  /** Size of a chunk in samples along x, y and z; zeros if there are no chunks. */
  std::array<std::int64_t, 3> ChunkSize{};
  std::vector<LargeFile> Coarser; ///< coarser levels of the same volume, the finest first
  /** If the file has several volumes: their names, which begin with the numbers 1, 2, and so on. */
  std::vector<std::string> Volumes;
  int Volume = 1; ///< number of the volume that is read
};

/**
 * Opens a file, by the ending of its name. If mayBeWhole, also opens a file whose samples can't be
 * read in boxes, and reads it as a whole. For `volume`, see ChooseVolume(). Throws
 * std::runtime_error, with the cure.
 */
LargeFile OpenLargeFile(const std::string& name, bool mayBeWhole = false, int volume = 0);

/**
 * Returns the format of a file, by its ending, or of a folder, by its files, such as "NRRD"; empty
 * if it is of none.
 */
std::string GetFormatName(const std::string& name);

/** Returns the endings of all formats, such as ".nrrd .tif", with a blank between them. */
std::string ListFileEndings();

/** Opens a file or folder, as OpenLargeFile() does, whatever its ending. */
using LargeFileOpener = LargeFile(const std::string& name, bool mayBeWhole, int volume);

/** Opens the active array of the image in a VTKHDF file, following VTK's specification. */
LargeFileOpener OpenVtkHdf;
/**
 * Reads the layout of a VTKHDF file and packs it for OpenVtkHdf(); on failure, packs the error
 * text. Called in the reader process (ReaderProcess.h), because the HDF5 library may crash on a
 * damaged file.
 */
std::string PackVtkHdf(const std::string& name);

/**
 * Opens a MetaImage or NRRD file: a header, and samples after it or in other files. If mayBeWhole,
 * the samples may be compressed, text, or in several files. The volume gets the position in the
 * world that ITK gives it: left-posterior-superior if the header names a space.
 */
LargeFileOpener OpenRawHeader;

/**
 * Opens a file of FreeSurfer, .mgh, or .mgz if mayBeWhole, because it is packed. Opens MINC 1, a
 * NetCDF file in its classic format. Both are converted to left-posterior-superior.
 */
LargeFileOpener OpenMgh, OpenMinc;

/**
 * Opens a TIFF file with a page for each slice, as micro-CT scanners and microscopes write it, or a
 * folder of files with one page each. Files are ordered by the numbers in their names. Pages of
 * other sizes, such as previews, are left out.
 *
 * The distance between voxels comes from OME-XML (PhysicalSizeX, Y, Z), from ImageJ's description
 * (unit, spacing) with the resolution of the pages, or from the resolution alone, for all three
 * axes; it is converted to mm. The notes list what was assumed.
 */
LargeFileOpener OpenTiff;
///@{
/**
 * Read which pages TIFF files have, and samples of pages, in the process that the library may end;
 * return what OpenTiff() and its reader unpack. `detail` is what these have packed.
 */
std::string PackTiff(const std::string& name, const std::string& detail);
std::string PackTiffBox(const std::string& detail);
///@}

/**
 * Returns whether a name ends with .tif or .tiff, or is that of a folder that contains TIFF files
 * but no Zarr.
 */
bool IsTiffName(const std::string& name);

/**
 * Returns whether most files of a folder are TIFF files. A folder of DICOM slices may contain some
 * as well.
 */
bool IsTiffFolder(const std::string& folder);

/**
 * Opens a Zarr array, or an OME-Zarr image with its coarser levels, following their specifications.
 */
LargeFileOpener OpenZarr;

/**
 * Returns VTK's type for numbers of a kind and a size (bytes); 0 if there is none. Never throws.
 */
int ChooseScalarType(bool isInteger, bool isSigned, std::size_t size);

} // namespace VolumeHaptics

#endif
