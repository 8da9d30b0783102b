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

/// Describes the latest state in one line: tip (mm, in the device's axes), force (N), buttons, rate
/// (Hz), report period and round trip (ms), the stiffness cap (N/m) if there is one, and whether
/// the forces are uncalibrated.
std::string DescribeState(vtkHapticDevice* device);

/// Rewrites one line of a terminal in place. In any other stream, appends each changed line.
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
