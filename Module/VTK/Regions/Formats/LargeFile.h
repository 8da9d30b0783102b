// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens files of any supported format for reading boxes of their samples.
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

/** A volume in a file, with the reader of its samples. */
struct LargeFile
{
  BoxExtent Extent{};
  int ScalarType = VTK_SHORT;
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 9> Direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  BoxReader Read;
  std::vector<std::string> Notes; ///< for the user, on what was assumed or ignored
  /** Samples per chunk along x, y and z; zeros without chunks. */
  std::array<std::int64_t, 3> ChunkSize{};
  std::vector<LargeFile> Coarser; ///< coarser levels of the same volume, finest first
  /**
   * Names of the volumes in a file with several, each beginning with its number 1, 2, and so on.
   */
  std::vector<std::string> Volumes;
  int Volume = 1; ///< number of the opened volume
};

/**
 * Opens a file in the format of its extension. If mayBeWhole, also opens a file whose samples can't
 * be read in boxes, and reads all of it. For `volume`, see ChooseVolume(). Throws
 * std::runtime_error, with the cure.
 */
LargeFile OpenLargeFile(const std::string& name, bool mayBeWhole = false, int volume = 0);

/**
 * Returns the format of a file by its extension, or of a folder by its files, such as "NRRD"; empty
 * if it is unknown.
 */
std::string GetFormatName(const std::string& name);

/** Returns the extensions of all formats, such as ".nrrd .tif", separated by blanks. */
std::string ListFileEndings();

/**
 * Type of the functions that open a file or folder of one format, whatever its name: see
 * OpenLargeFile().
 */
using LargeFileOpener = LargeFile(const std::string& name, bool mayBeWhole, int volume);

/** Opens the active array of the image in a VTKHDF file: see VTK's specification of the format. */
LargeFileOpener OpenVtkHdf;
/**
 * Reads the layout of a VTKHDF file and packs it for OpenVtkHdf(); on failure, packs the error
 * text. Called in the reader process (ReaderProcess.h), because the HDF5 library may crash on a
 * damaged file.
 */
std::string PackVtkHdf(const std::string& name);

/**
 * Opens a MetaImage or NRRD file: a header, with the samples behind it or in other files. If
 * mayBeWhole, the samples may be compressed, text, or in several files. The volume is placed in the
 * world as ITK does it: left-posterior-superior if the header names a space.
 */
LargeFileOpener OpenRawHeader;

/**
 * OpenMgh opens FreeSurfer's .mgh, and, if mayBeWhole, .mgz, which is compressed. OpenMinc opens
 * MINC 1, a NetCDF file in the classic format. Both convert to left-posterior-superior.
 */
LargeFileOpener OpenMgh, OpenMinc;

/**
 * Opens a TIFF file with one page per slice, as micro-CT scanners and microscopes write it, or a
 * folder of files with one page each. Sorts files in natural order of their names. Skips pages of
 * other sizes, such as previews.
 *
 * The distance between voxels comes from OME-XML (PhysicalSizeX, Y, Z), from ImageJ's description
 * (unit, spacing) with the resolution of the pages, or from the resolution alone, for all three
 * axes; it is converted to mm. The notes list what was assumed.
 */
LargeFileOpener OpenTiff;
///@{
/**
 * List the pages of TIFF files, and read samples of pages, inside the reader process, which a
 * damaged file may crash. Both return the bytes that OpenTiff() and its reader unpack. `detail` is
 * the packed request.
 */
std::string PackTiff(const std::string& name, const std::string& detail);
std::string PackTiffBox(const std::string& detail);
///@}

/**
 * Returns whether a name has the extension .tif or .tiff, or is a folder with TIFF files but
 * without Zarr metadata.
 */
bool IsTiffName(const std::string& name);

/**
 * Returns whether most files of a folder are TIFF files; a folder of DICOM slices may contain a
 * few.
 */
bool IsTiffFolder(const std::string& folder);

/**
 * Opens a Zarr array, or an OME-Zarr image with its coarser levels: see the specifications of both.
 */
LargeFileOpener OpenZarr;

/**
 * Returns the VTK type for numbers of a kind and a size (bytes); 0 if there is none. Never throws.
 */
int ChooseScalarType(bool isInteger, bool isSigned, std::size_t size);

} // namespace VolumeHaptics

#endif
