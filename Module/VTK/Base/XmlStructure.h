// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks a file of VTK's XML formats before VTK's reader opens it.
 */
#ifndef XmlStructure_h
#define XmlStructure_h

#include <string>

namespace VolumeHaptics
{

/**
 * Returns why a file contradicts itself, or an empty text if it does not. VTK's readers trust what
 * a file says: they write past the end of their memory if an array's size is not what its header
 * says, and allocate memory for all points that are promised. This checks the types, components and
 * sizes of all arrays, the tables of their compressed blocks, and the extents of images.
 */
std::string DetectFalseXml(const std::string& file);

} // namespace VolumeHaptics

#endif
