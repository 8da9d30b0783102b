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
/// Reads the samples of slices. Stores the unpacked samples of the last compressed file, because
/// the file's frames follow each other.
class DicomPixels
{
public:
  /// Reads the samples of a slice in a series at `path`, which is named in errors. Changes the
  /// header to describe the unpacked samples. Throws InputError.
  std::string Read(const std::string& path, DicomHeader& slice);

private:
  void Unpack(const std::string& path, const DicomHeader& slice);

  std::string File; // name of the file that was unpacked
  std::string Bytes;
  DicomHeader Unpacked; // describes the samples of that file
};

/// Returns the size (bytes) of one of the slices in memory, for a check before they are read,
/// because compressed files can promise any number.
double MeasureSlices(const std::vector<DicomHeader>& slices);

/// Corrects the HighBit of a series whose samples are all in the low bits: of all its phases, or of
/// none. Notes what else is in the bits below the stored ones, such as an overlay. Throws
/// InputError.
void CorrectHighBit(const std::string& path, std::vector<std::vector<DicomHeader>>& phases,
  std::vector<std::string>& notes);

/// Reads the values of slices in this order into an image without a position. Chooses the smallest
/// type that can store all values. Pixels that were not measured get the least value, with a note.
/// Throws InputError.
vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, std::vector<std::string>& notes);
} // namespace Explore

#endif
