// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/PadKind.h"

#include "Devices/Common/DeviceTexts.h"
#include "Devices/Guard/GuardWish.h"
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
#include "Devices/Guard/GuardedDevice.h"
#include "Devices/Pad/EvdevPadDriver.h"
#endif
#if defined(VOLUME_HAPTICS_HAS_HIDAPI)
#include "Devices/Pad/DualSenseDriver.h"
#endif

#include <algorithm>
#include <functional>

namespace VolumeHaptics
{
namespace
{

constexpr const char* PadIds = "vibration:pad";

/** A pad, the driver that communicates with it, and its number in this driver. */
struct ListedPad
{
  bool IsHid = false;
  int Number = 0;
  std::string Label;
  bool Vibrates = true;
  std::function<std::string()> GetState;
};

std::vector<ListedPad> ListFoundPads()
{
  std::vector<ListedPad> pads;
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
  const std::vector<EvdevPad> known = ListEvdevPads();
  pads.reserve(known.size());
  for (const EvdevPad& pad : known)
  {
    pads.push_back({ false, static_cast<int>(pads.size()), pad.GetLabel(), pad.Vibrates,
      [pad] { return pad.GetState(); } });
  }
#endif
#if defined(VOLUME_HAPTICS_HAS_HIDAPI)
  int number = 0;
  for (const HidDeviceInfo& info : ListHidDevices(&DualSenseDriver::IsDualSense))
  {
    bool isKnown = false;
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
    // Prefer the kernel's driver, because it ends the vibration when the program ends.
    isKnown = std::any_of(known.begin(), known.end(),
      [&info](const EvdevPad& pad)
      { return pad.Vibrates && pad.Vendor == info.Vendor && pad.Product == info.ProductId; });
#endif
    if (!isKnown)
    {
      pads.push_back({ true, number, info.GetLabel(), true, [info] { return info.GetState(); } });
    }
    ++number;
  }
#endif
  return pads;
}

std::vector<DeviceListing> ListPads()
{
  std::vector<DeviceListing> all;
  for (const ListedPad& pad : ListFoundPads())
  {
    all.push_back({ PadIds + (":" + std::to_string(all.size())),
      pad.Label + ": vibration, not force", pad.GetState() });
  }
  return all;
}

constexpr const char* PadCure = "Plug one in, or pair it.";

std::string WhyNoPads()
{
  return ListFoundPads().empty()
    ? std::string("no gamepad is plugged in, or the system has no driver for it. ") + PadCure
    : "";
}

std::unique_ptr<DeviceBackend> MakeListed(const ListedPad& pad,
  [[maybe_unused]] const DeviceOptions& options, [[maybe_unused]] std::string& error)
{
#if defined(VOLUME_HAPTICS_HAS_HIDAPI)
  if (pad.IsHid)
  {
    auto driver = std::make_unique<DualSenseDriver>(pad.Number);
    if (!IsGuardWanted(options))
    {
      return std::make_unique<HardwareDevice>(std::move(driver));
    }
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
    return GuardedDevice::Make(std::move(driver), DualSenseDriver::MakeWords(pad.Number), error);
#else
    error = MakeNoGuardText("DualSense");
    return nullptr;
#endif
  }
#endif
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
  return std::make_unique<HardwareDevice>(std::make_unique<EvdevPadDriver>(pad.Number));
#else
  return nullptr;
#endif
}

std::unique_ptr<DeviceBackend> MakePad(
  const std::string& id, const DeviceOptions& options, std::string& error)
{
  const int number = ReadDeviceNumber(id, PadIds, error);
  if (number < 0)
  {
    return nullptr;
  }
  const std::vector<ListedPad> pads = ListFoundPads();
  if (static_cast<std::size_t>(number) >= pads.size())
  {
    error = pads.empty()
      ? std::string("No gamepad is plugged in. ") + PadCure
      : "There is no gamepad with this number. Count from 0, as EnumerateDevices() does.";
    return nullptr;
  }
  if (id != PadIds)
  {
    return MakeListed(pads[static_cast<std::size_t>(number)], options, error);
  }
  // Without a number, choose any free pad that vibrates.
#if defined(VOLUME_HAPTICS_HAS_EVDEV)
  const bool hasEvdev = std::any_of(
    pads.begin(), pads.end(), [](const ListedPad& pad) { return !pad.IsHid && pad.Vibrates; });
  if (hasEvdev)
  {
    return std::make_unique<HardwareDevice>(std::make_unique<EvdevPadDriver>(-1));
  }
#endif
  const auto hid =
    std::find_if(pads.begin(), pads.end(), [](const ListedPad& pad) { return pad.IsHid; });
  return MakeListed(hid != pads.end() ? *hid : pads.front(), options, error);
}

} // namespace

DeviceKind GetPadKind()
{
  return { "vibration", &ListPads, &MakePad, &WhyNoPads };
}

} // namespace VolumeHaptics
