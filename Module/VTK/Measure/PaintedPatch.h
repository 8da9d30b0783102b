// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Cuts out the part of an isosurface over which a brush was moved.
 */
#ifndef PaintedPatch_h
#define PaintedPatch_h

#include "Core/Math/Vector3.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

class vtkDataArray;

namespace VolumeHaptics
{

/**
 * Paints the isosurface. A point of the isosurface is painted if its straight-line distance to the
 * brush's line is below the radius. The brush's line joins the points of the surface that are
 * nearest to the brush's positions. For example, a dab on a plane or on a sphere has the area pi
 * r^2, and a straight stroke of length L on a plane has the area 2 r L + pi r^2. A part that is not
 * connected to the brush's line, such as the other side of a thin wall, is not painted.
 *
 * The isosurface (vtkFlyingEdges3D) is made in small blocks. Each block is made once, when the
 * brush first comes near it.
 */
class PaintedPatch
{
public:
  /**
   * Prepares to paint on the isosurface of an image's point scalars. `radius` is in world units.
   */
  PaintedPatch(
    vtkImageData* image, vtkDataArray* scalars, int component, double value, double radius);
  ~PaintedPatch();

  /**
   * Moves the brush to a position in the world and paints. If no part of the surface is within the
   * radius plus three voxels, returns false and paints nothing; the next position then begins a new
   * line.
   */
  bool LeadTo(const Vector3& position);

  /** Makes the next position begin a new line. */
  void Lift() { this->Last.reset(); }

  /** Returns whether the image's samples have the same positions as this patch's image. */
  bool IsOf(vtkImageData* image) const;

  /** Returns the painted triangles; empty if there are none. */
  vtkSmartPointer<vtkPolyData> Cut() const;

private:
  using Block = std::array<int, 3>;
  struct Part
  {
    vtkNew<vtkPolyData> Surface; ///< world
    vtkNew<vtkStaticCellLocator> Locator;
    std::vector<double> Distances; ///< squared distance of each point to the brush's line
  };

  /**
   * Calls `visit` for each part of the isosurface within `distance` of the bounding box of two
   * positions.
   */
  template <typename F>
  void Visit(const Vector3& from, const Vector3& to, double distance, F&& visit);
  Part& Get(const Block& block);
  void Mesh(const Block& block, Part& part) const;
  std::optional<Vector3> FindNearest(const Vector3& position);

  /** Copy of the user's image without samples, because the user may change that image. */
  vtkNew<vtkImageData> Image;
  vtkSmartPointer<vtkDataArray> Scalars;
  const int Component;
  const double Value;
  const double Radius;
  double Voxel = 1.0; ///< smallest spacing (world units)
  std::map<Block, Part> Parts;
  /** Position of the brush on the surface; empty if the next position begins a line. */
  std::optional<Vector3> Last;
  std::vector<Vector3> Visited; ///< all positions of the brush on the surface
};

} // namespace VolumeHaptics

#endif
