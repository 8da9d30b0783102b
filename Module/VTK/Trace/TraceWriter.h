// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes a trace in memory to a file, all of it or nothing. A recording may be too large for
 * memory, so it is written from its journal (HapticRecordingFile.h), to files in the same format.
 */
#ifndef TraceWriter_h
#define TraceWriter_h

#include <sstream>
#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * Makes the text of a trace's .csv: a line of titles, then one line per tick. Numbers have enough
 * digits to be restored exactly, unlike those of vtkDelimitedTextWriter, and a decimal point in any
 * locale.
 */
class TraceTable
{
public:
  TraceTable();

  /**
   * Adds the titles of an array's columns, with the unit: "Time (s)"; for a vector, "Tip x (world)"
   * and so on; for a quaternion, "Orientation w" and so on.
   */
  void AddTitle(const std::string& array, int components);
  void AddNumber(double number);
  /** Ends the current line and returns its text. */
  std::string EndLine();

private:
  std::ostringstream Line;
  const char* Separator = "";
};

///@{
/**
 * Write a .vtp with everything, or a .csv with one line per tick. On failure, return false, with
 * the reason and the cure in `error`.
 */
bool WriteTracePolyData(vtkPolyData* trace, const std::string& file, std::string& error);
bool WriteTraceTable(vtkPolyData* trace, const std::string& file, std::string& error);
///@}

} // namespace VolumeHaptics

#endif
