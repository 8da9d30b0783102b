// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings that a setup has, section by section, for writing and for reading alike.
 */
#ifndef HapticSetupSettings_h
#define HapticSetupSettings_h

#include "VTK/Base/HapticSetupNode.h"

class vtkCamera;
class vtkMatrix4x4;
class vtkVolumeHapticsFilter;
class vtkVolumeProperty;

namespace VolumeHaptics
{

/** The section Haptics; the volume property is the one that visibility can come from, or null. */
void PassHaptics(SetupNode node, vtkVolumeHapticsFilter* filter, vtkVolumeProperty* visible);
void PassVolume(SetupNode node, vtkVolumeProperty* property);
void PassCamera(SetupNode node, vtkCamera* camera);
/** The entry DeviceToWorld of the root. */
void PassDeviceToWorld(SetupNode& root, vtkMatrix4x4* matrix);

} // namespace VolumeHaptics

#endif
