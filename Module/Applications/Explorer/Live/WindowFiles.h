// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WindowFiles_h
#define Explore_WindowFiles_h

#include "Applications/Explorer/Live/FileDialog.h"
#include "Applications/Explorer/Live/TouchScene.h"
#include "Applications/Explorer/View/ListOverlay.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// Lets the user choose the next volume. Ctrl+O opens the desktop's file dialog, and F2 lists files
/// and folders in the window. Recent files are in the menu. F3 lists the other series of the same
/// DICOM folder, or the other volumes or segments of the same file. F4 sets whether the volume is a
/// label map. A file can also be dropped on the window. The window then closes, and the program
/// opens the chosen file.
class WindowFiles
{
public:
  /// `now` is the file that the window shows, and `choice` receives the chosen one.
  WindowFiles(TouchScene& touch, vtkRenderWindowInteractor* interactor, const Volume& volume,
    const FileChoice& now, FileChoice& choice);
  ~WindowFiles();
  WindowFiles(const WindowFiles&) = delete;
  WindowFiles& operator=(const WindowFiles&) = delete;

private:
  void Handle(unsigned long event, void* data);
  void AddCommands();
  bool PressKey(const std::string& key);
  /// Lists a folder. The arguments are copies, because callers pass members that the function
  /// changes.
  void ListFolder(std::string folder, std::string marked);
  void ListSeries();
  void OpenDialog();
  void PollDialog();
  /// Ends the touch, because a user who reads a list or waits for a file does not watch the hand.
  void EndTouch();
  void ShowList(const std::string& title, const std::vector<std::string>& lines, int marked);
  void Accept(int line);
  void Choose(const FileChoice& choice);

  TouchScene& Touch;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  const FileChoice Now;
  FileChoice& Chosen;
  /// names of the series, with their numbers; a choice needs at least two
  const std::vector<std::string> Series;
  const bool MayBeLabels;
  ListOverlay List;
  FileDialog Dialog;
  std::string Folder;             ///< listed folder; empty while series are listed
  std::vector<std::string> Paths; ///< paths of the lines in the list
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif
