// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts the surface of a tool from triangles to points, each with the area that it stands for.
 *
 * The surface is covered with many candidates of the same area. Some of them are chosen, and the
 * most crowded ones are removed one by one until the wanted number is left (weighted sample
 * elimination; Yuksel, Computer Graphics Forum 34, 2015). Each candidate then belongs to the
 * nearest point, whose area is the sum of its candidates' areas: so the areas sum to the area of
 * the mesh. A few rounds of Lloyd's algorithm move each point to the middle of its candidates, so
 * that the points are spread evenly, however unequal the triangles are.
 *
 * The distance between points includes the angle between their normals, so that each side of a thin
 * blade has its own points. Nothing is random: a mesh always yields the same points.
 */
#ifndef ShellSampler_h
#define ShellSampler_h

#include "Core/Tools/PointShell/PointShell.h"
#include "VTK/Base/BackgroundWork.h"
#include "VTK/Tools/ToolMesh.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/**
 * Spreads `count` points over some triangles; both must be at least one. Returns no points if the
 * monitor cancels the work.
 */
std::vector<ShellPoint> SpreadShellPoints(const std::vector<ToolTriangle>& triangles,
  std::size_t count, const WorkMonitor* monitor = nullptr);

} // namespace VolumeHaptics

#endif
