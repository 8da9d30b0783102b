// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the tool in the hand in a setup.
 */
#ifndef HapticSetupTool_h
#define HapticSetupTool_h

#include "VTK/Base/HapticSetupNode.h"

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Passes the entry Tool of the section Haptics, with its Kind, its settings and its functions. A
 * filter without a tool writes no entry; an entry in a file replaces the filter's tool.
 */
void PassTool(SetupNode& haptics, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
