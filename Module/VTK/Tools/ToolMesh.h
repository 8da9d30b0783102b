// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and checks the mesh of a tool: it must be a closed surface that faces outwards.
 */
#ifndef ToolMesh_h
#define ToolMesh_h

#include "Core/Math/Vector3.h"

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
  double Area = 0.0; ///< more than 0
};

/**
 * Reads the triangles of a mesh in their order, and triangulates its polygons and strips. Merges
 * coinciding corners, which STL files need, and leaves out triangles without an area. Returns
 * false, with the reason and the cure in `error`, if the mesh is null or has no polygons, points
 * that are not finite, open edges, neighbours that face opposite sides or no area, or if it is
 * inside out.
 */
bool ReadToolMesh(vtkPolyData* mesh, std::vector<ToolTriangle>& triangles, std::string& error);

} // namespace VolumeHaptics

#endif
