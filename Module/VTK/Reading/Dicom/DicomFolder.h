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
/// Reads one series of DICOM slices from a folder or the folders below it, sorted by their
/// position, with the rescale to Hounsfield units applied. `series` is its number in the list of
/// all series, which begins at 1; 0 stands for the series with most pixels, and a note lists the
/// others. Throws InputError if the folder contains something else.
Volume ReadDicomFolder(const std::string& path, int series = 0);

/// Reads the series to which a slice belongs, from the folder of its file. A file with several
/// frames is read alone, and `series` chooses one of its volumes, or one segment of a segmentation.
/// The directory of a medium (DICOMDIR) is read like ReadDicomFolder.
Volume ReadDicomFile(const std::string& path, int series = 0);

/// Returns whether a file is a DICOM slice, or the directory of a medium.
bool IsDicomFile(const std::string& path);

/// Throws InputError unless the first pixels of all slices are on one line.
void CheckLine(const std::string& path, const std::vector<DicomHeader>& slices);

/// Sets the geometry of an image of slices, which may be tilted against the line on which they
/// follow each other. `length` (mm) is the distance from the first to the last slice.
void PlaceSlices(const std::vector<DicomHeader>& slices, double length, vtkImageData* image);
} // namespace Explore

#endif
