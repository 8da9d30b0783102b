// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The modes of the method PRIMITIVES in a setup, for writing and for reading alike.
 */
#ifndef HapticSetupModes_h
#define HapticSetupModes_h

#include "VTK/Base/HapticSetupNode.h"

class vtkVolumeHapticsAlgorithm;

namespace VolumeHaptics
{

/**
 * The entry Modes of the section Haptics. A filter without modes has none; one of a file replaces
 * those of the filter. Paths, surfaces and distance fields of guides are data, which no setup has:
 * a guide that stays at its place in the list keeps them.
 */
void PassModes(SetupNode& haptics, vtkVolumeHapticsAlgorithm* filter);

} // namespace VolumeHaptics

#endif
