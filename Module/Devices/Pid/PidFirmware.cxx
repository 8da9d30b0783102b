// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/PidFirmware.h"

#include "Devices/Pid/PidMapper.h"

#include <algorithm>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

bool IsOpenFfboard(const HidDeviceInfo& info)
{
  return info.Vendor == 0x1209 && info.ProductId == 0xFFB0;
}

/** Arduino's two vendor numbers and SparkFun's. */
bool IsArduino(const HidDeviceInfo& info)
{
  return info.Vendor == 0x2341 || info.Vendor == 0x2A03 || info.Vendor == 0x1B4F;
}

/** Whether all reports of force feedback have the sizes of ArduinoJoystickWithFFBLibrary's. */
bool HasSizesOfLibrary(const HidReportDescriptor& descriptor)
{
  // Output reports 1 to 14; there is no report 9, and report 8 lacks the second axis.
  constexpr std::size_t outputs[] = { 17, 13, 14, 11, 3, 5, 15, 1, 0, 3, 1, 1, 1, 4 };
  // Feature reports 5 to 7.
  constexpr std::size_t features[] = { 3, 4, 4 };
  bool isSame = true;
  for (std::size_t i = 0; i < std::size(outputs); ++i)
  {
    const auto id = static_cast<std::uint8_t>(1 + i);
    isSame = isSame && descriptor.GetReportSize(HidReportKind::Output, id) == outputs[i];
  }
  for (std::size_t i = 0; i < std::size(features); ++i)
  {
    const auto id = static_cast<std::uint8_t>(5 + i);
    isSame = isSame && descriptor.GetReportSize(HidReportKind::Feature, id) == features[i];
  }
  return isSame;
}

/** Whether the second axis can be enabled. */
bool HasSecondAxis(const HidReportDescriptor& descriptor)
{
  constexpr HidUsage y = MakeHidUsage(0x01, 0x31);
  const std::vector<HidField>& fields = descriptor.GetFields();
  return std::any_of(fields.begin(), fields.end(),
    [&descriptor, y](const HidField& field)
    {
      return field.Kind == HidReportKind::Output && field.Usage == y &&
        descriptor.IsWithin(field, PidMapper::Of(PidUsage::AxesEnable));
    });
}

} // namespace

PidFirmware FindPidFirmware(const HidDeviceInfo& info, const HidReportDescriptor& descriptor)
{
  PidFirmware firmware;
  if (IsOpenFfboard(info))
  {
    const std::string name = "FFBoard ";
    firmware.IsKnown =
      info.Product.size() > name.size() && info.Product.compare(0, name.size(), name) == 0;
    firmware.HasShares = !HasSecondAxis(descriptor);
    if (firmware.HasShares && !firmware.IsKnown)
    {
      firmware.Objection = "older versions of its firmware disagree on the direction of the force, "
                           "which could push the hand away. Update its firmware to 1.16.5 or later";
    }
  }
  else if (IsArduino(info) && HasSizesOfLibrary(descriptor))
  {
    firmware.IsKnown = true;
    firmware.Sign = -1.0;
  }
  return firmware;
}

} // namespace VolumeHaptics
