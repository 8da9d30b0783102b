// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/WindowFiles.h"

#include "Applications/Explorer/Live/FreeFile.h"

#include "VTK/Reading/GridLoader.h"

#include "vtkHapticRegionSource.h"
#include "vtkStringArray.h"

#include <vtksys/Directory.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace
{
using Files = vtksys::SystemTools;

/// File endings that can be opened in addition to grids and the formats of vtkHapticRegionSource.
const char* const FILE_ENDINGS[] = { ".vti", ".nii", ".nii.gz", ".pvd", ".dcm", ".ima" };

bool IsForTouch(const std::string& name)
{
  const std::string lower = Files::LowerCase(name);
  return lower == "dicomdir" || Explore::IsGrid(name) ||
    !vtkHapticRegionSource::GetFileFormat(name.c_str()).empty() ||
    std::any_of(std::begin(FILE_ENDINGS), std::end(FILE_ENDINGS),
      [&](const char* ending) { return Files::StringEndsWith(lower, ending); });
}

/// Lists a folder, as lines to show and their paths: the folder itself, its parent, and its
/// subfolders and volumes.
void ListFolderForTouch(
  const std::string& folder, std::vector<std::string>& lines, std::vector<std::string>& paths)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> folders, files;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    const std::string name = directory.GetFile(i);
    if (name.empty() || name[0] == '.')
    {
      continue;
    }
    const bool isFolder = Files::FileIsDirectory(folder + "/" + name);
    if (isFolder || IsForTouch(name))
    {
      (isFolder ? folders : files).push_back(name);
    }
  }
  std::sort(folders.begin(), folders.end());
  std::sort(files.begin(), files.end());
  lines = { "this folder, as DICOM or as a moving volume", "../" };
  paths = { folder, Files::GetParentDirectory(folder) };
  for (const std::string& name : folders)
  {
    lines.push_back(name + "/");
    paths.push_back(folder + "/" + name);
  }
  for (const std::string& name : files)
  {
    lines.push_back(name);
    paths.push_back(folder + "/" + name);
  }
}

std::string FindRecentList()
{
  const std::string state = Explore::FindStateFolder();
  return state.empty() ? state : state + "/volumehaptics-explore/recent.txt";
}

/// Returns the files that the user has opened, latest first. A line of the stored list contains the
/// series, whether the values are labels, and the path.
std::vector<Explore::FileChoice> ReadRecentFiles()
{
  std::vector<Explore::FileChoice> files;
  std::ifstream in(FindRecentList());
  for (std::string line; std::getline(in, line);)
  {
    std::istringstream words(line);
    Explore::FileChoice file;
    if (words >> file.Series >> file.AsLabels && std::getline(words.ignore(), file.Path))
    {
      files.push_back(file);
    }
  }
  return files;
}

void WriteRecentFiles(const std::vector<Explore::FileChoice>& files)
{
  const std::string list = FindRecentList();
  const mode_t mode = 0700; // readable only by the user, because the list is private
  if (list.empty() || !Files::MakeDirectory(Files::GetFilenamePath(list), &mode))
  {
    return;
  }
  std::ofstream out(list);
  for (const Explore::FileChoice& one : files)
  {
    out << one.Series << " " << one.AsLabels << " " << one.Path << "\n";
  }
}

constexpr unsigned long FILE_EVENTS[] = { vtkCommand::KeyPressEvent, vtkCommand::CharEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::MouseWheelForwardEvent,
  vtkCommand::MouseWheelBackwardEvent, vtkCommand::DropFilesEvent, vtkCommand::TimerEvent };
constexpr float FILES_PRIORITY = 10.0f;
} // namespace

namespace Explore
{
WindowFiles::WindowFiles(TouchScene& touch, vtkRenderWindowInteractor* interactor,
  const Volume& volume, const FileChoice& now, FileChoice& choice)
  : Touch(touch)
  , Interactor(interactor)
  , Now(now)
  , Chosen(choice)
  , Series(volume.Series)
  , MayBeLabels(volume.MayBeLabels)
  , List(touch.Scene.Overlay)
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
    { static_cast<WindowFiles*>(self)->Handle(event, data); });
  for (const unsigned long event : FILE_EVENTS)
  {
    interactor->AddObserver(event, this->Observer, FILES_PRIORITY);
  }
  this->AddCommands();
  // Close the list before each command of the bar: the command may begin a touch, and no hand may
  // move behind a list.
  this->Touch.Commands.BeforeRun = [this] { this->List.Hide(); };
}

WindowFiles::~WindowFiles()
{
  this->Touch.Commands.BeforeRun = nullptr;
  this->Touch.Commands.Remove(this);
  this->Interactor->RemoveObserver(this->Observer);
}

void WindowFiles::AddCommands()
{
  CommandTable& table = this->Touch.Commands;
  const auto browse = [this]
  {
    const std::string path = Files::CollapseFullPath(this->Now.Path);
    this->ListFolder(Files::GetFilenamePath(path), path);
  };
  table.Add(
    this, { "File", "open a file", "Ctrl+o", [this] { this->OpenDialog(); }, nullptr, nullptr });
  table.Add(this, { "File", "list this folder", "F2", browse, nullptr, nullptr });
  constexpr std::size_t most = 5; // recent files in the menu
  FileChoice shown = this->Now;
  shown.Path = Files::CollapseFullPath(shown.Path);
  std::vector<FileChoice> recent = ReadRecentFiles();
  recent.erase(std::remove_if(recent.begin(), recent.end(),
                 [&](const FileChoice& one) { return one.Path == shown.Path; }),
    recent.end());
  recent.resize(std::min(recent.size(), most));
  // List missing files, too, and report them when they are chosen: checking now could wait for a
  // network drive.
  for (const FileChoice& file : recent)
  {
    table.Add(this,
      { "File", "reopen " + Files::GetFilenameName(file.Path), "",
        [this, file] { this->Choose(file); }, nullptr, nullptr });
  }
  // A volume of several files can't be reopened by its first file, so don't store it.
  if (!this->Now.HasMoreFiles && shown.Path.find('\n') == std::string::npos)
  {
    recent.insert(recent.begin(), shown);
    WriteRecentFiles(recent);
  }
  table.Add(this,
    { "File", "another series or volume", "F3", [this] { this->ListSeries(); }, nullptr,
      [this] { return this->Series.size() > 1; } });
  table.Add(this,
    { "File", "show as labels; as values", "F4",
      [this] {
        this->Choose({ this->Now.Path, this->Now.Series, !this->Now.AsLabels });
      },
      [this] { return this->Now.AsLabels; }, [this] { return this->MayBeLabels; } });
}

void WindowFiles::Handle(unsigned long event, void* data)
{
  const int* const at = this->Interactor->GetEventPosition();
  bool isTaken = this->List.IsShown();
  switch (event)
  {
    case vtkCommand::TimerEvent:
      isTaken = false;
      this->PollDialog();
      break;
    case vtkCommand::DropFilesEvent:
      if (auto* const files = static_cast<vtkStringArray*>(data))
      {
        if (files->GetNumberOfValues() > 0)
        {
          this->Choose({ files->GetValue(0), 0, false });
        }
      }
      break;
    case vtkCommand::KeyPressEvent:
    {
      const char* const symbol = this->Interactor->GetKeySym();
      isTaken = this->PressKey(symbol ? symbol : "");
      break;
    }
    case vtkCommand::LeftButtonPressEvent:
      if (isTaken)
      {
        this->Accept(this->List.Find(at[0], at[1]));
      }
      break;
    case vtkCommand::MouseWheelForwardEvent:
    case vtkCommand::MouseWheelBackwardEvent:
      if (isTaken)
      {
        this->List.Move(event == vtkCommand::MouseWheelForwardEvent ? -1 : 1);
        this->Interactor->Render();
      }
      break;
    default:
      break;
  }
  this->Observer->SetAbortFlag(isTaken);
}

bool WindowFiles::PressKey(const std::string& key)
{
  if (!this->List.IsShown())
  {
    return false;
  }
  if (key == "Up" || key == "Down" || key == "Prior" || key == "Next")
  {
    constexpr int page = 10;
    const int step = key == "Up" || key == "Down" ? 1 : page;
    this->List.Move(key == "Up" || key == "Prior" ? -step : step);
  }
  else if (key == "Return" || key == "KP_Enter")
  {
    this->Accept(this->List.GetMarked());
  }
  else if (key == "BackSpace" && !this->Folder.empty())
  {
    this->ListFolder(Files::GetParentDirectory(this->Folder), this->Folder);
  }
  else if (key == "Escape" || key == "End" || key == "F2" || key == "F3")
  {
    this->EndTouch();
    this->List.Hide();
  }
  this->Interactor->Render();
  return true;
}

void WindowFiles::ListFolder(const std::string folder, const std::string marked)
{
  std::vector<std::string> lines;
  this->Folder = folder;
  ListFolderForTouch(folder, lines, this->Paths);
  const auto found = std::find(this->Paths.begin(), this->Paths.end(), marked);
  const bool isListed = found != this->Paths.end();
  this->ShowList(
    "Open: " + folder, lines, isListed ? static_cast<int>(found - this->Paths.begin()) : 0);
}

void WindowFiles::OpenDialog()
{
  const std::string path = Files::CollapseFullPath(this->Now.Path);
  const std::string folder = Files::GetFilenamePath(path);
  this->EndTouch(); // before anything else, because starting a program takes time
  if (this->Dialog.IsOpen())
  {
    return;
  }
  if (!this->Dialog.Open(folder))
  {
    this->ListFolder(folder, path);
  }
}

void WindowFiles::PollDialog()
{
  if (!this->Dialog.IsOpen())
  {
    return;
  }
  std::string chosen;
  const FileDialog::State state = this->Dialog.Poll(chosen);
  if (state == FileDialog::State::Chosen)
  {
    this->Choose({ chosen, 0, false });
  }
  else if (state == FileDialog::State::Failed)
  {
    const std::string path = Files::CollapseFullPath(this->Now.Path);
    this->ListFolder(Files::GetFilenamePath(path), path);
  }
}

void WindowFiles::ListSeries()
{
  this->Folder.clear();
  this->ShowList("Choose from " + Files::GetFilenameName(this->Now.Path), this->Series,
    this->Now.Series - std::stoi(this->Series.front()));
}

void WindowFiles::ShowList(
  const std::string& title, const std::vector<std::string>& lines, int marked)
{
  this->EndTouch();
  this->List.Show(title, lines, marked);
  this->Interactor->Render();
}

void WindowFiles::EndTouch()
{
  this->Touch.Style->SetTouchMode(false);
  this->Touch.Device->Disarm();
  if (this->Touch.SecondDevice)
  {
    this->Touch.SecondDevice->Disarm();
  }
}

void WindowFiles::Accept(int line)
{
  if (line < 0)
  {
    return;
  }
  if (this->Folder.empty())
  {
    this->Choose({ this->Now.Path, line + std::stoi(this->Series.front()), false });
    return;
  }
  const std::string path = this->Paths[static_cast<std::size_t>(line)];
  const bool isZarr = Files::StringEndsWith(Files::LowerCase(path), ".zarr");
  if (line > 0 && Files::FileIsDirectory(path) && !isZarr)
  {
    this->ListFolder(path, line == 1 ? this->Folder : std::string());
    return;
  }
  this->Choose({ path, 0, false });
}

void WindowFiles::Choose(const FileChoice& choice)
{
  this->EndTouch();
  this->Chosen = choice;
  this->List.Hide();
  this->Interactor->TerminateApp();
}
} // namespace Explore
