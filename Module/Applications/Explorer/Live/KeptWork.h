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
/// Stores what was not saved when a window closed, for any reason: measurements, edited functions
/// of the materials and of the look, and what a burr removed. Each volume has a folder, in
/// $XDG_STATE_HOME/volumehaptics or ~/.local/state/volumehaptics, which only the user can read. The
/// next window on the volume offers this work, and key F11 restores it.
class KeptWork
{
public:
  /// `shown` is the file of the window. Functions that have not changed since the window's start
  /// are not stored. The stored functions are those of the outside look.
  KeptWork(TouchScene& touch, vtkVolumeHapticsFilter* filter, SavedMeasurements& measurements,
    HandTool& tool, LookSwitch& look, const FileChoice& shown);
  ~KeptWork();
  KeptWork(const KeptWork&) = delete;
  KeptWork& operator=(const KeptWork&) = delete;

  /// Returns a notice that lists the work which F11 would restore; empty if there is none.
  std::string GetOffer() const;
  /// Restores the work, as F11 does.
  void BringBack();

  /// Stores unsaved work, and reports it. Call this when the window has closed. `isSetUp`: whether
  /// the functions were saved to the file of --setup.
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
  std::string Folder;            ///< folder of this volume's work without its number; empty: none
  std::string Offered;           ///< folder of the offered work; empty if there is none, or if it
                                 ///< was restored
  std::string Brought;           ///< folder of the restored work
  std::vector<double> Functions; ///< values of the functions at the beginning
};
} // namespace Explore

#endif
