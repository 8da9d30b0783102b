// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes the text of a trace's .csv: a line of titles, then a line for each tick.
 */
#ifndef TraceTable_h
#define TraceTable_h

#include <sstream>
#include <string>

namespace VolumeHaptics
{

/**
 * Writes lines of a table. Numbers have enough digits to be restored exactly, which
 * vtkDelimitedTextWriter does not ensure, and no commas as decimal points, whatever the
 * application's locale.
 */
class TraceTable
{
public:
  TraceTable();

  /**
   * Adds the title of an array with its unit: "Time (s)"; for a vector "Tip x (world)" and so on,
   * for a quaternion "Orientation w" and so on.
   */
  void AddTitle(const std::string& array, int components);
  void AddNumber(double number);
  /** Ends the line that this call completes, and returns it. */
  std::string EndLine();

private:
  std::ostringstream Line;
  const char* Separator = "";
};

} // namespace VolumeHaptics

#endif
