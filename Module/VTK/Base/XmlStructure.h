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
 * Returns how a file contradicts itself; empty if it is consistent. VTK's readers trust the file:
 * they write past the end of their memory if an array's size differs from its header, and they
 * allocate memory for any declared number of points. This function checks the types, components and
 * sizes of all arrays, the tables of their compressed blocks, and the extents of images.
 */
std::string DetectFalseXml(const std::string& file);

} // namespace VolumeHaptics

#endif
