// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomPixels_h
#define Explore_DicomPixels_h

#include "Applications/Explorer/Volume/DicomHeader.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads the samples of slices. It stores those of the last compressed file, whose frames follow
/// each other.
class DicomPixels
{
public:
  /// The samples of a slice in a series at `path`, which is used in errors. Changes the header to
  /// describe the unpacked samples. Throws an InputError.
  std::string Read(const std::string& path, DicomHeader& slice);

private:
  void Unpack(const std::string& path, const DicomHeader& slice);

  std::string File; // the unpacked file
  std::string Bytes;
  DicomHeader Unpacked; // describes its samples
};

/// The bytes of a slice in memory, before they are taken: compressed files can promise any number.
double MeasureSlices(const std::vector<DicomHeader>& slices);

/// The values of slices in this order, of the smallest type that holds all, without a place. What
/// was not measured gets the least value, with a note. Throws an InputError.
vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<DicomHeader>& slices, std::vector<std::string>& notes);
} // namespace Explore

#endif
