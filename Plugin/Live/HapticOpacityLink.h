// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the opacity with which ParaView shows a volume, because only visible voxels are felt.
 */
#ifndef HapticOpacityLink_h
#define HapticOpacityLink_h

#include "vtkNew.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

class vtkSMProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{

class HapticOpacityLink
{
public:
  /**
   * The opacity function of a source's volume rendering, in the active view, or else in any view:
   * as a volume property with ParaView's own function. Null if the source is not volume-rendered,
   * if the shown array or component is not the touched one, or if opacity does not depend on that
   * array's value alone.
   */
  vtkVolumeProperty* Find(vtkSMProxy* volume, vtkVolumeHapticsFilter* filter);

  /** The view where the opacity was found; null if there is none. */
  vtkSMProxy* GetView() const { return this->View; }

  /** The representation; null if there is none. */
  vtkSMProxy* GetRepresentation() const { return this->Representation; }

private:
  vtkNew<vtkVolumeProperty> Property;
  vtkWeakPointer<vtkSMProxy> Representation;
  vtkWeakPointer<vtkSMProxy> View;
};

} // namespace VolumeHapticsLive

#endif
