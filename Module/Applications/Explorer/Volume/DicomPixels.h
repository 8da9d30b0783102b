// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomPixels_h
#define Explore_DicomPixels_h

#include "Applications/Explorer/Volume/DicomHeader.h"

#include <string>

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
} // namespace Explore

#endif
