// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * volumehaptics-guard: the process that talks to devices without a watchdog. See GuardedDevice.h.
 */

#include "Devices/Falcon/FalconDriver.h"
#include "Devices/Guard/GuardMain.h"

int main(int argc, char* argv[])
{
  return VolumeHaptics::RunGuard(
    { argv, argv + argc }, &VolumeHaptics::FalconDriver::MakeFromWords);
}
