// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The command "volumehaptics-device calibrate": measures how many newtons a device exerts for each
 * newton requested.
 */
#ifndef Calibrate_h
#define Calibrate_h

#include "Applications/DeviceTool/ToolDevice.h"
#include "Applications/DeviceTool/ToolOptions.h"

/**
 * Calibrates a device with a weight that the user hangs on the handle (HungWeight.h), or with a
 * kitchen scale under the handle (ScalePress.h, ScaleFit.h). First confirms the signs of the
 * device's force, unless they are already confirmed. vtkHapticDevice::CalibrateForce stores the
 * factor. Returns false after an error. The force begins and ends at zero.
 */
bool Calibrate(ToolDevice& device, const ToolOptions& options, ToolStreams streams);

#endif
