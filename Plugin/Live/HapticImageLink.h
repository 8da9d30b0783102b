// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives data of this process' own pipeline to a filter in the client: shared, not copied.
 */
#ifndef HapticImageLink_h
#define HapticImageLink_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkDataObject;
class vtkHapticDevice;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{
class HapticFrameLink;

/**
 * The filter is not connected to the pipeline, because a view must not execute a filter whose data
 * the servo reads. It gets a shallow copy whenever the pipeline has new data. A pipeline that
 * allocates a new array then does not change the touched array.
 */
class HapticImageLink
{
public:
  /**
   * Update the source, and give its output to an input port of the filter if it is new.
   */
  void Follow(vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort);
  /**
   * Gives an image that has times to the filter, as frames of input port 0. Its source was updated
   * at `time`. A new pipeline, or new settings in it, begin a new volume. Throws std::bad_alloc if
   * there is no memory for a frame that has to be copied.
   */
  void FollowFrames(vtkSMSourceProxy* source, unsigned int port, double time,
    vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticFrameLink& frames);
  /** Makes the next Follow give the output, even if it has not changed. */
  void Forget();

  /** The updated output of a source of this process; null without a source. */
  static vtkAlgorithmOutput* FindOutput(vtkSMSourceProxy* source, unsigned int port);

private:
  bool IsSeen(vtkDataObject* data, vtkAlgorithm* filter) const;
  void See(vtkDataObject* data, vtkAlgorithm* filter);

  // A weak pointer: a new object may have the address of a deleted one.
  vtkWeakPointer<vtkDataObject> Seen;
  vtkWeakPointer<vtkAlgorithm> SeenFilter;
  vtkMTimeType SeenTime = 0;
  vtkMTimeType PipelineTime = 0; // frames: last change of the pipeline
  bool IsInPlace = false;        // frames: the pipeline writes each one to the same arrays
};

} // namespace VolumeHapticsLive

#endif
