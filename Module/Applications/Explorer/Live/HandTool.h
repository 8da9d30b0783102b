// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandTool_h
#define Explore_HandTool_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkHapticNeedle.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// What the hand in a window holds: key N changes between a point and a needle, and T writes the
/// needle's track, while it is in tissue, to the first free of track-001.vtp ...
///
/// Where labels do not say how they rub along the needle, everything in the body does.
class HandTool
{
public:
  HandTool(TouchScene& touch, const Exploration& exploration, vtkRenderWindowInteractor* interactor,
    const std::string& tool);
  ~HandTool();
  HandTool(const HandTool&) = delete;
  HandTool& operator=(const HandTool&) = delete;

  /// For vtkInteractorStyleHaptic::SetApplicationKeys.
  static std::string ListKeys() { return "Tool\nN\tneedle; point\nT\tsave the needle's track\n"; }

private:
  void PressKey();
  void ChangeTool();
  void WriteTrack();

  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkHapticNeedle> Needle;
  vtkNew<vtkCallbackCommand> KeyObserver;
};
} // namespace Explore

#endif
