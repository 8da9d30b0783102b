// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines of the head-up display on modes, measurements and time.
 */
#ifndef HapticDisplayLines_h
#define HapticDisplayLines_h

#include "VTK/Scene/Display/HapticModeList.h"

#include <string>
#include <vector>

class vtkHapticDevice;
class vtkHapticMeasurements;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** The filter whose modes are felt; null for other methods. */
vtkVolumeHapticsFilter* FindModes(vtkHapticDevice* device);
/** The names of all modes, each one unique. */
std::vector<std::string> NameModes(vtkHapticDevice* device);
/** The names of active modes; the names of inactive modes are empty. */
std::vector<std::string> NameActiveModes(vtkHapticDevice* device);
/** A line for each mode, with its force. */
std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device);
/** The names and values of measurements, one a line, and what is being measured. */
std::string ListMeasurements(vtkHapticMeasurements* measurements);
/** A line on the time of a moving volume; empty for other volumes. */
std::string DescribeTime(vtkHapticDevice* device);

} // namespace VolumeHaptics

#endif
