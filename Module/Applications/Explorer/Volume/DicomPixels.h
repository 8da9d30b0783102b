// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomPixels_h
#define Explore_DicomPixels_h

#include "Applications/Explorer/Volume/DicomHeader.h"

#include <string>

namespace Explore
{
/// Reads the samples of slices. It keeps those of the last compressed file, whose frames come one
/// after the other.
class DicomPixels
{
public:
  /// The samples of a slice of a series at `path`, which is for errors. The header is changed to
  /// what they are once they are unpacked. Throws an InputError.
  std::string Read(const std::string& path, DicomHeader& slice);

private:
  void Unpack(const std::string& path, const DicomHeader& slice);

  std::string File; // that is unpacked
  std::string Bytes;
  DicomHeader Unpacked; // what its samples are
};
} // namespace Explore

#endif
