// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_FileDialog_h
#define Explore_FileDialog_h

#include <chrono>
#include <string>

namespace Explore
{
/// The desktop's own file dialog: zenity or kdialog, whichever is installed. The dialog runs in a
/// separate process, so that the window and the servo continue. Not available on Windows, which has
/// neither program.
class FileDialog
{
public:
  enum class State
  {
    Open,
    Chosen,
    Cancelled,
    Failed
  };

  FileDialog() = default;
  /// Kills the dialog's program if it is still running.
  ~FileDialog() { this->Close(); }
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;

  /// Opens the dialog in a folder. Returns false if the desktop has no such dialog.
  bool Open(const std::string& folder);
  bool IsOpen() const { return this->Process > 0; }
  /// Polls an open dialog without waiting. Sets the path once the user has chosen a file.
  State Poll(std::string& path);

private:
  using Clock = std::chrono::steady_clock;

  void Read();
  void Close();

  int Process = -1;   // process id; -1: no dialog is open
  int Pipe = -1;      // read end of the pipe from the dialog's program
  std::string Output; // output of the dialog's program
  Clock::time_point Begin;
  Clock::time_point Seen; // last time at which the program was running
};
} // namespace Explore

#endif
