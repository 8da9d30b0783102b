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
 * Returns why the numbers that a file tells about itself can't be true; empty if they can. VTK's
 * readers believe them: they write behind their memory where an array has another size than its
 * header says, and take memory for all points that are promised. Checked are the types, components
 * and sizes of all arrays, the tables of their compressed blocks, and the extents of images.
 */
std::string DetectFalseXml(const std::string& file);

} // namespace VolumeHaptics

#endif
