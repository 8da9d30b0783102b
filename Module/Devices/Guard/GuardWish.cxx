// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Guard/GuardWish.h"

#include "Core/Platform/Files.h"

namespace VolumeHaptics
{

bool IsGuardWanted(const DeviceOptions& options)
{
  return options.UseGuard && Files::GetVariable("VOLUMEHAPTICS_GUARD") != "off";
}

std::string MakeNoGuardText(const std::string& device)
{
  return "The " + device +
    " has no watchdog, and this system has no guard for it, as Linux has: it may keep its last "
    "force if this program is killed or stopped. If you accept that, keep its power switch "
    "within reach, and call UseGuardOff(), or set the environment variable VOLUMEHAPTICS_GUARD to "
    "\"off\".";
}

} // namespace VolumeHaptics
