// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/ModeKeys.h"

#include "VTK/Modes/HapticModes.h"

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

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

} // namespace

vtkVolumeHapticsFilter* ModeKeys::FindFilter() const
{
  vtkVolumeHapticsFilter* const filter =
    this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
  const bool hasModes = filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES &&
    filter->GetNumberOfModes() > 0;
  return hasModes ? filter : nullptr;
}

void ModeKeys::Set(vtkVolumeHapticsFilter* filter, const std::vector<bool>& active)
{
  // Keep these objects: observers of the following events may remove them.
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
      display->SetNotice("This mode can't be felt here: see the messages.");
    }
  }
  else if (display)
  {
    display->SetNotice("");
  }
}

bool ModeKeys::Next()
{
  vtkVolumeHapticsFilter* const filter = this->FindFilter();
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
  vtkVolumeHapticsFilter* const filter = this->FindFilter();
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

} // namespace VolumeHaptics
