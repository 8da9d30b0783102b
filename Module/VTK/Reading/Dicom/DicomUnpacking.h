// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomUnpacking_h
#define Explore_DicomUnpacking_h

#include "VTK/Reading/Dicom/DicomHeader.h"

#include <string>

namespace Explore
{
/// Whether this build has GDCM, which unpacks JPEG, JPEG-LS, JPEG 2000 and RLE.
bool CanUnpackDicom();

/// Unpacks the samples of all frames of a compressed file, least significant byte first. Changes
/// the header to describe them. Returns false if they can't be unpacked.
bool UnpackDicom(DicomHeader& slice, std::string& bytes);
} // namespace Explore

#endif
