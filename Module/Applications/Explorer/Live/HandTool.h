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
/// Gives the hand in a window a needle (key N; again: a point), and writes the track of a needle in
/// tissue to a file (key T): track-001.vtp, or the next number that is not taken.
///
/// Values above the outer surface rub along the needle where the labels have no shaft friction.
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
