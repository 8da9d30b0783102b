// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticRecordingFile.h"

#include "HapticFiles.h"
#include "HapticJournal.h"
#include "HapticTraceFiles.h"

#include <unistd.h>

namespace VolumeHaptics
{

const char* const RecordingUnits = "points and Tip: world; DeviceTip: m; Time: s; forces, Command, "
                                   "Viscosity and SurfaceStrength: N; "
                                   "Stiffness: N/m; Value, SurfaceValue and MediumValue: scalar; "
                                   "GradientMagnitude: scalar per world";

bool WriteRecording(const std::string& journal, const std::string& file, std::string& error)
{
  const std::string ending = GetTraceEnding(file);
  if (ending.empty())
  {
    error =
      "The recording \"" + Printable(file) + "\" has an unknown ending: name it .vtp or .csv.";
    return false;
  }
  JournalReader reader;
  if (!reader.Open(journal, error))
  {
    error = "The unfinished recording " + Printable(journal) + " " + error + ".";
    return false;
  }
  bool isRead = true;
  bool isWritten = false;
  FileReplacement main;
  FileReplacement fields;
  if (main.Open(file, error) && (ending == ".vtp" || fields.Open(file + ".json", error)))
  {
    isRead = ending == ".vtp"
      ? WriteRecordingPolyData(reader, main)
      : WriteRecordingTable(reader, main) && WriteRecordingFields(reader, fields);
    // Neither of two files comes without the other.
    isWritten = isRead && main.Finish(error) && (ending == ".vtp" || fields.Commit(error)) &&
      main.Commit(error);
  }
  if (!isRead)
  {
    error = "The unfinished recording " + Printable(journal) +
      " can't be read to its end: check the disk that it is on.";
  }
  else if (!isWritten)
  {
    error = "The recording " + Printable(file) + " can't be written: " + error;
  }
  else
  {
    unlink(journal.c_str());
  }
  return isWritten;
}

} // namespace VolumeHaptics
