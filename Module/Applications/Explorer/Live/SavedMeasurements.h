// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SavedMeasurements_h
#define Explore_SavedMeasurements_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"

#include <string>

namespace Explore
{
/// The measurements of a window in a file: by the key S, and when the window is closed.
class SavedMeasurements
{
public:
  /// Reads the file, if there is one; its name may be empty. Throws InputError if it can't be read.
  SavedMeasurements(TouchScene& touch, std::string file);

  /// From now on, the key S saves: without a file, to measurements.mrk.json.
  void SaveByKey(vtkRenderWindowInteractor* interactor);

  /// Saves to the file. Without one, tells what is lost. Throws InputError if it can't be written.
  void SaveAtEnd();

private:
  /// False, with the reason, if that fails.
  bool Save(std::string& error);

  TouchScene& Touch;
  std::string File;
  vtkMTimeType Saved; ///< the time of the list in the file
  vtkNew<vtkCallbackCommand> Key;
};
} // namespace Explore

#endif
