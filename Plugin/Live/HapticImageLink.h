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
class vtkDataObject;
class vtkSMSourceProxy;

namespace VolumeHapticsLive
{

/**
 * The filter is not connected to the pipeline, since a view must not execute what the servo reads:
 * it gets a shallow copy whenever the pipeline has something new. A pipeline that allocates anew
 * then leaves the array alone that is being touched.
 */
class HapticImageLink
{
public:
  /**
   * Bring the source up to date, and give its output to an input port of the filter if it is new.
   */
  void Follow(vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort);

private:
  // Weak: a new object may have the address of one that was deleted.
  vtkWeakPointer<vtkDataObject> Seen;
  vtkWeakPointer<vtkAlgorithm> SeenFilter;
  vtkMTimeType SeenTime = 0;
};

} // namespace VolumeHapticsLive

#endif
