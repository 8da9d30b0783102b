// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Texts beside points of the scene that cover neither each other nor the head-up display.
 */
#ifndef MeasuredLabels_h
#define MeasuredLabels_h

#include "Core/Math/Vector3.h"

#include "vtkNew.h"
#include "vtkTextActor.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkRenderer;
class vtkWindow;

namespace VolumeHaptics
{

class MeasuredLabels
{
public:
  /** Pixels of the viewport: left, right, bottom, top. */
  struct Box
  {
    double Left;
    double Right;
    double Bottom;
    double Top;
  };

  struct Label
  {
    std::string Text;
    Vector3 Place; ///< world
  };

  /**
   * Draws labels in the overlay pass. Earlier labels get their preferred places; a label without
   * room is left out. Returns the number of labels drawn.
   */
  int Render(vtkRenderer* renderer, const std::vector<Label>& labels,
    const std::function<bool(const Box&)>& isTaken);
  void Release(vtkWindow* window);

private:
  std::vector<std::unique_ptr<vtkNew<vtkTextActor>>> Actors;
};

} // namespace VolumeHaptics

#endif
