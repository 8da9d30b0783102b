// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Shows the state of a device in one line.
 */
#ifndef LiveLine_h
#define LiveLine_h

#include <iosfwd>
#include <string>

class vtkHapticDevice;

/// Describes the latest state in one line: tip (mm, the device's axes), force (N), buttons, rate
/// (Hz), report period and round trip (ms), the cap on the stiffness (N/m) if there is one, and
/// whether the newtons are uncalibrated.
std::string DescribeState(vtkHapticDevice* device);

/// Writes a line again and again at the same place of a terminal. In another stream, writes each
/// changed line below the last one.
class LiveLine
{
public:
  explicit LiveLine(std::ostream& out);
  ~LiveLine();
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;

  void Show(const std::string& text);
  /// Ends the line, so that the next text begins on a new one.
  void End();

private:
  std::ostream& Out;
  const bool IsTerminal;
  std::string Shown;
};

#endif
