// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticDisplayLines.h"

#include "vtkHapticDevice.h"
#include "vtkHapticMeasurements.h"
#include "vtkHapticMode.h"
#include "vtkMath.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace VolumeHaptics
{

vtkVolumeHapticsFilter* FindModes(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  return filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES ? filter : nullptr;
}

std::vector<std::string> NameModes(vtkHapticDevice* device)
{
  std::vector<std::string> names;
  vtkVolumeHapticsFilter* const filter = FindModes(device);
  for (int i = 0; filter && i < filter->GetNumberOfModes(); ++i)
  {
    names.push_back(std::to_string(i + 1) + " " + filter->GetMode(i)->GetText());
  }
  return names;
}

std::vector<std::string> NameActiveModes(vtkHapticDevice* device)
{
  std::vector<std::string> names = NameModes(device);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const bool isActive = FindModes(device)->GetMode(static_cast<int>(i))->GetActive();
    names[i] = isActive ? names[i] : std::string();
  }
  return names;
}

std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device)
{
  std::vector<ModeLine> lines;
  for (const std::string& name : NameModes(device))
  {
    const auto mode = static_cast<int>(lines.size());
    const bool isActive = FindModes(device)->GetMode(mode)->GetActive();
    std::ostringstream text;
    text << name << ": " << std::fixed << std::setprecision(2);
    isActive ? text << vtkMath::Norm(device->GetModeForce(mode)) << " N" : text << "off";
    lines.push_back({ text.str(), isActive });
  }
  return lines;
}

std::string ListMeasurements(vtkHapticMeasurements* measurements)
{
  constexpr vtkIdType most = 8;
  const vtkIdType count = measurements->GetNumberOfMeasurements();
  const vtkIdType first = std::max<vtkIdType>(count - most, 0);
  std::string text = first > 0 ? "... " + std::to_string(first) + " more\n" : std::string();
  for (vtkIdType i = first; i < count; ++i)
  {
    text += measurements->GetText(i) + "\n";
  }
  text += measurements->GetUnfinishedText();
  return !text.empty() && text.back() == '\n' ? text.substr(0, text.size() - 1) : text;
}

std::string DescribeTime(vtkHapticDevice* device)
{
  if (!device->HasFrames())
  {
    return {};
  }
  static const char* const ends[] = { "once", "in a loop", "to and fro" };
  std::ostringstream text;
  text << "Time " << std::setprecision(4) << device->GetDataTime() << ", shown "
       << device->GetFrameTime() << ", ";
  if (device->IsPlaying())
  {
    text << "played " << ends[device->GetPlayback()];
    if (device->GetPlaybackSpeed() != 1.0)
    {
      text << ", speed " << device->GetPlaybackSpeed();
    }
  }
  else
  {
    text << "held";
  }
  // A picture that takes long delays the frames.
  text << (device->IsWaitingForData() ? ", waiting for data" : "");
  return text.str();
}

} // namespace VolumeHaptics
