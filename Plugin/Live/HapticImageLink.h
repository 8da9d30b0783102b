// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Data of this process' own pipeline, for a filter in the client: shared, not copied.
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
 * allocates a new array then leaves the touched one alone.
 */
class HapticImageLink
{
public:
  /**
   * Update the source, and give its output to an input port of the filter if it is new.
   */
  void Follow(vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort);
  /**
   * The same with an image that has times, as frames of input port 0. Its source was updated at a
   * time. Another pipeline, or other settings in it, are another volume. Throws std::bad_alloc if
   * there is no memory for a frame that has to be copied.
   */
  void FollowFrames(vtkSMSourceProxy* source, unsigned int port, double time,
    vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticFrameLink& frames);
  /** The next Follow gives the output, even if it is the last one. */
  void Forget();

  /** The output of a source of this process, updated; null without one. */
  static vtkAlgorithmOutput* FindOutput(vtkSMSourceProxy* source, unsigned int port);

private:
  bool IsSeen(vtkDataObject* data, vtkAlgorithm* filter) const;
  void See(vtkDataObject* data, vtkAlgorithm* filter);

  // Weak: a new object may have the address of one that was deleted.
  vtkWeakPointer<vtkDataObject> Seen;
  vtkWeakPointer<vtkAlgorithm> SeenFilter;
  vtkMTimeType SeenTime = 0;
  vtkMTimeType PipelineTime = 0; // of frames: when the pipeline was last changed
  bool IsInPlace = false;        // of frames: the pipeline writes each one to the same arrays
};

} // namespace VolumeHapticsLive

#endif
