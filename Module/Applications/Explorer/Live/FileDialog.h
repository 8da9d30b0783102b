// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_FileDialog_h
#define Explore_FileDialog_h

#include <string>

struct vtksysProcess_s;

namespace Explore
{
/// The desktop's own dialog for files: zenity or kdialog, whichever is installed. It runs as a
/// process of its own, so that the window and the servo go on meanwhile.
class FileDialog
{
public:
  FileDialog() = default;
  /// Closes an open dialog.
  ~FileDialog() { this->Close(); }
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;

  /// Opens the dialog in a folder. Returns false if the desktop has none.
  bool Open(const std::string& folder);
  bool IsOpen() const { return this->Process != nullptr; }
  /// Returns the chosen path once the user has chosen one; empty until then, and after a
  /// cancellation.
  std::string Poll();

private:
  void Close();

  vtksysProcess_s* Process = nullptr;
  std::string Output; // what the process has written
};
} // namespace Explore

#endif
