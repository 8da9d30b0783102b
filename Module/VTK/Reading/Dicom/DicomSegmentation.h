// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomSegmentation_h
#define Explore_DicomSegmentation_h

#include "VTK/Reading/Dicom/DicomHeader.h"
#include "VTK/Reading/VolumeLoader.h"

#include <string>
#include <vector>

namespace Explore
{
/// Reads the labels of a DICOM segmentation (SEG: binary, fractional or label map), and the names
/// and colours of its segments into the volume's table. `frames` are all frames of one file, in the
/// order of their positions. If `segment` is not 0, reads only the segment with this number,
/// counted from 1 in the order of the labels. Throws InputError, which names `path`.
Volume ReadDicomSegmentation(
  const std::string& path, const std::vector<DicomHeader>& frames, int segment = 0);
} // namespace Explore

#endif
