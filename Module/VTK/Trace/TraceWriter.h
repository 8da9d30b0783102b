// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes a trace that is in memory, completely or not at all. A recording may be too large for
 * memory, so it is written from its journal (HapticRecordingFile.h), to files of the same form.
 */
#ifndef TraceWriter_h
#define TraceWriter_h

#include <sstream>
#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * Writes the text of a trace's .csv: a line of titles, then a line for each tick. Numbers have
 * enough digits to be restored exactly, which vtkDelimitedTextWriter does not ensure. The decimal
 * separator is a point, whatever the application's locale.
 */
class TraceTable
{
public:
  TraceTable();

  /**
   * Adds the titles of an array's columns with their unit: "Time (s)"; for a vector "Tip x (world)"
   * and so on; for a quaternion "Orientation w" and so on.
   */
  void AddTitle(const std::string& array, int components);
  void AddNumber(double number);
  /** Ends the current line and returns it. */
  std::string EndLine();

private:
  std::ostringstream Line;
  const char* Separator = "";
};

///@{
/**
 * Write a .vtp with everything, or a .csv with a line for each tick. Return false and write the
 * reason and the cure if that fails.
 */
bool WriteTracePolyData(vtkPolyData* trace, const std::string& file, std::string& error);
bool WriteTraceTable(vtkPolyData* trace, const std::string& file, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
