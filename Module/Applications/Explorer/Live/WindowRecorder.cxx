// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/WindowRecorder.h"

#include "Applications/Explorer/Live/FreeFile.h"
#include "Applications/Explorer/Report/ReportFiles.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"

#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <thread>
#include <utility>

namespace Explore
{
WindowRecorder::WindowRecorder(
  TouchScene& touch, vtkRenderWindowInteractor* interactor, const std::string& movie)
  : Touch(touch)
  , Interactor(interactor)
{
  std::string error;
  if (!movie.empty() && !this->BeginMovie(movie, error))
  {
    throw InputError("--movie " + movie, error, "choose a file in a folder that you may write to");
  }
  this->AddCommands();
  this->TimerObserver->SetClientData(this);
  this->TimerObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<WindowRecorder*>(self)->Film(); });
  interactor->AddObserver(vtkCommand::TimerEvent, this->TimerObserver);
}

WindowRecorder::~WindowRecorder()
{
  this->Touch.Commands.Remove(this);
  this->Interactor->RemoveObserver(this->TimerObserver);
  this->EndMovie();
  if (!this->TouchName.empty())
  {
    this->BeginOrEndTouch();
  }
  this->ReportEnded(true);
}

void WindowRecorder::AddCommands()
{
  CommandTable& table = this->Touch.Commands;
  table.Add(this,
    { "Record", "a movie: start; stop", "F9", [this] { this->BeginOrEndMovie(); },
      [this] { return this->Movie != nullptr; }, [] { return MovieFile::IsAvailable(); } });
  table.Add(this,
    { "Record", "the touch: start; stop", "F10", [this] { this->BeginOrEndTouch(); },
      [this] { return !this->TouchName.empty(); }, nullptr });
  table.Add(
    this, { "Record", "a picture", "F12", [this] { this->TakePicture(); }, nullptr, nullptr });
}

void WindowRecorder::BeginOrEndMovie()
{
  if (this->Movie)
  {
    this->EndMovie();
    return;
  }
  std::string error;
  const std::string file = FindFreePath("movie", ".ogv");
  if (!this->BeginMovie(file, error))
  {
    this->Touch.Display->SetNotice((file + ": " + error).c_str());
  }
}

void WindowRecorder::TakePicture()
{
  const std::string file = FindFreePath("picture", ".png");
  try
  {
    this->Touch.Style->DrawWholeFrame();
    WritePicture(this->Touch.Scene.Window, file);
    this->Touch.Display->SetNotice(("Picture saved to " + file).c_str());
  }
  catch (const InputError& error)
  {
    this->Touch.Display->SetNotice(error.what());
  }
}

bool WindowRecorder::BeginMovie(const std::string& file, std::string& error)
{
  this->Movie = MovieFile::Open(file, error);
  this->MovieName = file;
  this->Filmed = 0;
  this->Begin = std::chrono::steady_clock::now();
  this->Report();
  return this->Movie != nullptr;
}

void WindowRecorder::EndMovie()
{
  if (this->Movie)
  {
    this->Movie->End();
    this->Ended.push_back({ std::move(this->Movie), this->MovieName });
    this->Touch.Display->SetNotice(("Finishing " + this->MovieName).c_str());
    this->Report();
  }
}

void WindowRecorder::ReportEnded(bool waits)
{
  for (auto ended = this->Ended.begin(); ended != this->Ended.end();)
  {
    while (waits && ended->Movie->GetState() == MovieFile::State::Writing)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    const MovieFile::State state = ended->Movie->GetState();
    if (state == MovieFile::State::Writing)
    {
      ++ended;
      continue;
    }
    const std::string told = state == MovieFile::State::Written ? "Movie saved to " + ended->Name
      : state == MovieFile::State::Empty
      ? ended->Name + ": no movie, because nothing was drawn"
      : ended->Name + ": the movie can't be written. Cure: check the space on the disk";
    std::cout << (state == MovieFile::State::Written ? "Written: " + ended->Name : told)
              << std::endl;
    this->Touch.Display->SetNotice(told.c_str());
    ended = this->Ended.erase(ended);
  }
}

void WindowRecorder::Film()
{
  this->ReportEnded(false);
  vtkRenderWindow* const window = this->Touch.Scene.Window;
  if (!this->Movie || window->GetNeverRendered())
  {
    return;
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - this->Begin;
  const int due = static_cast<int>(passed.count() * MovieFile::RATE) + 1 - this->Filmed;
  if (due < 1)
  {
    return;
  }
  const int* const size = window->GetSize();
  if (this->Filmed > 0 && !std::equal(size, size + 2, this->Size))
  {
    this->EndMovie(); // ends the movie, because all its pictures must have the same size
    return;
  }
  std::copy_n(size, 2, this->Size);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetNumberOfComponents(3);
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  if (pixels->GetNumberOfTuples() != picture->GetNumberOfPoints())
  {
    return;
  }
  picture->GetPointData()->SetScalars(pixels);
  if (this->Movie->Add(picture, due))
  {
    this->Filmed += due;
  }
  this->Report();
}

void WindowRecorder::BeginOrEndTouch()
{
  const bool begins = this->TouchName.empty();
  const std::string file = begins ? FindFreePath("touch", ".vtp") : this->TouchName;
  std::string told;
  {
    const MessageCapture capture;
    vtkHapticDevice* const device = this->Touch.Device;
    const bool isDone =
      begins ? device->GetRecorder()->Start(file.c_str()) : device->GetRecorder()->Stop();
    told = isDone ? "" : capture.FirstError();
    this->TouchName = begins && isDone ? file : "";
  }
  if (told.empty() || !begins) // end the second recording even if the first one could not be ended
  {
    const std::string second = this->RecordSecond(begins, file);
    told = told.empty() ? second : told;
  }
  if (!begins)
  {
    std::cout << (told.empty() ? "Written: " + file : told) << std::endl;
    told =
      told.empty() ? "Touch saved to " + file + "; --device replay:" + file + " plays it" : told;
  }
  this->Touch.Display->SetNotice(told.c_str());
  this->Report();
}

std::string WindowRecorder::RecordSecond(bool begins, const std::string& file)
{
  if (!this->Touch.SecondDevice || (!begins && !this->RecordsSecond))
  {
    return {};
  }
  const std::string second = file.substr(0, file.rfind('.')) + "-second.vtp";
  vtkHapticRecorder* const recorder = this->Touch.SecondDevice->GetRecorder();
  {
    const MessageCapture capture; // also captures the output to std::cout
    const bool isDone = begins ? recorder->Start(second.c_str()) : recorder->Stop();
    this->RecordsSecond = begins && isDone;
    if (!isDone)
    {
      return capture.FirstError();
    }
  }
  if (!begins)
  {
    std::cout << "Written: " << second << std::endl;
  }
  return {};
}

void WindowRecorder::Report()
{
  std::string text;
  if (this->Movie)
  {
    const int seconds = this->Filmed / MovieFile::RATE;
    std::ostringstream time;
    time << seconds / 60 << ":" << std::setw(2) << std::setfill('0') << seconds % 60;
    text = vtksys::SystemTools::GetFilenameName(this->MovieName) + ", " + time.str();
  }
  if (!this->TouchName.empty())
  {
    text += (text.empty() ? "" : " and ") + vtksys::SystemTools::GetFilenameName(this->TouchName);
  }
  if (text != this->Touch.Display->GetRecordingText())
  {
    this->Touch.Display->SetRecordingText(text.c_str());
  }
}
} // namespace Explore
