// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads the modes of the method PRIMITIVES in a setup.
 */
#ifndef HapticSetupModes_h
#define HapticSetupModes_h

#include "VTK/Base/HapticSetupNode.h"

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Passes the entry Modes of the section Haptics. A filter without modes writes no entry; an entry
 * in a file replaces the filter's modes. Paths, surfaces and distance fields of guides are data,
 * which setups do not hold: a guide that stays at its place in the list keeps them.
 */
void PassModes(SetupNode& haptics, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
