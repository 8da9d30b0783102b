// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the label table in a setup.
 */
#ifndef HapticSetupLabels_h
#define HapticSetupLabels_h

#include "VTK/Base/HapticSetupNode.h"

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Passes the entry Labels of the section Haptics: stand-off and labels of the filter's table. A
 * filter without a table writes no entry, and gets a table if the file has the entry.
 */
void PassLabels(SetupNode& haptics, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
