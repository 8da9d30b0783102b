// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes the isosurface around the tip while the mesh of the whole image is still being made.
 */
#ifndef RegionMesher_h
#define RegionMesher_h

#include "Core/Realtime/BackgroundWork.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Regions/RegionPlanner.h"

#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>

class vtkDataArray;
class vtkImageData;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{
class SurfaceMesh;

/** Meshes regions around the tip on a worker thread. Call it from the owner's thread. */
class RegionMesher
{
public:
  RegionMesher();
  ~RegionMesher();

  /**
   * Returns the next region once its mesh is ready. Returns nothing if the last region still
   * suffices, if the next one is still being meshed, or if the image can't be touched. Call this
   * often, with the tip in the world.
   */
  std::optional<SurfaceRegion> Poll(vtkVolumeHapticsFilter* filter, const double tip[3]);
  /** Stops the work without waiting for it, and discards the last region. */
  void End();

private:
  using Extent = std::array<int, 6>;
  /** Key of an isosurface: its samples, their component, and its value. */
  using SurfaceKey = std::tuple<TouchedArray::Key, int, double>;
  /** Result of the worker: the samples and mesh of a region. */
  struct Made
  {
    vtkSmartPointer<vtkDataArray> Samples;
    std::shared_ptr<const SurfaceMesh> Mesh;
  };

  std::optional<SurfaceRegion> Drain(vtkImageData* image, vtkVolumeHapticsFilter* filter);
  void Order(vtkImageData* image, vtkVolumeHapticsFilter* filter, const Extent& region);

  RegionPlanner Planner;
  std::optional<SurfaceKey> Of;
  Extent Region;
  std::optional<Extent> Ordered;
  std::int64_t OrderTime = 0; // ServoClock
  KeyedWork<std::tuple<SurfaceKey, Extent>, Made> Meshing;
};

} // namespace VolumeHaptics

#endif
