// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Connects a filter in the client with a large file of this process' own pipeline.
 */
#ifndef HapticLargeLink_h
#define HapticLargeLink_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkAlgorithmOutput;
class vtkHapticRegionSource;
class vtkPVHapticLargeFile;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

/** The hand has a vtkHapticRegionSource of its own, which the device follows. */
class HapticLargeLink
{
public:
  /**
   * If an output comes from a large file, connects the filter with its samples, unless it already
   * is connected. False for other outputs.
   */
  bool Follow(vtkAlgorithmOutput* output, vtkVolumeHapticsFilter* filter);

private:
  vtkSmartPointer<vtkHapticRegionSource> Regions; ///< null if the file can't be opened
  vtkWeakPointer<vtkPVHapticLargeFile> File;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter;
  vtkMTimeType OpenTime = 0;
};

} // namespace VolumeHapticsLive

#endif
