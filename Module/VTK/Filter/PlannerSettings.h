// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes how far a filter reads around the tip, for a planner of regions.
 */
#ifndef PlannerSettings_h
#define PlannerSettings_h

#include "vtkVolumeHapticsModule.h" // for export macro

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class RegionPlanner;

/**
 * Sets the lengths and the world's unit of a planner, whose whole volume is set, by the settings
 * and the property of a filter. SpringLength is the largest (T_N sqrt(1 + mu^2) + R) / k of the
 * functions' points, at most 0.05 m; with SameShape, k is the CouplingStiffness. The methods of
 * surfaces hold without limit, so with them it is 0.05 m.
 */
VTKVOLUMEHAPTICS_EXPORT void ConfigurePlanner(
  RegionPlanner& planner, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
