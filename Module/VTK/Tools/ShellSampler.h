// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the mesh of a tool, which must be a closed surface that faces outwards, and converts its
 * triangles to points, each of which represents an area.
 *
 * The surface is covered with many candidates of the same area. Some of them are chosen, and the
 * most crowded ones are removed one by one until the wanted number is left (weighted sample
 * elimination; Yuksel, Computer Graphics Forum 34, 2015). Each candidate then belongs to the
 * nearest point, whose area is the sum of its candidates' areas, so that all areas sum to the area
 * of the mesh. A few rounds of Lloyd's algorithm move each point to the middle of its candidates,
 * so that the points are spread evenly, however unequal the triangles are.
 *
 * The distance between points includes the angle between their normals, so that each side of a thin
 * blade has its own points. Nothing is random: a mesh always yields the same points.
 */
#ifndef ShellSampler_h
#define ShellSampler_h

#include "Core/Math/Vector3.h"
#include "Core/Realtime/BackgroundWork.h"
#include "Core/Tools/PointShell/PointShell.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

/** A triangle of a tool's surface, in the units of the mesh. */
struct ToolTriangle
{
  Vector3 Corner[3];
  Vector3 Normal;    ///< unit vector, outwards
  double Area = 0.0; ///< above 0
};

/**
 * Reads the triangles of a mesh in their order, and triangulates its polygons and strips. Merges
 * coinciding corners, as STL files require, and skips triangles without an area. Returns false,
 * with the reason and the cure in `error`, if the mesh is null or inside out, or if it has no
 * polygons, points that are not finite, open edges, neighbours that face opposite sides, or no
 * area.
 */
bool ReadToolMesh(vtkPolyData* mesh, std::vector<ToolTriangle>& triangles, std::string& error);

/**
 * Spreads `count` points over triangles; both must be at least one. Returns no points if the
 * monitor cancels the work.
 */
std::vector<ShellPoint> SpreadShellPoints(const std::vector<ToolTriangle>& triangles,
  std::size_t count, const WorkMonitor* monitor = nullptr);

} // namespace VolumeHaptics

#endif
