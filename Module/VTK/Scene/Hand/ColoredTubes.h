// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws lines of several colours as tubes, and a faint copy over objects that hide them.
 */
#ifndef ColoredTubes_h
#define ColoredTubes_h

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

class vtkBoundingBox;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

class ColoredTubes
{
public:
  explicit ColoredTubes(int sides);

  /**
   * Returns the polylines to draw. Their cell scalars, an array from NewColors(), are their
   * colours.
   */
  vtkPolyData* GetLines() const { return this->Lines; }
  static vtkSmartPointer<vtkUnsignedCharArray> NewColors();
  void SetRadius(double radius) { this->Tubes->SetRadius(radius); }
  bool AreShown() const { return this->Lines->GetNumberOfLines() > 0; }

  void RenderOpaque(vtkViewport* viewport);
  /** Draws a faint copy of the lines over objects that hide them. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  vtkNew<vtkPolyData> Lines;
  vtkNew<vtkTubeFilter> Tubes;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;
};

} // namespace VolumeHaptics

#endif
