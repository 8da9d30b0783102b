// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Touches the path on port 1 of a vtkVolumeHapticsFilter, tick by tick, and writes the trace.
 */
#ifndef PathTouch_h
#define PathTouch_h

#include "VTK/Base/HapticHash.h"
#include "VTK/Trace/TraceArrayChoice.h"

class vtkPolyData;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Touches the volume on port 0 along a path, and writes the chosen arrays of the trace. Without a
 * path, only checks the input. Returns false after an error, which the filter has reported.
 * @param labelHash hash of the labels on port 3, to compare with the hash in a recording
 */
bool TouchPath(vtkVolumeHapticsFilter* filter, vtkPolyData* path, TraceArrayChoice arrays,
  ArrayHash& labelHash, vtkPolyData* output);

} // namespace VolumeHaptics

#endif
