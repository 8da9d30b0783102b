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
/// Reads the samples of slices. Caches the decompressed samples of the last compressed file,
/// because a file's frames are read one after another.
class DicomPixels
{
public:
  /// Reads the samples of a slice and changes the header to describe the decompressed samples.
  /// `path` names the series in errors. Throws InputError.
  std::string Read(const std::string& path, DicomHeader& slice);

private:
  void Unpack(const std::string& path, const DicomHeader& slice);

  std::string File; // file whose samples are cached
  std::string Bytes;
  DicomHeader Unpacked; // layout of the cached samples
};

/// Returns the size (bytes) that one of the slices needs in memory. Check it before reading,
/// because a compressed file can declare any size.
double MeasureSlices(const std::vector<DicomHeader>& slices);

/// Corrects a wrong HighBit in all phases of a series if all samples are in the low bits. Adds a
/// note on anything else in the bits below the stored ones, such as an overlay. Throws InputError.
void CorrectHighBit(const std::string& path, std::vector<std::vector<DicomHeader>>& phases,
  std::vector<std::string>& notes);

/// Reads the values of slices in this order into an image without a position. Chooses the smallest
/// type that can store all values. Pixels that were not measured get the smallest value, with a
/// note. Throws InputError.
vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, std::vector<std::string>& notes);
} // namespace Explore

#endif
