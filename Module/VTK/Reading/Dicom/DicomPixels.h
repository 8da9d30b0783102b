// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomPixels_h
#define Explore_DicomPixels_h

#include "VTK/Reading/Dicom/DicomHeader.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads the samples of slices. Stores the samples of the last compressed file, whose frames follow
/// each other.
class DicomPixels
{
public:
  /// Reads the samples of a slice in a series at `path`, which is used in errors. Changes the
  /// header to describe the unpacked samples. Throws an InputError.
  std::string Read(const std::string& path, DicomHeader& slice);

private:
  void Unpack(const std::string& path, const DicomHeader& slice);

  std::string File; // the unpacked file
  std::string Bytes;
  DicomHeader Unpacked; // describes the samples of that file
};

/// Returns how many bytes one of the slices will take in memory, for a check before they are read:
/// compressed files can promise any number.
double MeasureSlices(const std::vector<DicomHeader>& slices);

/// Reads the values of slices in this order into an image without a place, of the smallest type
/// that holds all values. Pixels that were not measured get the least value, with a note. Throws an
/// InputError.
vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, std::vector<std::string>& notes);
} // namespace Explore

#endif
