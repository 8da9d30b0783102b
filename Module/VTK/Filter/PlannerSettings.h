// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes how far a filter reads around the tip, for a planner of regions.
 */
#ifndef PlannerSettings_h
#define PlannerSettings_h

class vtkHapticRegionPlanner;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/** See vtkVolumeHapticsFilter::ConfigurePlanner. */
void ConfigurePlanner(vtkHapticRegionPlanner* planner, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
