// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Spreads the points of tools with a shape over their meshes, on the calling thread or ahead in the
 * background.
 */
#ifndef ShellPoints_h
#define ShellPoints_h

#include "Core/Realtime/BackgroundWork.h"
#include "Core/Tools/PointShell/PointShell.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <tuple>

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * Largest number of points. More would take too long in a tick of any servo, and their memory has
 * to stay resident.
 */
constexpr int MostShellPoints = 100000;

/**
 * Key of cached points: their mesh, its modification time, and their number. Modification times are
 * unique, so new data at an old address have another key.
 */
using ShellKey = std::tuple<const void*, vtkMTimeType, int>;

/** Points of a mesh. If Points is null, Error has the reason. */
struct SpreadShell
{
  std::shared_ptr<const PointShell> Points;
  std::string Error;
};

/**
 * Returns the points of a mesh, 1 to MostShellPoints of them. For an unchanged mesh, returns the
 * points that models still use, or the last ones made. Returns null, with the reason and the cure
 * in `error`, if the mesh is not a closed surface.
 */
std::shared_ptr<const PointShell> GetShellPoints(vtkPolyData* mesh, int count, std::string& error);

/** Spreads points in the background, so that GetShellPoints() is quick afterwards. */
class ShellPreparation
{
public:
  /**
   * Returns whether GetShellPoints() would be quick now. If not, makes the points in the
   * background, for one mesh at a time.
   */
  bool Prepare(vtkPolyData* mesh, int count);
  /** Abandons the background work of Prepare() without waiting for it. */
  void EndPreparing() { this->Spreading.Abandon(); }

private:
  KeyedWork<ShellKey, SpreadShell> Spreading;
};

} // namespace VolumeHaptics

#endif
