// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandTool_h
#define Explore_HandTool_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticPointShell.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <string>

namespace Explore
{
/// Gives the hand in a window a needle (key N; again: the tool of a file, if there is one, and a
/// point), and writes the track of a needle in tissue to a file (key T): track-001.vtp, or the next
/// number that is not taken.
///
/// Values above the outer surface rub along the needle where the labels have no shaft friction, and
/// are solid for the tool of a file.
class HandTool
{
public:
  HandTool(TouchScene& touch, const Exploration& exploration, vtkRenderWindowInteractor* interactor,
    const std::string& tool);
  ~HandTool();
  HandTool(const HandTool&) = delete;
  HandTool& operator=(const HandTool&) = delete;

  /// For vtkInteractorStyleHaptic::SetApplicationKeys.
  std::string ListKeys() const
  {
    return std::string("Tool\nN\tneedle; ") + (this->HasShape() ? "its shape; " : "") +
      "point\nT\tsave the needle's track\n";
  }

private:
  void PressKey();
  bool HasShape() const { return this->Shape->GetMesh() != nullptr; }
  void ChangeTool();
  void Take(vtkHapticTool* tool);
  void WriteTrack();

  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkHapticNeedle> Needle;
  vtkNew<vtkHapticPointShell> Shape;
  vtkNew<vtkCallbackCommand> KeyObserver;
};
} // namespace Explore

#endif
