// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes the lines and surfaces of vtkHapticGuideMode.
 */
#ifndef GuideShapes_h
#define GuideShapes_h

#include <string>

class vtkHapticGuideMode;

namespace VolumeHaptics
{
struct ModeDescription;

/**
 * Describes the path, the surface or the distance field of a guide. Corners are rounded by
 * `rounding` (world units). Returns false, with the reason and the cure in `error`, unless the
 * guide has exactly one of them, which can be felt.
 */
bool DescribeGuide(
  vtkHapticGuideMode* mode, double rounding, ModeDescription& d, std::string& error);

} // namespace VolumeHaptics

#endif
