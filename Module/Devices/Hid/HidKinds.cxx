// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BuiltInKinds.h"
#include "DeviceRegistry.h"
#include "PidDriver.h"
#include "SpaceMouseDriver.h"
#include "WoodenDriver.h"

#include <cmath>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{

/** Those of a kind whose ids count them. */
std::vector<DeviceListing> ListNumbered(const char* kind, bool (*isSome)(const HidPlace&))
{
  std::vector<DeviceListing> all;
  for (const HidPlace& place : FindHidDevices())
  {
    if (isSome(place))
    {
      all.push_back(
        { kind + (":" + std::to_string(all.size())), place.GetLabel(), place.GetState() });
    }
  }
  return all;
}

template <typename Driver>
DeviceKind MakeNumberedKind(const char* kind, bool (*isSome)(const HidPlace&))
{
  return { kind, [kind, isSome] { return ListNumbered(kind, isSome); },
    [kind](const std::string& id, const DeviceOptions&,
      std::string& error) -> std::unique_ptr<DeviceBackend>
    {
      const int number = ReadDeviceNumber(id, kind, error);
      return number < 0 ? nullptr
                        : std::make_unique<HardwareDevice>(std::make_unique<Driver>(number));
    } };
}

std::vector<DeviceListing> ListPid()
{
  std::vector<DeviceListing> all;
  for (const HidPlace& place : FindHidDevices())
  {
    if (PidDriver::IsPid(place))
    {
      char id[16];
      std::snprintf(id, sizeof(id), "pid:%04x:%04x", place.Vendor, place.ProductId);
      const std::string objection = PidDriver::FindObjection(place);
      all.push_back(
        { id, place.GetLabel(), objection.empty() ? place.GetState() : "refused: " + objection });
    }
  }
  return all;
}

std::unique_ptr<DeviceBackend> MakePid(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  PidDriver::Numbers numbers;
  if (!PidDriver::ReadNumbers(id, numbers))
  {
    error = "\"" + id +
      "\" is no device id: give \"pid\", or \"pid:VVVV:PPPP\" with the device's vendor and product "
      "in four hexadecimal digits each.";
    return nullptr;
  }
  for (const double newtons : options.NewtonsPerFullScale)
  {
    if (!std::isfinite(newtons))
    {
      error = "NewtonsPerFullScale has to be finite: the force in N at the stick's full scale.";
      return nullptr;
    }
  }
  return std::make_unique<HardwareDevice>(
    std::make_unique<PidDriver>(numbers, options.NewtonsPerFullScale));
}

} // namespace

DeviceKind GetWoodenKind()
{
  return MakeNumberedKind<WoodenDriver>("wooden", &WoodenDriver::IsWooden);
}

DeviceKind GetPidKind()
{
  return { "pid", &ListPid, &MakePid };
}

DeviceKind GetSpaceMouseKind()
{
  return MakeNumberedKind<SpaceMouseDriver>("spacemouse", &SpaceMouseDriver::IsSpaceMouse);
}

} // namespace VolumeHaptics
