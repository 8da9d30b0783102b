// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The triangles that SURFACE_PROXY touches: those of an isosurface, or of a given surface.
 */
#ifndef HapticSurface_h
#define HapticSurface_h

#include "Core/Model/HapticModelDescription.h"
#include "Core/Model/SurfaceMesh.h"
#include "VTK/Base/BackgroundWork.h"

#include "vtkType.h"

#include <memory>
#include <string>
#include <tuple>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace VolumeHaptics
{
/** The image and the value of an isosurface. */
struct IsoSurface
{
  vtkImageData* Image;
  vtkDataArray* Scalars;
  int Component;
  double Value;
  /**
   * Index of the image's first sample, as indexToWorld counts; not 0 for a region of a larger
   * volume.
   */
  int First[3] = { 0, 0, 0 };
  bool MayBeEmpty = false; ///< a region may contain no part of the surface
};

/**
 * Gives polygons and strips to another surface, with cursors of its own, so that a worker may go
 * through them. Their memory is shared.
 */
void ShareCells(vtkPolyData* from, vtkPolyData* to);

/** What takes longer (s) is meshed in the background. */
inline constexpr double ShortMeshing = 40e-3;

/** How long it takes to mesh an isosurface, approximately (s); looks at some of its samples. */
double EstimateMeshTime(const IsoSurface& iso);

/**
 * The triangles of an isosurface in samples of an extent, which counts as indexToWorld does; null
 * if there are none. Any thread may call it: the array has to be of VTK's standard memory layout.
 */
std::shared_ptr<const SurfaceMesh> MeshIsoSurface(vtkDataArray* scalars, const int extent[6],
  int component, double value, const Affine3& indexToWorld);

/**
 * The triangles of the isosurface in a frame of a volume that moves, on their way to the next one;
 * none if it has no isosurface. The frames keep vtkDataArrays alive. Any thread may call it: the
 * arrays have to be of VTK's standard memory layout.
 */
std::shared_ptr<const SurfaceMesh> MeshFrame(const VolumeFrame& frame, const VolumeFrame& next,
  int component, double value, const Affine3& indexToWorld);

/**
 * The triangles of a surface in the world. Null if there are none, a point is not finite, or a cell
 * has a point that does not exist: `error` is then about the surface of that name; the cure is that
 * of a surface without triangles.
 */
std::shared_ptr<const SurfaceMesh> MeshSurface(
  vtkPolyData* surface, const std::string& name, const std::string& cure, std::string& error);

/** Makes meshes, and keeps the last one until its input changes. */
class HapticSurface
{
public:
  /** Null if there is no such surface. */
  using MeshPointer = std::shared_ptr<const SurfaceMesh>;

  /**
   * The triangles of a surface in the world or, if it is null, of the isosurface
   * (vtkFlyingEdges3D). Null, with the cure in `error`, if there are none or a point is not finite.
   */
  std::shared_ptr<const SurfaceMesh> Get(
    vtkPolyData* surface, const IsoSurface& iso, const Affine3& indexToWorld, std::string& error);

  /**
   * Whether Get() would be quick now. If not, the mesh is made in the background. One mesh is made
   * at a time: the next one begins when the last one has ended.
   */
  bool Prepare(vtkPolyData* surface, const IsoSurface& iso, const Affine3& indexToWorld);
  /** Ends what Prepare() began, without waiting for it. */
  void EndPreparing() { this->Meshing.Abandon(); }
  /** Waits until nothing is made, or for some seconds; returns whether nothing is. */
  bool WaitFor(double seconds) const { return this->Meshing.WaitFor(seconds); }

  /**
   * A mesh that was made elsewhere, for Get() of this isosurface, which is that of a region. The
   * last mesh is kept as well.
   */
  void Give(const IsoSurface& iso, MeshPointer mesh);

  /** How long Get() takes, approximately (s): 0 if the last mesh is still valid. */
  double EstimateTime(vtkPolyData* surface, const IsoSurface& iso) const;

private:
  /** The input data, their change time, and the value and component of an isosurface. */
  using Key = std::tuple<const void*, const void*, vtkMTimeType, double, int>;

  static Key MakeKey(vtkPolyData* surface, const IsoSurface& iso);
  bool IsMadeOf(const Key& key) const { return this->Mesh && key == this->MadeOf; }

  static constexpr Key NoKey{ nullptr, nullptr, 0, 0.0, 0 };

  /** The result of a worker. */
  struct Made
  {
    MeshPointer Mesh;
    std::string Error; ///< why there is no mesh of a given surface
  };
  static Made Make(vtkPolyData* surface);

  MeshPointer Mesh;
  Key MadeOf = NoKey;
  MeshPointer Given;
  Key GivenOf = NoKey;
  KeyedWork<Key, Made> Meshing;
};

} // namespace VolumeHaptics

#endif
