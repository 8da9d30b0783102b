// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tool in the hand in a setup, for writing and for reading alike.
 */
#ifndef HapticSetupTool_h
#define HapticSetupTool_h

#include "VTK/Base/HapticSetupNode.h"

class vtkVolumeHapticsAlgorithm;

namespace VolumeHaptics
{

/**
 * The entry Tool of the section Haptics, with its Kind, its settings and its functions. A filter
 * without a tool writes none; one of a file replaces that of the filter.
 */
void PassTool(SetupNode& haptics, vtkVolumeHapticsAlgorithm* filter);

} // namespace VolumeHaptics

#endif
