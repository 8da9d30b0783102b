// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DemoScript_h
#define Explore_DemoScript_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <chrono>
#include <string>
#include <vector>

namespace Explore
{
/// An event of a demonstration script, a text file that moves the mouse and presses the keys of a
/// window. Each line has a time (s, from the beginning) and an event; # begins a comment:
///
///   0.5  move 0.5 0.55        # moves the mouse at once: fractions of the window, from its lower
///   left
///   1.0  key t                # a letter, or a name such as Escape, space, F9
///   1.5  wheel 3              # steps away from the user; negative: towards the user
///   2.0  stroke 0.7 0.5 1.5   # moves the mouse there in 1.5 s
///   4.0  press left           # or right; and release
///   9.0  key q
///
/// (The files of vtkInteractorEventRecorder can't be used, because they have no times, which the
/// servo needs.)
struct DemoEvent
{
  enum class Kind
  {
    Move,
    Key,
    Wheel,
    Press,
    Release
  };
  double Time = 0.0;
  Kind What = Kind::Move;
  double Place[2] = { 0.0, 0.0 }; ///< target of Move, as fractions of the window
  double Duration = 0.0;          ///< time that Move takes (s); 0: the mouse jumps
  int Steps = 0;                  ///< number of steps of Wheel; negative: backwards
  std::string Name;               ///< name of the key or button of Key, Press and Release
};

/// Reads a script. Throws InputError, with the line, if the file is not a script.
std::vector<DemoEvent> ReadDemoScript(const std::string& file);

/// Plays a script in a window, beginning with the first timer event.
class DemoScript
{
public:
  DemoScript(std::vector<DemoEvent> events, vtkRenderWindowInteractor* interactor);
  ~DemoScript();
  DemoScript(const DemoScript&) = delete;
  DemoScript& operator=(const DemoScript&) = delete;

private:
  void Play();
  void Do(const DemoEvent& event);
  void MoveTo(double x, double y);
  /// Sets the interactor's mouse position.
  void Point();
  void Press(const std::string& key);

  std::vector<DemoEvent> Events;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  std::size_t Next = 0;
  bool HasBegun = false;
  std::chrono::steady_clock::time_point Begin;
  const DemoEvent* Stroke = nullptr; ///< current stroke; null: none
  double From[2] = { 0.5, 0.5 };     ///< position at the start of the stroke
  double At[2] = { 0.5, 0.5 };       ///< position of the mouse
  vtkNew<vtkCallbackCommand> TimerObserver;
};
} // namespace Explore

#endif
