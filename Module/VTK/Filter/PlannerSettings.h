// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes how far around the tip a filter reads, for a planner of regions.
 */
#ifndef PlannerSettings_h
#define PlannerSettings_h

#include "vtkVolumeHapticsModule.h" // for export macro

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class RegionPlanner;

/**
 * Sets the lengths and the unit of the world in a planner, from the settings and the property of a
 * filter. The planner's whole volume must be set. SpringLength is the largest (T_N sqrt(1 + mu^2) +
 * R) / k at the points of the functions, at most 0.05 m; with SameShape, k is the
 * CouplingStiffness. For the methods that touch a surface, which holds without limit, it is 0.05 m.
 */
VTKVOLUMEHAPTICS_EXPORT void ConfigurePlanner(
  RegionPlanner& planner, vtkVolumeHapticsFilter* filter);

} // namespace VolumeHaptics

#endif
