// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SavedMeasurements_h
#define Explore_SavedMeasurements_h

#include "Applications/Explorer/Live/KeyBinding.h"
#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkRenderWindowInteractor.h"

#include <iosfwd>
#include <memory>
#include <string>

namespace Explore
{
/// Saves the measurements of a window to a file: by the key S, and when the window is closed. A
/// file that could only be read in part is not changed, and the list goes to a new file beside it.
class SavedMeasurements
{
public:
  /// Reads the file, if there is one; its name may be empty. Throws InputError if it can't be read.
  SavedMeasurements(TouchScene& touch, std::string file);

  /// Lets the key S save from now on: without a file, to a new measurements-001.mrk.json.
  void SaveByKey(vtkRenderWindowInteractor* interactor);

  /// Saves new measurements to the file; an emptied list does not replace a file. If measurements
  /// are not saved, because there is no file or it can't be written, reports this and returns why.
  std::string SaveAtEnd();

  /// Whether everything is saved.
  bool IsSaved() const;

private:
  /// Saves the list. Returns false, with the reason, on failure.
  bool Save(std::string& error);
  void Report(std::ostream& out) const;

  TouchScene& Touch;
  std::string File;
  vtkMTimeType Saved;   ///< the time of the list in the file
  vtkIdType InFile = 0; ///< the length of the list in the file
  std::unique_ptr<KeyBinding> Key;
};
} // namespace Explore

#endif
