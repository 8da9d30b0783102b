// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandLabel_h
#define Explore_HandLabel_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkContextActor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkContext2D;

namespace Explore
{
/// Writes a label beside the tip: the tool, the touched material, the force, and the depth below
/// the surface that the viewer sees. Draws a scale with its unit. Ctrl+H hides both.
class HandLabel
{
public:
  HandLabel(TouchScene& touch, const Exploration& exploration);
  ~HandLabel();
  HandLabel(const HandLabel&) = delete;
  HandLabel& operator=(const HandLabel&) = delete;

  /// Draws the label and the scale. The context item calls this in each frame.
  bool Paint(vtkContext2D* painter);

private:
  std::vector<std::string> Describe() const;
  /// Returns the depth (mm) of a point below the first surface of the body that the viewer sees.
  double ComputeDepth(const double point[3]) const;
  void DrawScale(vtkContext2D* painter) const;
  void DrawLabel(vtkContext2D* painter) const;

  TouchScene& Touch;
  const vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  const vtkSmartPointer<vtkImageData> Image;
  const double OuterThreshold;
  const bool IsDark;
  const double MillimetersPerUnit; // mm per world unit of the volume
  bool IsShown = true;
  vtkNew<vtkContextActor> Actor;
};
} // namespace Explore

#endif
