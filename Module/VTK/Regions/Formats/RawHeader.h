// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens MetaImage and NRRD files, whose header says where raw samples lie.
 */
#ifndef RawHeader_h
#define RawHeader_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Opens a file whose samples lie uncompressed after its header, or in a file beside it; if it may
 * be read as a whole, also compressed ones, text, and several files. The volume lies in the world
 * where ITK puts it: in left-posterior-superior if the header names a space. Throws
 * std::runtime_error, with the cure.
 */
LargeFile OpenRawHeader(const std::string& name, bool mayBeWhole);

} // namespace VolumeHaptics

#endif
