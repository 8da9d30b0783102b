// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomFolder_h
#define Explore_DicomFolder_h

#include "VTK/Reading/Dicom/DicomHeader.h"
#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads one series of DICOM slices from a folder or the folders below it, sorted by position and
/// rescaled to Hounsfield units. `series` is its index in the list of all series, counted from 1; 0
/// selects the series with the most pixels and adds a note that lists the others. Throws InputError
/// if the folder contains something else.
Volume ReadDicomFolder(const std::string& path, int series = 0);

/// Reads the series of a slice from the folder of its file. A file with several frames is read
/// alone; `series` then chooses one of its volumes, or one segment of a segmentation. The directory
/// of a medium (DICOMDIR) is read as by ReadDicomFolder.
Volume ReadDicomFile(const std::string& path, int series = 0);

/// Returns whether a file is a DICOM slice or the directory of a medium (DICOMDIR).
bool IsDicomFile(const std::string& path);

/// Throws InputError unless the first pixels of all slices lie on one line.
void CheckLine(const std::string& path, const std::vector<DicomHeader>& slices);

/// Sets the geometry of an image of slices. The slices may be tilted against the line through their
/// first pixels. `length` (mm) is the distance from the first to the last slice.
void PlaceSlices(const std::vector<DicomHeader>& slices, double length, vtkImageData* image);
} // namespace Explore

#endif
