// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticErrorCatcher.h"

#include "vtkCommand.h"

#include <algorithm>

namespace VolumeHapticsLive
{

HapticErrorCatcher::~HapticErrorCatcher()
{
  for (const auto& [object, tag] : this->Objects)
  {
    if (object)
    {
      object->RemoveObserver(tag);
    }
  }
}

void HapticErrorCatcher::Catch(vtkObject* object)
{
  auto& objects = this->Objects;
  const auto isGone = [](const auto& entry) { return !entry.first; };
  objects.erase(std::remove_if(objects.begin(), objects.end(), isGone), objects.end());
  const auto isThis = [object](const auto& entry) { return entry.first == object; };
  if (object && std::none_of(objects.begin(), objects.end(), isThis))
  {
    const unsigned long tag =
      object->AddObserver(vtkCommand::ErrorEvent, this, &HapticErrorCatcher::Record);
    objects.emplace_back(object, tag);
  }
}

std::string HapticErrorCatcher::Drain()
{
  return std::exchange(this->Text, std::string());
}

void HapticErrorCatcher::Record(vtkObject*, unsigned long, void* data)
{
  // The text has the form "ERROR: In <file>, line <n>\n<class> (<address>): <text>\n\n".
  std::string text = data ? static_cast<const char*>(data) : "";
  const auto start = text.find("): ");
  text.erase(0, start == std::string::npos ? 0 : start + 3);
  text.erase(text.find_last_not_of(" \n") + 1);
  if (!text.empty() && this->Text.find(text) == std::string::npos)
  {
    this->Text += (this->Text.empty() ? "" : " ") + text;
  }
}

} // namespace VolumeHapticsLive
