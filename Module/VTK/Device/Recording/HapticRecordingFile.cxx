// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Recording/HapticRecordingFile.h"

#include "VTK/Base/FileReplacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Device/Recording/JournalReader.h"
#include "VTK/Device/Recording/RecordingPolyData.h"
#include "VTK/Device/Recording/RecordingTable.h"
#include "VTK/Trace/HapticTraceFiles.h"

#include <sys/stat.h>

namespace VolumeHaptics
{

const char* const RecordingUnits = "points and Tip: world; DeviceTip: m; Time: s; forces, Command, "
                                   "Viscosity and SurfaceStrength: N; Torque: N m; "
                                   "Stiffness: N/m; Value, SurfaceValue and MediumValue: scalar; "
                                   "GradientMagnitude: scalar per world";

namespace
{

bool IsThere(const std::string& file)
{
  struct stat status;
  return stat(file.c_str(), &status) == 0;
}

/** Writes the file. False, with the reason and the cure, on failure. */
bool WriteFile(
  JournalReader& reader, const std::string& journal, const std::string& file, std::string& error)
{
  const bool isTable = GetTraceEnding(file) == ".csv";
  bool isRead = true;
  bool isWritten = false;
  FileReplacement main;
  FileReplacement fields;
  if (main.Open(file, error) && (!isTable || fields.Open(file + ".json", error)))
  {
    isRead = isTable ? WriteRecordingTable(reader, main) && WriteRecordingFields(reader, fields)
                     : WriteRecordingPolyData(reader, main);
    // Both files are completely on the disk before one of them gets its name.
    isWritten = isRead && main.Finish(error) && (!isTable || fields.Finish(error)) &&
      main.Commit(error) && (!isTable || fields.Commit(error));
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
  return isWritten;
}

} // namespace

bool WriteRecording(JournalReader& reader, const std::string& journal, const std::string& file,
  const std::string& trouble, std::string& error)
{
  const std::string name = Printable(journal);
  const std::string& damage = reader.GetDamage();
  const std::string problem = trouble + (trouble.empty() || damage.empty() ? "" : " ") +
    (damage.empty() ? "" : "The unfinished recording " + name + " " + damage + ".");
  error.clear();
  bool isWritten = false;
  if (!problem.empty() && IsThere(file))
  {
    error = problem + " The file that is there stays as it is.";
  }
  else
  {
    isWritten = WriteFile(reader, journal, file, error);
    error = !isWritten && !trouble.empty() ? trouble
      : isWritten && !problem.empty()      ? problem + " The file holds these ticks."
                                           : error;
  }
  if (isWritten && damage.empty())
  {
    reader.Remove(journal);
  }
  else
  {
    error += reader.IsAt(journal)
      ? " What was recorded is kept in " + name + ": write it with vtkHapticRecorder::Recover(\"" +
        name + "\", FILE) to a file of your choice."
      : " Another program removed or replaced " + name + ", in which it was kept.";
  }
  return error.empty();
}

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
  if (reader.IsAt(file) || (ending == ".csv" && reader.IsAt(file + ".json")))
  {
    error = "The unfinished recording " + Printable(journal) +
      " can't be written over itself: give the recording another name.";
    return false;
  }
  return WriteRecording(reader, journal, file, "", error);
}

} // namespace VolumeHaptics
