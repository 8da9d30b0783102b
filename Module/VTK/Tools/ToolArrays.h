// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lists the trace arrays that only some tools have.
 */
#ifndef ToolArrays_h
#define ToolArrays_h

#include "Core/Model/BakedTool.h"

#include "vtkVolumeHapticsModule.h" // for export macro

#include <vector>

namespace VolumeHaptics
{

/**
 * Lists the arrays of all kinds of tools, in the order of GetToolKinds(). Exported for programs
 * that write traces.
 */
VTKVOLUMEHAPTICS_EXPORT const std::vector<const ToolColumn*>& GetToolArrays();

} // namespace VolumeHaptics

#endif
