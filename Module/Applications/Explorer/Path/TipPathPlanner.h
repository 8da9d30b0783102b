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
/// A movement of the hand, from tick First to the tick before Last.
struct Phase
{
  std::string Name;
  vtkIdType First;
  vtkIdType Last;
};

/// Path of the tip through the volume, with one point for each tick (world).
struct TipPath
{
  vtkSmartPointer<vtkPolyData> Path;
  std::vector<Phase> Phases;
};

/// Plans a smooth path with a speed of at most 0.1 m/s: approach from outside, press on the outer
/// surface, drag along it, press through to the deep surface, drag back over it, and leave.
TipPath PlanTipPath(
  const SurfaceMap& map, const ViewFrame& view, double metersPerWorldUnit, double ticksPerSecond);
} // namespace Explore

#endif
