// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The program volumehaptics-guard: the process that communicates with devices without a watchdog.
 * See GuardedDevice.h.
 */

#include "Devices/Guard/GuardMain.h"
#if defined(VOLUME_HAPTICS_HAS_LIBUSB)
#include "Devices/Falcon/FalconDriver.h"
#endif
#if defined(VOLUME_HAPTICS_HAS_HIDAPI)
#include "Devices/Pad/DualSenseDriver.h"
#endif
#if defined(VOLUME_HAPTICS_HAS_BEAST)
#include "Devices/Vibration/VibrationKinds.h"
#endif

namespace
{

/**
 * Makes a driver for the device that the arguments describe. On failure, returns null, with the
 * reason in `error`.
 */
std::unique_ptr<VolumeHaptics::HardwareDriver> MakeDriver(
  const std::vector<std::string>& words, std::string& error)
{
#if defined(VOLUME_HAPTICS_HAS_HIDAPI)
  if (auto driver = VolumeHaptics::DualSenseDriver::MakeFromWords(words))
  {
    return driver;
  }
#endif
#if defined(VOLUME_HAPTICS_HAS_BEAST)
  if (auto driver = VolumeHaptics::MakeVibrationFromWords(words))
  {
    return driver;
  }
#endif
#if defined(VOLUME_HAPTICS_HAS_LIBUSB)
  return VolumeHaptics::FalconDriver::MakeFromWords(words, error);
#else
  error = "The guard of the device does not know this one.";
  return nullptr;
#endif
}

} // namespace

int main(int argc, char* argv[])
{
  return VolumeHaptics::RunGuard({ argv, argv + argc }, &MakeDriver);
}
