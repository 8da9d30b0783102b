// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_PresetSaver_h
#define Explore_PresetSaver_h

#include "Applications/Explorer/Live/KeyBinding.h"
#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkRenderWindowInteractor.h"

#include <string>

namespace Explore
{
/// The key F8 saves the materials of the window as a preset, to a new preset-001.json, which
/// --preset takes.
class PresetSaver
{
public:
  PresetSaver(TouchScene& touch, vtkRenderWindowInteractor* interactor);

  /// For vtkInteractorStyleHaptic::SetApplicationKeys.
  static std::string ListKeys() { return "Preset\nF8\tsave the materials to a file\n"; }

private:
  void Save();

  TouchScene& Touch;
  vtkRenderWindowInteractor* const Interactor;
  KeyBinding Key;
};
} // namespace Explore

#endif
