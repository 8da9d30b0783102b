// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A NRRD file with a segmentation on the disk.
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
  NrrdHeader Header;
  NrrdImage Image;
};

/** Reads the header. False, with the reason and the cure, if that fails. */
bool OpenNrrdFile(const std::string& name, NrrdFile& file, std::string& error);

/**
 * Reads one label for each voxel into memory that holds zeros. False, with the reason and the cure,
 * if that fails.
 */
bool ReadNrrdFile(const NrrdFile& file, int* labels, std::string& error);

} // namespace VolumeHaptics

#endif
