// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives data of this process' own pipeline to a filter in the client: shared, not copied. Also
 * gives it large files, the part to which ParaView crops a volume, and the opacity with which
 * ParaView shows the volume.
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
  void Update(vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort);
  /**
   * Gives an image that has times to the filter, as time steps of input port 0. Its source was
   * updated at `time`. A new pipeline, or new settings in it, begin a new volume. Throws
   * std::bad_alloc if there is no memory for a time step that has to be copied.
   */
  void PollTimeSteps(vtkSMSourceProxy* source, unsigned int port, double time,
    vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticTimeStepLink& timeSteps);
  /** Makes the next Update give the output, even if it has not changed. */
  void Forget();

  /** Returns the updated output of a source of this process; null without a source. */
  static vtkAlgorithmOutput* GetUpdatedOutput(vtkSMSourceProxy* source, unsigned int port);

private:
  bool IsSeen(vtkDataObject* data, vtkAlgorithm* filter) const;
  void See(vtkDataObject* data, vtkAlgorithm* filter);

  // A weak pointer: a new object may have the address of a deleted one.
  vtkWeakPointer<vtkDataObject> Seen;
  vtkWeakPointer<vtkAlgorithm> SeenFilter;
  vtkMTimeType SeenTime = 0;
  vtkMTimeType PipelineTime = 0; // time steps: last change of the pipeline
  bool IsInPlace = false;        // time steps: the pipeline writes each one to the same arrays
};

/**
 * Connects a filter in the client with a large file of this process' own pipeline.
 *
 * The hand has a vtkHapticRegionSource of its own, which the device follows.
 */
class HapticLargeLink
{
public:
  /**
   * Connects the filter with the samples of a large file, if an output comes from one and the
   * filter is not connected yet. False for other outputs.
   */
  bool Update(vtkAlgorithmOutput* output, vtkVolumeHapticsFilter* filter);

private:
  vtkSmartPointer<vtkHapticRegionSource> Regions; ///< null if the file can't be opened
  vtkWeakPointer<vtkPVHapticLargeFile> File;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter;
  vtkMTimeType OpenTime = 0;
};

/** Limits a filter to the part of a volume to which a representation of ParaView crops it. */
class HapticCropLink
{
public:
  /**
   * Copies the representation's properties UseCropping, CroppingOrigin and CroppingScale, as far as
   * it has them. Without a representation, or without its cropping, all is felt.
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
   * Finds the opacity function of a source's volume rendering, in the active view, or else in any
   * view, as a volume property with ParaView's own function. Null if the source is not
   * volume-rendered, if the shown array or component is not the touched one, or if opacity does not
   * depend on that array's value alone.
   */
  vtkVolumeProperty* Find(vtkSMProxy* volume, vtkVolumeHapticsFilter* filter);

  /** Returns the view where the opacity was found; null if there is none. */
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
