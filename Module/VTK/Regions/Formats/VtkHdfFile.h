// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opens images in VTKHDF files, by VTK's published specification of the format.
 */
#ifndef VtkHdfFile_h
#define VtkHdfFile_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Opens the image of a VTKHDF file, with its active array. Throws std::runtime_error, with the
 * cure.
 */
LargeFile OpenVtkHdf(const std::string& name);

} // namespace VolumeHaptics

#endif
