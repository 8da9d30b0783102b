// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Meshes the isosurface around the tip while that of the whole image is still being made.
 */
#ifndef RegionMesher_h
#define RegionMesher_h

#include "VTK/Baking/SurfaceRegion.h"
#include "VTK/Base/BackgroundWork.h"
#include "VTK/Base/TouchedArray.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>

class vtkDataArray;
class vtkHapticRegionPlanner;
class vtkImageData;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{
class SurfaceMesh;

/** For the owner's thread; the meshes are made on another one. */
class RegionMesher
{
public:
  RegionMesher();
  ~RegionMesher();

  /**
   * To be called often, with the tip in the world. The next region, once it is meshed; nothing if
   * the last one will do, the next one is still being made, or the image can't be touched.
   */
  std::optional<SurfaceRegion> Follow(vtkVolumeHapticsFilter* filter, const double tip[3]);
  /** Ends the work, without waiting for it, and forgets the last region. */
  void End();

private:
  using Extent = std::array<int, 6>;
  /** The samples, and component and value of the isosurface. */
  using SurfaceKey = std::tuple<TouchedArray::Key, int, double>;
  /** What the worker makes. */
  struct Made
  {
    vtkSmartPointer<vtkDataArray> Samples;
    std::shared_ptr<const SurfaceMesh> Mesh;
  };

  std::optional<SurfaceRegion> Take(vtkImageData* image, vtkVolumeHapticsFilter* filter);
  void Order(vtkImageData* image, vtkVolumeHapticsFilter* filter, const Extent& region);

  const vtkNew<vtkHapticRegionPlanner> Planner;
  std::optional<SurfaceKey> Of;
  Extent Region;
  std::optional<Extent> Ordered;
  std::int64_t OrderTime = 0; // ServoClock
  KeyedWork<std::tuple<SurfaceKey, Extent>, Made> Meshing;
};

} // namespace VolumeHaptics

#endif
