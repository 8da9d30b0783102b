// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/DisplayKeys.h"

#include "VTK/Filter/HapticBaker.h"
#include "VTK/Scene/Base/KeyMap.h"
#include "VTK/Scene/Base/KeyTable.h"
#include "VTK/Scene/Interaction/ToolTurn.h"
#include "VTK/Scene/Interaction/TouchMode.h"

#include "vtkVolumeHapticsFilter.h"

#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Joins two lines; either may be empty. */
std::string Join(const std::string& first, const std::string& second)
{
  return first.empty() || second.empty() ? first + second : first + "\n" + second;
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

std::string DisplayKeys::ListKeys() const
{
  const TouchedScene& scene = this->Scene;
  vtkVolumeHapticsFilter* const filter = scene.Device ? scene.Device->GetVolumeHaptics() : nullptr;
  KeyedParts parts;
  parts.HasMouse = !scene.IsReal();
  parts.TurnsView = parts.HasMouse && scene.TurnsView;
  parts.HasDevice = scene.IsReal();
  parts.HasTool = this->Turn.HasTool();
  parts.HasEditor = scene.Editor != nullptr;
  parts.HasLabels = scene.Editor && scene.Editor->GetLabelTable();
  parts.HasSlices = scene.Slices != nullptr;
  parts.HasMeasurements = scene.Measurements != nullptr;
  parts.HasModes = filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES &&
    filter->GetNumberOfModes() > 0;
  parts.HasFrames = filter && filter->GetTimeUnitsPerSecond() != 0.0 &&
    HapticBaker(filter).FindFrameTimes().size() > 1;
  return VolumeHaptics::ListKeys(parts, this->Keys) + this->ApplicationKeys;
}

std::string DisplayKeys::Tell(const char* before, const char* defaultKey, const char* after) const
{
  const std::string key = this->Keys.Name(defaultKey);
  return key.empty() ? "" : before + key + after;
}

std::string DisplayKeys::FindHint()
{
  vtkHapticDevice* const device = this->Scene.Device;
  if (!device || !device->IsRunning())
  {
    return {};
  }
  if (device->GetStatus() == vtkHapticDevice::FAULT && (this->Scene.IsReal() || this->Touch.IsOn()))
  {
    return this->Tell("Press ", "a", " to go on");
  }
  if (!this->Scene.Hidden.empty())
  {
    return "The volume is hidden,\nso that it is not felt";
  }
  const bool isTouching =
    this->Scene.IsVirtual() ? this->Touch.IsOn() : device->GetStatus() != vtkHapticDevice::READY;
  if (std::exchange(this->WasTouching, isTouching) != isTouching)
  {
    this->HasTouched = false;
  }
  this->HasTouched = this->HasTouched || (isTouching && device->GetContact() != 0);
  if (!isTouching)
  {
    const std::string begin = this->Scene.IsVirtual()
      ? this->Tell("Put the pointer on the volume and press ", "t", " to touch it")
      : this->Tell("Press ", this->Scene.TurnsView ? "a" : "t", " to feel the volume");
    // Beside another style, all other keys belong to the host until the touch mode begins.
    return Join(
      begin, this->Scene.TurnsView ? this->Tell("", "question", " shows all keys") : std::string());
  }
  if (this->HasTouched || !this->Scene.IsVirtual())
  {
    return "";
  }
  std::string end = this->Tell("", "Escape", "");
  if (!this->Scene.TurnsView)
  {
    // Leave out keys that a host keeps to itself.
    end = this->Keys.Describe({ "Escape" });
    for (std::size_t at = end.find("  "); at != std::string::npos; at = end.find("  "))
    {
      end.replace(at, 2, " or ");
    }
  }
  return Join("Move the mouse to stroke, turn the wheel to press",
    end.empty() ? std::string() : end + " lets go");
}

void DisplayKeys::UpdateHint()
{
  vtkHapticHeadUpDisplay* const display = this->Scene.Display;
  if (!display)
  {
    return;
  }
  // A hint that the application has set stays until there is a new hint to show.
  const std::string hint = this->FindHint();
  if (hint != this->Shown)
  {
    this->Shown = hint;
    display->SetHint(hint.c_str());
  }
}

} // namespace VolumeHaptics
