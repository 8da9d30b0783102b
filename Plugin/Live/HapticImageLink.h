// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Passes data from this process's own pipeline to a filter in the client without copying them. Also
 * passes large files, ParaView's cropping of a volume, and the opacity with which ParaView shows
 * it.
 */
#ifndef HapticImageLink_h
#define HapticImageLink_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkDataObject;
class vtkHapticDevice;
class vtkHapticRegionSource;
class vtkPVHapticLargeFile;
class vtkSMProxy;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

class HapticTimeStepLink;

/**
 * Passes images to a filter without a pipeline connection, because a view must not execute a filter
 * whose data the servo reads. The filter gets a shallow copy whenever the pipeline has new data.
 * The touched array stays unchanged if the pipeline allocates a new array for new data.
 */
class HapticImageLink
{
public:
  /** Updates the source. If its output is new, passes it to an input port of the filter. */
  void Update(vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort);
  /**
   * Passes an image with times to the filter, as time steps of input port 0. The source was updated
   * at `time`. A changed pipeline or changed settings begin a new volume. Throws std::bad_alloc if
   * memory is insufficient to copy a time step.
   */
  void PollTimeSteps(vtkSMSourceProxy* source, unsigned int port, double time,
    vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticTimeStepLink& timeSteps);
  /** Makes the next Update() pass the output even if it has not changed. */
  void Forget();

  /** Returns the output of a source in this process after an update; null without a source. */
  static vtkAlgorithmOutput* GetUpdatedOutput(vtkSMSourceProxy* source, unsigned int port);

private:
  bool IsSeen(vtkDataObject* data, vtkAlgorithm* filter) const;
  void See(vtkDataObject* data, vtkAlgorithm* filter);

  // Weak pointers, because a new object may have the address of a deleted one.
  vtkWeakPointer<vtkDataObject> Seen;
  vtkWeakPointer<vtkAlgorithm> SeenFilter;
  vtkMTimeType SeenTime = 0;
  vtkMTimeType PipelineTime = 0; // for time steps: last change of the pipeline
  // for time steps: whether the pipeline reuses the same arrays for each time step
  bool IsInPlace = false;
};

/**
 * Connects a filter in the client to a large file in this process's own pipeline.
 *
 * The hand uses a separate vtkHapticRegionSource, which the device updates.
 */
class HapticLargeLink
{
public:
  /**
   * Connects the filter to the samples of a large file, unless it is already connected. Returns
   * false if the output does not come from a large file.
   */
  bool Update(vtkAlgorithmOutput* output, vtkVolumeHapticsFilter* filter);

private:
  vtkSmartPointer<vtkHapticRegionSource> Regions; ///< null if the file can't be opened
  vtkWeakPointer<vtkPVHapticLargeFile> File;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter;
  vtkMTimeType OpenTime = 0;
};

/** Restricts a filter to the part of a volume to which a ParaView representation crops it. */
class HapticCropLink
{
public:
  /**
   * Copies the representation's properties UseCropping, CroppingOrigin and CroppingScale, if
   * present. Without a representation or without cropping, the whole volume is felt.
   */
  void Update(vtkSMProxy* representation, vtkVolumeHapticsFilter* filter);

private:
  bool HasCropped = false;
};

/** Finds the opacity with which ParaView shows a volume, because only visible voxels are felt. */
class HapticOpacityLink
{
public:
  /**
   * Finds the opacity function with which a source is volume-rendered in the active view or, if it
   * is not shown there, in any view. Returns it in a volume property that shares ParaView's
   * function. Returns null if the source is not volume-rendered, if the shown array or component is
   * not the touched one, or if the opacity also depends on other data.
   */
  vtkVolumeProperty* Find(vtkSMProxy* volume, vtkVolumeHapticsFilter* filter);

  /** Returns the view in which the opacity was found; null if there is none. */
  vtkSMProxy* GetView() const { return this->View; }

  /** Returns the representation with the opacity; null if there is none. */
  vtkSMProxy* GetRepresentation() const { return this->Representation; }

private:
  vtkNew<vtkVolumeProperty> Property;
  vtkWeakPointer<vtkSMProxy> Representation;
  vtkWeakPointer<vtkSMProxy> View;
};

} // namespace VolumeHapticsLive

#endif
