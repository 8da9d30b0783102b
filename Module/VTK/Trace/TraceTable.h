// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The text of a trace's .csv: a line of titles, then a line a tick.
 */
#ifndef TraceTable_h
#define TraceTable_h

#include <sstream>
#include <string>

namespace VolumeHaptics
{

/**
 * Numbers have as many digits as bring them back to the bit, which vtkDelimitedTextWriter does not
 * write, and no commas, whatever the application's locale.
 */
class TraceTable
{
public:
  TraceTable();

  /**
   * The title of an array with its unit: "Time (s)"; of a vector "Tip x (world)" and so on, of a
   * quaternion "Orientation w" and so on.
   */
  void AddTitle(const std::string& array, int components);
  void AddNumber(double number);
  /** The line that is complete with this, and its end. */
  std::string EndLine();

private:
  std::ostringstream Line;
  const char* Separator = "";
};

} // namespace VolumeHaptics

#endif
