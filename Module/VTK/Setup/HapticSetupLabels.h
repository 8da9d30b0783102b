// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The label table in a setup, for writing and for reading alike.
 */
#ifndef HapticSetupLabels_h
#define HapticSetupLabels_h

#include "VTK/Base/HapticSetupNode.h"

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * The entry Labels of the section Haptics: stand-off and labels of the filter's table. A filter
 * without a table has none, and gets one if the file has the entry.
 */
void PassLabels(SetupNode& haptics, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
