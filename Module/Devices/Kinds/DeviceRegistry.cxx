// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Kinds/DeviceRegistry.h"

#include "Devices/Kinds/BuiltInKinds.h"

#include <algorithm>
#include <mutex>

namespace VolumeHaptics
{
namespace
{

std::mutex Mutex;

/** Call it under the mutex. */
std::vector<DeviceKind>& Kinds()
{
  static std::vector<DeviceKind> kinds = GetBuiltInKinds();
  return kinds;
}

std::vector<DeviceKind> CopyKinds()
{
  const std::lock_guard<std::mutex> lock(Mutex);
  return Kinds();
}

bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

} // namespace

bool AddDeviceKind(const DeviceKind& kind, std::string& error)
{
  const std::string& name = kind.Name;
  if (name.empty() || !std::all_of(name.begin(), name.end(), IsLetter))
  {
    error = "\"" + name + "\" can't be the name of a kind of devices. Use letters only.";
    return false;
  }
  if (!kind.List || !kind.Make)
  {
    error = "The kind of devices \"" + name + "\" needs a List and a Make.";
    return false;
  }
  const std::lock_guard<std::mutex> lock(Mutex);
  std::vector<DeviceKind>& kinds = Kinds();
  const auto same = [&name](const DeviceKind& other) { return other.Name == name; };
  if (name == "virtual" || name == "replay" || std::any_of(kinds.begin(), kinds.end(), same))
  {
    error = "There are devices of the kind \"" + name + "\" already. Choose another name.";
    return false;
  }
  kinds.push_back(kind);
  return true;
}

std::vector<DeviceListing> ListDevices()
{
  std::vector<DeviceListing> all;
  for (const DeviceKind& kind : CopyKinds())
  {
    std::vector<DeviceListing> some = kind.List();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<DeviceObstacle> ListMissingKinds()
{
  std::vector<DeviceObstacle> all;
  for (const DeviceKind& kind : CopyKinds())
  {
    const std::string text = kind.Missing ? kind.Missing() : std::string();
    if (!text.empty())
    {
      all.push_back({ kind.Name, text });
    }
  }
  return all;
}

std::unique_ptr<DeviceBackend> MakeDevice(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  const std::vector<DeviceKind> kinds = CopyKinds();
  std::string known = "\"virtual\", \"replay:FILE\"";
  // A kind with a single device may have its whole id as its name, beside others that begin alike.
  for (const std::string& name : { id, id.substr(0, id.find(':')) })
  {
    for (const DeviceKind& kind : kinds)
    {
      if (kind.Name == name)
      {
        return kind.Make(id, options, error);
      }
    }
  }
  for (const DeviceKind& kind : kinds)
  {
    known += ", \"" + kind.Name + "\"";
  }
  error = "There is no device \"" + id + "\": the kinds are " + known +
    ". Give an id that EnumerateDevices() lists.";
  return nullptr;
}

} // namespace VolumeHaptics
