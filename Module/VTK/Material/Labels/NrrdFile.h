// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a segmentation from a NRRD file.
 */
#ifndef NrrdFile_h
#define NrrdFile_h

#include "VTK/Material/Labels/NrrdImage.h"
#include "VTK/Material/Labels/NrrdLabels.h"

#include <string>

namespace VolumeHaptics
{

struct NrrdFile
{
  std::string Name;
  SegmentationHeader Header;
  NrrdImage Image;
};

/** Reads the header. On failure, returns false, with the reason and the cure in `error`. */
bool OpenNrrdFile(const std::string& name, NrrdFile& file, std::string& error);

/**
 * Reads one label for each voxel into memory that is filled with zeros. On failure, returns false,
 * with the reason and the cure in `error`.
 */
bool ReadNrrdFile(const NrrdFile& file, int* labels, std::string& error);

} // namespace VolumeHaptics

#endif
