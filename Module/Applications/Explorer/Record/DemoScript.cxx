// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Record/DemoScript.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/WholeFile.h"

#include "vtkRenderWindow.h"

#include <vtksys/FStream.hxx>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <utility>

namespace Explore
{
namespace
{
constexpr double LONGEST = 36000.0; // s
constexpr int MOST_STEPS = 1000;

/// Reads the next number of a line. Returns false if there is none, or if it is out of range.
bool ReadNumber(std::istringstream& line, double least, double most, double& number)
{
  return static_cast<bool>(line >> number) && number >= least && number <= most;
}

/// Parses an event after its time. Returns the fault and the cure; empty on success.
std::string ReadEvent(std::istringstream& line, DemoEvent& event)
{
  std::string word;
  line >> word;
  if (word == "move" || word == "stroke")
  {
    event.What = DemoEvent::Kind::Move;
    if (!ReadNumber(line, 0.0, 1.0, event.Place[0]) ||
      !ReadNumber(line, 0.0, 1.0, event.Place[1]) ||
      (word == "stroke" && !ReadNumber(line, 0.0, LONGEST, event.Duration)))
    {
      return word + " takes two fractions of the window, 0 to 1" +
        (word == "stroke" ? ", and a duration in seconds: stroke 0.7 0.5 1.5" : ": move 0.5 0.55");
    }
    return {};
  }
  if (word == "wheel")
  {
    double steps = 0.0;
    event.What = DemoEvent::Kind::Wheel;
    if (!ReadNumber(line, -MOST_STEPS, MOST_STEPS, steps) || steps != std::floor(steps))
    {
      return "wheel takes a whole number of steps: wheel 3";
    }
    event.Steps = static_cast<int>(steps);
    return {};
  }
  if (word == "key")
  {
    event.What = DemoEvent::Kind::Key;
    return line >> event.Name ? "" : "key takes the name of a key: key t";
  }
  if (word == "press" || word == "release")
  {
    event.What = word == "press" ? DemoEvent::Kind::Press : DemoEvent::Kind::Release;
    line >> event.Name;
    return event.Name == "left" || event.Name == "right" ? "" : word + " takes left or right";
  }
  return "'" + word + "' is not an event. Use move, stroke, wheel, key, press or release";
}
} // namespace

std::vector<DemoEvent> ReadDemoScript(const std::string& file)
{
  const std::string device = DetectDevice(file);
  vtksys::ifstream stream;
  if (device.empty())
  {
    stream.open(file.c_str());
  }
  if (!stream.is_open())
  {
    throw InputError(
      "--script " + file, device.empty() ? "can't be read" : device, "check its path");
  }
  std::vector<DemoEvent> events;
  std::string text;
  for (int number = 1; std::getline(stream, text); ++number)
  {
    std::istringstream line(text.substr(0, text.find('#')));
    line.imbue(std::locale::classic());
    std::string first;
    if (!(line >> first))
    {
      continue;
    }
    const std::string where = "--script " + file + ", line " + std::to_string(number);
    DemoEvent event;
    std::istringstream time(first);
    time.imbue(std::locale::classic());
    const double before = events.empty() ? 0.0 : events.back().Time;
    if (!ReadNumber(time, before, LONGEST, event.Time) || !time.eof())
    {
      throw InputError(where, "'" + first + "' is not a time after that of the previous line",
        "begin each line with a time in seconds, in increasing order");
    }
    const std::string fault = ReadEvent(line, event);
    if (!fault.empty())
    {
      const std::size_t stop = fault.find(". ");
      const bool hasCure = stop != std::string::npos;
      throw InputError(where, hasCure ? fault.substr(0, stop) : "it has no valid event",
        hasCure ? fault.substr(stop + 2) : fault);
    }
    std::string more;
    if (line >> more)
    {
      throw InputError(where, "'" + more + "' is one word too many", "write one event a line");
    }
    events.push_back(event);
  }
  return events;
}

DemoScript::DemoScript(std::vector<DemoEvent> events, vtkRenderWindowInteractor* interactor)
  : Events(std::move(events))
  , Interactor(interactor)
{
  this->TimerObserver->SetClientData(this);
  this->TimerObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<DemoScript*>(self)->Play(); });
  interactor->AddObserver(vtkCommand::TimerEvent, this->TimerObserver);
}

DemoScript::~DemoScript()
{
  this->Interactor->RemoveObserver(this->TimerObserver);
}

void DemoScript::Play()
{
  const auto now = std::chrono::steady_clock::now();
  if (!std::exchange(this->HasBegun, true))
  {
    this->Begin = now;
  }
  const double time = std::chrono::duration<double>(now - this->Begin).count();
  if (this->Stroke)
  {
    const DemoEvent& stroke = *this->Stroke;
    const double share =
      stroke.Duration > 0.0 ? std::min((time - stroke.Time) / stroke.Duration, 1.0) : 1.0;
    this->MoveTo(this->From[0] + share * (stroke.Place[0] - this->From[0]),
      this->From[1] + share * (stroke.Place[1] - this->From[1]));
    if (share < 1.0)
    {
      return; // events after a stroke wait until it has ended
    }
    this->Stroke = nullptr;
  }
  while (!this->Stroke && this->Next < this->Events.size() && this->Events[this->Next].Time <= time)
  {
    this->Do(this->Events[this->Next++]);
  }
}

void DemoScript::Do(const DemoEvent& event)
{
  this->Point();
  const bool isLeft = event.Name == "left";
  switch (event.What)
  {
    case DemoEvent::Kind::Move:
      if (event.Duration > 0.0)
      {
        std::copy_n(this->At, 2, this->From);
        this->Stroke = &event;
        break;
      }
      this->MoveTo(event.Place[0], event.Place[1]);
      break;
    case DemoEvent::Kind::Wheel:
      for (int i = 0; i < std::abs(event.Steps); ++i)
      {
        this->Interactor->InvokeEvent(event.Steps > 0 ? vtkCommand::MouseWheelForwardEvent
                                                      : vtkCommand::MouseWheelBackwardEvent);
      }
      break;
    case DemoEvent::Kind::Key:
      this->Press(event.Name);
      break;
    case DemoEvent::Kind::Press:
      this->Interactor->InvokeEvent(
        isLeft ? vtkCommand::LeftButtonPressEvent : vtkCommand::RightButtonPressEvent);
      break;
    default:
      this->Interactor->InvokeEvent(
        isLeft ? vtkCommand::LeftButtonReleaseEvent : vtkCommand::RightButtonReleaseEvent);
  }
}

void DemoScript::MoveTo(double x, double y)
{
  // Move the mouse in small steps like a hand, even if the timer fires rarely.
  constexpr double step = 2.0; // pixels
  const int* const size = this->Interactor->GetRenderWindow()->GetSize();
  const double way = std::hypot((x - this->At[0]) * size[0], (y - this->At[1]) * size[1]);
  const int steps = this->Stroke ? std::max(1, static_cast<int>(std::ceil(way / step))) : 1;
  const double from[2] = { this->At[0], this->At[1] };
  this->Point();
  for (int i = 1; i <= steps; ++i)
  {
    this->At[0] = from[0] + (x - from[0]) * i / steps;
    this->At[1] = from[1] + (y - from[1]) * i / steps;
    this->Point();
    this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }
}

void DemoScript::Point()
{
  // Set the position again, because the real mouse may have reported its own position.
  const int* const size = this->Interactor->GetRenderWindow()->GetSize();
  this->Interactor->SetEventInformation(static_cast<int>(std::lround(this->At[0] * (size[0] - 1))),
    static_cast<int>(std::lround(this->At[1] * (size[1] - 1))));
}

void DemoScript::Press(const std::string& key)
{
  const std::string control = "Ctrl+";
  const bool hasControl = key.rfind(control, 0) == 0;
  const std::string name = hasControl ? key.substr(control.size()) : key;
  const char code = name.size() == 1 && !hasControl ? name[0] : '\0';
  this->Interactor->SetKeyEventInformation(hasControl ? 1 : 0, 0, code, 0, name.c_str());
  for (const unsigned long event :
    { vtkCommand::KeyPressEvent, vtkCommand::CharEvent, vtkCommand::KeyReleaseEvent })
  {
    this->Interactor->InvokeEvent(event);
  }
  this->Interactor->SetControlKey(0);
}
} // namespace Explore
