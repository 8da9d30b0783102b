// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a needle that is in tissue: its track in the colours of the labels, its shaft and its hub.
 */
#ifndef DrawnNeedle_h
#define DrawnNeedle_h

#include "VTK/Scene/Hand/ColoredTubes.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTubeFilter.h"

class vtkBoundingBox;
class vtkHapticDevice;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

class DrawnNeedle
{
public:
  DrawnNeedle();

  /** Shows the latest state, or nothing without a device. Lengths are in world units. */
  void Update(vtkHapticDevice* device, double radius, double length);

  /** Whether a needle is in tissue. */
  bool IsShown() const { return this->Lines.AreShown(); }
  void RenderOpaque(vtkViewport* viewport);
  /** Draws the faint copy. */
  void RenderHidden(vtkViewport* viewport) { this->Lines.RenderHidden(viewport); }
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box) { this->Lines.AddTo(box); }

private:
  void Draw(vtkHapticDevice* device, double length);

  vtkNew<vtkPolyData> Track;
  ColoredTubes Lines{ 12 }; ///< pieces of the track, then the shaft outside the tissue
  vtkNew<vtkPolyData> HubLine;
  vtkNew<vtkTubeFilter> Hub;
  vtkNew<vtkPolyDataMapper> HubMapper;
  vtkNew<vtkActor> HubActor;
  double Time = -1.0; ///< time and length of the drawn lines
  double Length = 0.0;
};

} // namespace VolumeHaptics

#endif
