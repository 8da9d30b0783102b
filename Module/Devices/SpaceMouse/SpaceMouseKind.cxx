// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/SpaceMouse/SpaceMouseKind.h"

#include "Devices/SpaceMouse/SpaceMouseDriver.h"
#include "Devices/Transport/Hid/NumberedHidKind.h"

namespace VolumeHaptics
{

DeviceKind GetSpaceMouseKind()
{
  return MakeNumberedKind<SpaceMouseDriver>("spacemouse", &SpaceMouseDriver::IsSpaceMouse, false);
}

} // namespace VolumeHaptics
