// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomFolder_h
#define Explore_DicomFolder_h

#include "Applications/Explorer/Volume/DicomHeader.h"
#include "Applications/Explorer/Volume/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads one series of DICOM slices, sorted by their position, with the rescale to
/// Hounsfield units applied, from a folder or the folders below it. `series` is its number in the
/// list of all, from 1 on; 0 is the series with most pixels, and a note lists the others. Throws
/// InputError if the folder holds something else.
Volume ReadDicomFolder(const std::string& path, int series = 0);

/// As ReadDicomFolder, from the folder of a file: the series to which the slice belongs, the file
/// alone if it has several frames, or for the directory of a medium (DICOMDIR) as from a folder.
Volume ReadDicomFile(const std::string& path, int series = 0);

/// Whether a file is a DICOM slice, or the directory of a medium.
bool IsDicomFile(const std::string& path);

/// Throws InputError unless the first pixels of all slices are on one line.
void CheckLine(const std::string& path, const std::vector<DicomHeader>& slices);

/// Places the image of slices that may be tilted against the line on which they follow each other;
/// `length` is from the first to the last one, mm.
void PlaceSlices(const std::vector<DicomHeader>& slices, double length, vtkImageData* image);
} // namespace Explore

#endif
