// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The props of a touch in a view: the hand with its forces, and the figures.
 */
#ifndef HapticViewProps_h
#define HapticViewProps_h

#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticRepresentation.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

class vtkHapticDevice;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** Adds props to a renderer, and removes them when this object is destroyed. */
class HapticViewProps
{
public:
  /** The size of the hand follows the filter's image, if there is one. */
  HapticViewProps(vtkRenderer* renderer, vtkHapticDevice* device, vtkVolumeHapticsFilter* filter);
  ~HapticViewProps();
  HapticViewProps(const HapticViewProps&) = delete;
  HapticViewProps& operator=(const HapticViewProps&) = delete;

  vtkHapticHeadUpDisplay* GetDisplay() { return this->Display; }

private:
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkHapticRepresentation> Representation;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};

} // namespace VolumeHaptics

#endif
