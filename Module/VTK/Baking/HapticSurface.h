// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the triangles that SURFACE_PROXY touches, from an isosurface or from a given surface.
 */
#ifndef HapticSurface_h
#define HapticSurface_h

#include "Core/Model/HapticModelDescription.h"
#include "Core/Model/SurfaceMesh.h"
#include "Core/Realtime/BackgroundWork.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <string>
#include <tuple>

class vtkDataArray;
class vtkPolyData;

namespace VolumeHaptics
{

class SurfaceMesh;

/** Part of an image that vtkHapticRegionFilter made, with the isosurface in it. */
struct SurfaceRegion
{
  vtkSmartPointer<vtkImageData> Image;
  std::shared_ptr<const SurfaceMesh> Mesh; ///< null if the region contains no surface
};

/** Defines an isosurface: the image and the value. */
struct IsoSurface
{
  vtkImageData* Image;
  vtkDataArray* Scalars;
  int Component;
  double Value;
  /**
   * Index of the image's first sample in the index space of indexToWorld; not 0 for a region of a
   * larger volume.
   */
  int First[3] = { 0, 0, 0 };
  bool MayBeEmpty = false; ///< true for a region, which the surface may not cross
};

/**
 * Copies the polygons and strips of a surface; the copy shares their memory. It has its own
 * cursors, so that a worker may traverse it.
 */
void ShareCells(vtkPolyData* from, vtkPolyData* to);

/** Estimated time (s) above which meshing runs in the background. */
inline constexpr double ShortMeshing = 40e-3;

/** Estimates the time (s) to mesh an isosurface, from a subset of its samples. */
double EstimateMeshTime(const IsoSurface& iso);

/**
 * Meshes an isosurface in the samples of an extent. indexToWorld maps the indices of this extent.
 * Returns null if there are no triangles. Any thread may call it, but the array must have VTK's
 * standard memory layout.
 */
std::shared_ptr<const SurfaceMesh> MeshIsoSurface(vtkDataArray* scalars, const int extent[6],
  int component, double value, const Affine3& indexToWorld);

/**
 * Meshes the isosurface in a time step of a moving volume, with its motion to the next time step.
 * Returns null if there is no isosurface. The time steps' samples must be vtkDataArrays
 * (ShareArray() of the model's builder). Any thread may call it, but the arrays must have VTK's
 * standard memory layout.
 */
std::shared_ptr<const SurfaceMesh> MeshTimeStep(const VolumeTimeStep& timeStep,
  const VolumeTimeStep& next, int component, double value, const Affine3& indexToWorld);

/**
 * Makes a mesh of a surface in the world. Returns null and names the surface in `error` if it has
 * no triangles, a point that is not finite, or a cell that refers to a missing point. `cure` ends
 * the error for a surface without triangles.
 */
std::shared_ptr<const SurfaceMesh> MeshSurface(
  vtkPolyData* surface, const std::string& name, const std::string& cure, std::string& error);

/** Makes meshes, and caches the last one until its input changes. */
class HapticSurface
{
public:
  /** A mesh; null if the surface does not exist. */
  using MeshPointer = std::shared_ptr<const SurfaceMesh>;

  /**
   * Returns the triangles of a surface in the world or, without a surface, those of the isosurface
   * (vtkFlyingEdges3D). Returns null, with the cure in `error`, if there are no triangles or if a
   * point is not finite.
   */
  std::shared_ptr<const SurfaceMesh> Get(
    vtkPolyData* surface, const IsoSurface& iso, const Affine3& indexToWorld, std::string& error);

  /**
   * Returns whether Get() would be quick now. If not, starts to make the mesh in the background.
   * Only one mesh is made at a time, so the next one starts after the current one has ended.
   */
  bool Prepare(vtkPolyData* surface, const IsoSurface& iso, const Affine3& indexToWorld);
  /** Abandons the background work of Prepare() without waiting for it. */
  void EndPreparing() { this->Meshing.Abandon(); }
  /**
   * Waits at most this many seconds until no mesh is being made. Returns whether the background is
   * idle.
   */
  bool WaitFor(double seconds) const { return this->Meshing.WaitFor(seconds); }

  /**
   * Stores a region's mesh that was made elsewhere, so that Get() returns it for this isosurface.
   * The last mesh made here is kept as well.
   */
  void Give(const IsoSurface& iso, MeshPointer mesh);

  /** Estimates the time (s) that Get() will need; 0 if the last mesh is still valid. */
  double EstimateTime(vtkPolyData* surface, const IsoSurface& iso) const;

private:
  /**
   * Key of a cached mesh: the input data, their modification time, and the value and component of
   * an isosurface.
   */
  using Key = std::tuple<const void*, const void*, vtkMTimeType, double, int>;

  static Key MakeKey(vtkPolyData* surface, const IsoSurface& iso);
  bool IsMadeOf(const Key& key) const { return this->Mesh && key == this->MadeOf; }

  static constexpr Key NoKey{ nullptr, nullptr, 0, 0.0, 0 };

  /** Mesh that a worker has made, or its error. */
  struct Made
  {
    MeshPointer Mesh;
    std::string Error; ///< why a given surface has no mesh
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
