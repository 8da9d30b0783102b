// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/WoodenHaptics/WoodenKind.h"

#include "Devices/Transport/Hid/NumberedHidKind.h"
#include "Devices/WoodenHaptics/WoodenDriver.h"

namespace VolumeHaptics
{

DeviceKind GetWoodenKind()
{
  return MakeNumberedKind<WoodenDriver>("wooden", &WoodenDriver::IsWooden, true);
}

} // namespace VolumeHaptics
