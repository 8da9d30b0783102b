// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The points of tools with a shape, spread over their meshes: on the thread that asks, or before,
 * in the background.
 */
#ifndef ShellPoints_h
#define ShellPoints_h

#include "Core/Model/PointShell.h"
#include "VTK/Base/BackgroundWork.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <tuple>

class vtkPolyData;

namespace VolumeHaptics
{

/** A tick of more takes too long for any servo, and their memory must stay there. */
constexpr int MostShellPoints = 100000;

/**
 * A mesh, when it changed, and the number of its points. Times of change are unique: data at the
 * place of others has another one.
 */
using ShellKey = std::tuple<const void*, vtkMTimeType, int>;

/** The points of a mesh; or null, and why there are none. */
struct SpreadShell
{
  std::shared_ptr<const PointShell> Points;
  std::string Error;
};

/**
 * The points of a mesh, 1 to MostShellPoints of them. Those of a mesh that has not changed are
 * those that models still use, or that were made last. Null, with the reason and the cure in
 * `error`, if the mesh is no closed surface.
 */
std::shared_ptr<const PointShell> GetShellPoints(vtkPolyData* mesh, int count, std::string& error);

/** Spreads points in the background, so that GetShellPoints() is quick then. */
class ShellPreparation
{
public:
  /** Whether GetShellPoints() is quick now. If not, the points are made, one mesh at a time. */
  bool Prepare(vtkPolyData* mesh, int count);
  /** Ends what Prepare() began, without waiting for it. */
  void EndPreparing() { this->Spreading.Abandon(); }

private:
  KeyedWork<ShellKey, SpreadShell> Spreading;
};

} // namespace VolumeHaptics

#endif
