// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WindowRecorder_h
#define Explore_WindowRecorder_h

#include "Applications/Explorer/Live/TouchScene.h"
#include "Applications/Explorer/Record/MovieFile.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace Explore
{
/// Records the window and the touch to files, controlled by keys: F12 writes a picture, F9 begins
/// and ends a movie, F10 begins and ends a recording of the touch. Files are numbered:
/// picture-001.png, movie-001.ogv, touch-001.vtp in the current folder.
///
/// The pictures of a movie are read from the window after it was drawn, at most RATE times a
/// second, and written by another thread. If this thread is too slow, pictures are dropped, and the
/// remaining ones are shown longer. The head-up display shows what is being recorded.
class WindowRecorder
{
public:
  /// Begins a movie, if `movie` is not empty. Throws InputError if it can't be written.
  WindowRecorder(
    TouchScene& touch, vtkRenderWindowInteractor* interactor, const std::string& movie);
  /// Waits until all movies are written.
  ~WindowRecorder();
  WindowRecorder(const WindowRecorder&) = delete;
  WindowRecorder& operator=(const WindowRecorder&) = delete;

private:
  void AddCommands();
  void BeginOrEndMovie();
  void TakePicture();
  bool BeginMovie(const std::string& file, std::string& error);
  void EndMovie();
  /// Reports movies that have been written to the end. If `waits`, first waits for all of them.
  void ReportEnded(bool waits);
  /// Adds a picture of the window to the movie if the next one is due.
  void Film();
  void BeginOrEndTouch();
  /// Begins or ends the recording of the second hand, as touch-001-second.vtp next to the first
  /// hand's file. Returns an error; empty on success, or if there is no recording to end.
  std::string RecordSecond(bool begins, const std::string& file);
  /// Shows in the display which recordings are in progress.
  void Report();

  TouchScene& Touch;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  std::unique_ptr<MovieFile> Movie;
  struct EndedMovie
  {
    std::unique_ptr<MovieFile> Movie;
    std::string Name;
  };
  std::vector<EndedMovie> Ended; ///< movies whose threads may still write
  std::string MovieName;
  std::string TouchName;                       ///< name of the current touch recording
  bool RecordsSecond = false;                  ///< whether the second hand is also recorded
  std::chrono::steady_clock::time_point Begin; ///< when the movie began
  int Filmed = 0;                              ///< number of pictures in the movie so far
  int Size[2] = { 0, 0 };
  vtkNew<vtkCallbackCommand> TimerObserver;
};
} // namespace Explore

#endif
