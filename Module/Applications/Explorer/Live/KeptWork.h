// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_KeptWork_h
#define Explore_KeptWork_h

#include "Applications/Explorer/Live/HandTool.h"
#include "Applications/Explorer/Live/KeyBinding.h"
#include "Applications/Explorer/Live/LookSwitch.h"
#include "Applications/Explorer/Live/SavedMeasurements.h"
#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Keeps what was not saved when a window closed, in whatever way: measurements, edited functions
/// of the materials and of the picture, and what a burr removed. It lies in a folder for this
/// volume in $XDG_STATE_HOME/volumehaptics or ~/.local/state/volumehaptics, which only the user can
/// read. The next window on the volume offers it, and key F11 brings it back.
class KeptWork
{
public:
  /// `shown` is the file of the window. The functions that the window begins with are not kept, and
  /// those of the outside are.
  KeptWork(TouchScene& touch, vtkVolumeHapticsFilter* filter, SavedMeasurements& measurements,
    HandTool& tool, LookSwitch& look, vtkRenderWindowInteractor* interactor,
    const FileChoice& shown);

  /// As in vtkHapticHeadUpDisplay::HelpText; empty if there is nothing to bring back.
  std::string ListKeys() const;
  /// What F11 would bring back, as a notice; empty if there is nothing.
  std::string GetOffer() const;
  /// As F11.
  void BringBack();

  /// Call when the window has closed: keeps what is not saved, and tells it. `isSetUp`: the
  /// functions were saved to the file of --setup.
  void KeepAtEnd(bool isSetUp);

private:
  std::vector<double> ListFunctions() const;
  /// Names the unsaved work in words.
  std::string Describe(bool hasMeasurements, bool hasFunctions, bool hasRemoval) const;

  TouchScene& Touch;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  SavedMeasurements& Measurements;
  HandTool& Tool;
  LookSwitch& Look;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  std::string Folder;  ///< where the work of this volume goes, without its number; empty: nowhere
  std::string Offered; ///< a folder; empty if there is none, or it was brought back
  std::string Brought; ///< a folder
  std::vector<double> Functions; ///< at the beginning
  KeyBinding Key;
};
} // namespace Explore

#endif
