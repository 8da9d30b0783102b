// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Common/BuiltInKinds.h"
#include "Devices/Transport/Hid/NumberedHidKind.h"
#include "Devices/WoodenHaptics/WoodenDriver.h"

namespace VolumeHaptics
{

DeviceKind GetWoodenKind()
{
  return MakeNumberedKind<WoodenDriver>("wooden", &WoodenDriver::IsWooden);
}

} // namespace VolumeHaptics
