// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * volumehaptics-device calibrate: measures how many newtons a device gives for each newton asked
 * for.
 */
#ifndef Calibrate_h
#define Calibrate_h

#include "Applications/DeviceTool/ToolDevice.h"
#include "Applications/DeviceTool/ToolOptions.h"

/**
 * Uses a weight that the user hangs on the handle (HungWeight.h), or a kitchen scale under it
 * (ScalePress.h, ScaleFit.h). Confirms the device's signs first, if they never were.
 * vtkHapticDevice::CalibrateForce stores the factor. Returns false after an error; the first and
 * the last force are zero.
 */
bool Calibrate(ToolDevice& device, const ToolOptions& options, ToolStreams streams);

#endif
