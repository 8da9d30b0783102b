// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens MetaImage and NRRD files, whose header describes where raw samples are.
 */
#ifndef RawHeader_h
#define RawHeader_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Opens a file whose samples are uncompressed, after its header or in another file. If mayBeWhole,
 * also opens files whose samples are compressed, text, or in several files. The volume gets the
 * position in the world that ITK gives it: left-posterior-superior if the header names a space.
 * Throws std::runtime_error, with the cure.
 */
LargeFile OpenRawHeader(const std::string& name, bool mayBeWhole);

} // namespace VolumeHaptics

#endif
