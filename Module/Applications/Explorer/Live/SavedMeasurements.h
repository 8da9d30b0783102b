// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SavedMeasurements_h
#define Explore_SavedMeasurements_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkType.h"

#include <iosfwd>
#include <string>

namespace Explore
{
/// Saves the measurements of a window to a file, on Ctrl+S and when the window closes. A file that
/// could only be read in part is not overwritten; the list is then saved to a new file beside it.
class SavedMeasurements
{
public:
  /// Reads the file if it exists. The name may be empty. Throws InputError if the file can't be
  /// read.
  SavedMeasurements(TouchScene& touch, std::string file);

  ~SavedMeasurements();
  SavedMeasurements(const SavedMeasurements&) = delete;
  SavedMeasurements& operator=(const SavedMeasurements&) = delete;

  /// Saves new measurements to the file. An empty list never replaces a file. If measurements can't
  /// be saved, because there is no file or it can't be written, reports and returns the reason.
  std::string SaveAtEnd();

  /// Returns whether all measurements are saved.
  bool IsSaved() const;

private:
  /// Saves on the user's command. Without a file, saves to a new measurements-001.mrk.json.
  void SaveNow();
  /// Saves the list. On failure, returns false, with the reason in `error`.
  bool Save(std::string& error);
  void Report(std::ostream& out) const;

  TouchScene& Touch;
  std::string File;
  vtkMTimeType Saved;   ///< modification time of the list when it was saved
  vtkIdType InFile = 0; ///< number of measurements in the file
};
} // namespace Explore

#endif
