// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens images in VTKHDF files, following VTK's published specification of the format.
 */
#ifndef VtkHdfFile_h
#define VtkHdfFile_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Opens the active array of the image in a VTKHDF file. Throws std::runtime_error, with the cure.
 */
LargeFile OpenVtkHdf(const std::string& name);

} // namespace VolumeHaptics

#endif
