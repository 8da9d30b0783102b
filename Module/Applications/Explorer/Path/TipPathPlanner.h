// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TipPathPlanner_h
#define Explore_TipPathPlanner_h

#include "Applications/Explorer/Path/SurfaceMap.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// One action of the hand, from tick First up to but not including tick Last.
struct Phase
{
  std::string Name;
  vtkIdType First;
  vtkIdType Last;
};

/// The tip's path through the volume: one point for each tick, in world units.
struct TipPath
{
  vtkSmartPointer<vtkPolyData> Path;
  std::vector<Phase> Phases;
};

/// Approaches from outside, presses on the outer surface, drags along it, presses through to the
/// deep surface, drags back over it, and leaves; smooth, with a speed of at most 0.1 m/s.
TipPath PlanTipPath(
  const SurfaceMap& map, const ViewFrame& view, double metersPerWorldUnit, double ticksPerSecond);
} // namespace Explore

#endif
