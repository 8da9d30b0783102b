// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Images in VTKHDF files, by VTK's published specification of the format.
 */
#ifndef VtkHdfFile_h
#define VtkHdfFile_h

#include "VTK/Regions/Formats/LargeFile.h"

#include <string>

namespace VolumeHaptics
{

/**
 * The image of a VTKHDF file, with the array that is active there. Throws std::runtime_error, with
 * the cure.
 */
LargeFile OpenVtkHdf(const std::string& name);

} // namespace VolumeHaptics

#endif
