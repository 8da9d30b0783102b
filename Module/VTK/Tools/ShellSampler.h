// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of a tool: from triangles to points that stand for equal parts of it.
 *
 * The surface is covered with many candidates of the same area. Of some of them, those are left out
 * one by one that are nearest to others, until as many are left as are wanted (weighted sample
 * elimination; Yuksel, Computer Graphics Forum 34, 2015). Each candidate then belongs to the
 * nearest point, whose area is that of its candidates: so the areas sum to that of the mesh. A few
 * rounds move each point to the middle of its own (Lloyd's algorithm), so that the points are
 * spread evenly, however unequal the triangles are.
 *
 * The distance also counts how differently two places face, so that the two sides of a thin blade
 * have points of their own. Nothing is random: a mesh always gives the same points.
 */
#ifndef ShellSampler_h
#define ShellSampler_h

#include "Core/Model/PointShell.h"
#include "VTK/Base/BackgroundWork.h"
#include "VTK/Tools/ToolMesh.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/**
 * `count` points, at least one, on triangles of which there is at least one. With a monitor, none
 * if it is cancelled.
 */
std::vector<ShellPoint> SpreadShellPoints(const std::vector<ToolTriangle>& triangles,
  std::size_t count, const WorkMonitor* monitor = nullptr);

} // namespace VolumeHaptics

#endif
