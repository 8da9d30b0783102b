// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_KeptWork_h
#define Explore_KeptWork_h

#include "Applications/Explorer/Live/HandTool.h"
#include "Applications/Explorer/Live/LookSwitch.h"
#include "Applications/Explorer/Live/SavedMeasurements.h"
#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Stores unsaved work when a window closes, for any reason: measurements, edited functions of the
/// materials and of the look, and the tissue that a burr removed. Each volume has a folder, in
/// $XDG_STATE_HOME/volumehaptics or ~/.local/state/volumehaptics, which only the user can read. The
/// next window that shows the volume offers this work, and key F11 restores it.
class KeptWork
{
public:
  /// `shown` is the file that the window shows. Functions that have not changed since the window
  /// opened are not stored. The stored functions of the look are those of the outside.
  KeptWork(TouchScene& touch, vtkVolumeHapticsFilter* filter, SavedMeasurements& measurements,
    HandTool& tool, LookSwitch& look, const FileChoice& shown);
  ~KeptWork();
  KeptWork(const KeptWork&) = delete;
  KeptWork& operator=(const KeptWork&) = delete;

  /// Returns a notice that lists the work that F11 restores; empty if there is none.
  std::string GetOffer() const;
  /// Restores the work, as F11 does.
  void BringBack();

  /// Stores unsaved work, and reports it. Call this when the window has closed. `isSetUp`: whether
  /// the functions were already saved to the file of --setup.
  void KeepAtEnd(bool isSetUp);

private:
  std::vector<double> ListFunctions() const;
  /// Lists the unsaved work in words.
  std::string Describe(bool hasMeasurements, bool hasFunctions, bool hasRemoval) const;

  TouchScene& Touch;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  SavedMeasurements& Measurements;
  HandTool& Tool;
  LookSwitch& Look;
  std::string Folder; ///< folder of this volume's work without its number; empty: none
  /// folder of the offered work; empty if none is offered, or if it has been restored
  std::string Offered;
  std::string Brought;           ///< folder of the restored work
  std::vector<double> Functions; ///< values of the functions when the window opened
};
} // namespace Explore

#endif
