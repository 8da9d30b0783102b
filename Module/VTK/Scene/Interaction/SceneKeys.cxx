// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/SceneKeys.h"

#include "VTK/Filter/HapticBaker.h"
#include "VTK/Modes/HapticModes.h"
#include "VTK/Scene/Base/KeyMap.h"
#include "VTK/Scene/Interaction/SceneFrames.h"
#include "VTK/Scene/Interaction/SceneMouse.h"
#include "VTK/Scene/Interaction/TouchMode.h"

#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Joins two lines with a line break; either may be empty. */
std::string Join(const std::string& first, const std::string& second)
{
  return first.empty() || second.empty() ? first + second : first + "\n" + second;
}

constexpr const char* ProposingNotice = "Looking for materials";
constexpr const char* NoProposalNotice = "No materials can be proposed for this volume";

std::vector<bool> FindActive(vtkVolumeHapticsFilter* filter)
{
  std::vector<bool> active;
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    active.push_back(filter->GetMode(i)->GetActive());
  }
  return active;
}

bool FitTogether(vtkVolumeHapticsFilter* filter)
{
  HapticModes modes;
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    modes.emplace_back(filter->GetMode(i));
  }
  return FitIntoATick(modes);
}

void Apply(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active)
{
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    filter->GetMode(static_cast<int>(i))->SetActive(active[i]);
  }
}

/** Largest factor by which the keys change the speed of playback. */
constexpr double MostSpeed = 64.0;

/** Returns the time step after (isNext) or before a time. The series is cyclic. */
double FindNeighbour(const std::vector<double>& times, double time, bool isNext)
{
  if (isNext)
  {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    return after == times.end() ? times.front() : *after;
  }
  const auto before = std::lower_bound(times.begin(), times.end(), time);
  return before == times.begin() ? times.back() : *(before - 1);
}

} // namespace

bool DisplayKeys::Press(const std::string& key)
{
  vtkHapticHeadUpDisplay* const display = this->Scene.Display;
  if (!display)
  {
    return false;
  }
  if (key == "h")
  {
    display->SetTextVisibility(!display->GetTextVisibility());
  }
  else if (key == "g")
  {
    display->SetPlotVisibility(!display->GetPlotVisibility());
  }
  else if (key == "d")
  {
    display->SetDetailsVisibility(!display->GetDetailsVisibility());
  }
  else if (key == "question" || key == "F1")
  {
    display->SetHelpText(this->ListKeys().c_str());
    display->SetHelpVisibility(!display->GetHelpVisibility());
  }
  else
  {
    return false;
  }
  return true;
}

void DisplayKeys::HideKeys()
{
  if (this->Scene.Display)
  {
    this->Scene.Display->HelpVisibilityOff();
  }
}

KeyedParts DisplayKeys::FindParts() const
{
  const TouchedScene& scene = this->Scene;
  vtkVolumeHapticsFilter* const filter = scene.Device ? scene.Device->GetVolumeHaptics() : nullptr;
  KeyedParts parts;
  parts.HasMouse = !scene.IsReal();
  parts.TurnsView = parts.HasMouse && scene.TurnsView;
  parts.HasDevice = scene.IsAnyReal();
  parts.HasTool = this->Turn.HasTool();
  parts.HasEditor = scene.Editor != nullptr;
  parts.HasLabels = scene.Editor && scene.Editor->GetLabelTable();
  parts.HasSlices = scene.Slices != nullptr;
  parts.HasMeasurements = scene.Measurements != nullptr;
  parts.HasEdits = parts.HasMeasurements || parts.HasEditor;
  parts.HasModes = filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES &&
    filter->GetNumberOfModes() > 0;
  parts.HasTimeSteps = filter && filter->GetTimeUnitsPerSecond() != 0.0 &&
    filter->GetBaker().GetDataTimes().size() > 1;
  return parts;
}

std::string DisplayKeys::ListKeys() const
{
  return VolumeHaptics::ListKeys(this->FindParts(), this->Keys) + this->ApplicationKeys;
}

std::string DisplayKeys::DescribeKey(
  const char* before, const char* defaultKey, const char* after) const
{
  const std::string key = this->Keys.Name(defaultKey);
  return key.empty() ? "" : before + key + after;
}

std::string DisplayKeys::ChooseHint()
{
  vtkHapticDevice* const device = this->Scene.Device;
  if (!device || !device->IsRunning())
  {
    return {};
  }
  if (device->GetStatus() == vtkHapticDevice::FAULT && (this->Scene.IsReal() || this->Touch.IsOn()))
  {
    return this->DescribeKey("Press ", "a", " to go on");
  }
  if (!this->Scene.Hidden.empty())
  {
    return "The volume is hidden\nand can't be felt";
  }
  const bool isTouching =
    this->Scene.IsVirtual() ? this->Touch.IsOn() : device->GetStatus() != vtkHapticDevice::READY;
  if (std::exchange(this->WasTouching, isTouching) != isTouching)
  {
    this->HasTouched = false;
  }
  this->HasTouched = this->HasTouched || (isTouching && device->GetState()->GetContact() != 0);
  if (!isTouching)
  {
    const std::string begin = this->Scene.IsVirtual()
      ? this->DescribeKey("Put the pointer on the volume and press ", "t", " to touch it")
      : this->DescribeKey("Press ", this->Scene.TurnsView ? "a" : "t", " to feel the volume");
    // If another style turns the view, the host gets all other keys until the touch mode begins, so
    // do not mention them.
    return Join(begin,
      this->Scene.TurnsView ? this->DescribeKey("", "question", " shows all keys") : std::string());
  }
  const bool isLost = this->Touch.IsOutOfView();
  if (!isLost && (this->HasTouched || !this->Scene.IsVirtual()))
  {
    return "";
  }
  std::string end = this->DescribeKey("", "Escape", "");
  if (!this->Scene.TurnsView)
  {
    // Name all keys that end the touch mode, because the host may intercept some of them.
    end = this->Keys.Describe({ "Escape" });
    for (std::size_t at = end.find("  "); at != std::string::npos; at = end.find("  "))
    {
      end.replace(at, 2, " or ");
    }
  }
  return Join(
    isLost ? "The hand is outside the view" : "Move the mouse to stroke, turn the wheel to press",
    end.empty() ? std::string() : end + " lets go");
}

void DisplayKeys::UpdateHint()
{
  vtkHapticHeadUpDisplay* const display = this->Scene.Display;
  if (!display)
  {
    return;
  }
  // Leave a hint that the application has set until there is a new one to show.
  const std::string hint = this->ChooseHint();
  if (hint != this->Shown)
  {
    this->Shown = hint;
    display->SetHint(hint.c_str());
  }
}

//------------------------------------------------------------------------------
bool EditorKeys::Press(const std::string& key, bool isPressed)
{
  vtkHapticFunctionEditor* const editor = this->Scene.Editor;
  if (!editor)
  {
    return false;
  }
  const int* const at = this->Scene.Style->GetInteractor()->GetEventPosition();
  if (key == "v")
  {
    editor->SetVisibility(!editor->GetVisibility());
  }
  else if (key == "u")
  {
    // Show a hidden editor docked beside the scene.
    editor->SetDocked(!editor->GetVisibility() || !editor->GetDocked());
    editor->VisibilityOn();
  }
  else if (key == "n")
  {
    editor->NextFunction();
  }
  else if (key == "Ctrl+BackSpace")
  {
    this->Report(editor->Reset(), "There are no edits to reset");
  }
  else if ((key == "Ctrl+z" || key == "Ctrl+y") &&
    (!this->Scene.Measurements || (isPressed && editor->Contains(at[0], at[1]))))
  {
    key == "Ctrl+z" ? this->Report(editor->Undo(), "There is no edit to undo")
                    : this->Report(editor->Redo(), "There is no edit to redo");
  }
  else if (key == "l")
  {
    this->ToggleLabels();
  }
  else if (key == "p")
  {
    this->Propose();
  }
  else if (key == "BackSpace")
  {
    editor->DropProposal();
    this->EndProposing("");
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void EditorKeys::Report(bool isDone, const char* notice)
{
  if (!isDone)
  {
    this->Frames.Notify(notice);
  }
}

//------------------------------------------------------------------------------
void EditorKeys::Propose()
{
  vtkHapticFunctionEditor* const editor = this->Scene.Editor;
  if (editor->GetVisibility() && editor->TakeProposal())
  {
    vtkVolumeHapticsFilter* const filter =
      this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
    if (filter && filter->GetProperty() == editor->GetProperty())
    {
      filter->SetKernelRadius(editor->GetProperty()->GetProposedKernelRadius());
    }
    return;
  }
  editor->VisibilityOn();
  if (editor->HasProposal())
  {
    return;
  }
  if (editor->BeginProposal())
  {
    this->ProposingEditor = editor;
    this->IsProposing = true;
    this->Frames.Notify(ProposingNotice);
  }
  else
  {
    this->Frames.Notify(NoProposalNotice);
  }
}

//------------------------------------------------------------------------------
void EditorKeys::PollProposal()
{
  const vtkSmartPointer<vtkHapticFunctionEditor> editor = this->Scene.Editor;
  if (!this->IsProposing)
  {
    return;
  }
  if (!editor || editor.Get() != this->ProposingEditor.GetPointer())
  {
    this->EndProposing("");
    return;
  }
  editor->Update();
  if (!editor->IsProposing())
  {
    this->EndProposing(editor->HasProposal() ? "" : NoProposalNotice);
  }
}

//------------------------------------------------------------------------------
void EditorKeys::EndProposing(const char* notice)
{
  vtkHapticHeadUpDisplay* const display = this->Scene.Display;
  if (std::exchange(this->IsProposing, false) && display &&
    (*notice || std::strcmp(display->GetNotice(), ProposingNotice) == 0))
  {
    display->SetNotice(notice);
  }
  this->ProposingEditor = nullptr;
  this->Frames.RecordEvent();
}

//------------------------------------------------------------------------------
void EditorKeys::ToggleLabels()
{
  // Keep a reference to the editor, because observers of its work may remove it.
  const vtkSmartPointer<vtkHapticFunctionEditor> editor = this->Scene.Editor;
  vtkHapticLabelTable* const table = editor->GetLabelTable();
  if (!table)
  {
    this->Frames.Notify("There are no labels to edit");
    return;
  }
  const bool isShown =
    editor->GetVisibility() && editor->GetFunction() == vtkHapticFunctionEditor::LABELS;
  editor->SetVisibility(!isShown);
  if (!isShown)
  {
    editor->SetFunctionToLabels();
    editor->Update();
    if (vtkHapticDevice* const device = this->Scene.Device;
        device && device->GetState()->GetContact() != 0)
    {
      const vtkTypeInt64 label = device->GetState()->GetLabel();
      if (label == static_cast<int>(label)) // tables contain only labels that fit into an int
      {
        editor->SelectLabel(static_cast<int>(label));
      }
    }
  }
}

vtkVolumeHapticsFilter* ModeKeys::GetFilter() const
{
  vtkVolumeHapticsFilter* const filter =
    this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
  const bool hasModes = filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES &&
    filter->GetNumberOfModes() > 0;
  return hasModes ? filter : nullptr;
}

void ModeKeys::Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active)
{
  // Keep references, because observers of the following events may remove these objects.
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkSmartPointer<vtkVolumeHapticsFilter> kept = filter;
  const vtkSmartPointer<vtkHapticHeadUpDisplay> display = this->Scene.Display;
  const std::vector<bool> before = FindActive(filter);
  Apply(filter, active);
  if (device->IsRunning() && !device->Publish())
  {
    if (kept->GetNumberOfModes() == static_cast<int>(before.size()))
    {
      Apply(kept, before);
      device->Publish();
    }
    if (display)
    {
      display->SetNotice("This mode can't be felt here. The terminal says why.");
    }
  }
  else if (display)
  {
    display->SetNotice("");
  }
}

bool ModeKeys::Next()
{
  vtkVolumeHapticsFilter* const filter = this->GetFilter();
  if (!filter)
  {
    return false;
  }
  std::vector<bool> active = FindActive(filter);
  const auto count = std::count(active.begin(), active.end(), true);
  const auto first = std::find(active.begin(), active.end(), true) - active.begin();
  auto next = static_cast<std::size_t>(count == 1 ? first + 1 : 0);
  if (next >= active.size() && !FitTogether(filter))
  {
    next = 0;
  }
  const bool isPastLast = next >= active.size();
  std::fill(active.begin(), active.end(), isPastLast);
  if (!isPastLast)
  {
    active[next] = true;
  }
  this->Set(filter, active);
  return true;
}

bool ModeKeys::Click(int x, int y)
{
  vtkVolumeHapticsFilter* const filter = this->GetFilter();
  const int mode = filter && this->Scene.Display ? this->Scene.Display->FindMode(x, y) : -1;
  if (mode < 0 || mode >= filter->GetNumberOfModes())
  {
    return false;
  }
  std::vector<bool> active = FindActive(filter);
  active[static_cast<std::size_t>(mode)] = !active[static_cast<std::size_t>(mode)];
  this->Set(filter, active);
  return true;
}

bool PlaybackKeys::Press(const std::string& key)
{
  // Keep a reference to the device, because observers of the changes may remove it.
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const bool isSpeed = key == "comma" || key == "period";
  const bool isPlace = key == "Left" || key == "Right";
  const bool isOurs = isSpeed || isPlace || key == "space" || key == "b";
  vtkVolumeHapticsFilter* const filter = isOurs && device ? device->GetVolumeHaptics() : nullptr;
  if (!filter || filter->GetTimeUnitsPerSecond() == 0.0)
  {
    return false;
  }
  const std::vector<double> times = filter->GetBaker().GetDataTimes();
  if (times.size() < 2)
  {
    return false;
  }
  if (key == "space")
  {
    device->GetPlayback()->IsPlaying() ? device->GetPlayback()->Hold()
                                       : device->GetPlayback()->Play();
  }
  else if (key == "b")
  {
    device->GetPlayback()->SetMode(
      (device->GetPlayback()->GetMode() + 1) % (vtkHapticPlayback::PING_PONG + 1));
  }
  else if (isPlace)
  {
    const bool isMoving = device->GetPlayback()->HasTimeSteps();
    device->GetPlayback()->Hold();
    const double time = isMoving ? device->GetPlayback()->GetDataTime() : times.front();
    device->GetPlayback()->SetDataTime(FindNeighbour(times, time, key == "Right"));
  }
  else
  {
    const double speed = device->GetPlayback()->GetSpeed() * (key == "period" ? 2.0 : 0.5);
    const double size = std::clamp(std::abs(speed), 1.0 / MostSpeed, MostSpeed);
    device->GetPlayback()->SetSpeed(std::copysign(size, speed));
  }
  return true;
}

} // namespace VolumeHaptics
