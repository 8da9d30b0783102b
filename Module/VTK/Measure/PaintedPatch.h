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
 * Paints the isosurface. A point of it is painted if its straight distance to the brush's line on
 * the surface is below the radius; this line joins the surface points nearest to the brush's
 * positions. So a dab on a plane or on a sphere has the area pi r^2, and a straight stroke of
 * length L on a plane 2 r L + pi r^2. A part that is not connected with the brush's line, such as
 * the other side of a thin wall, is not painted.
 *
 * The isosurface (vtkFlyingEdges3D) is made in small blocks, each once, when the brush first comes
 * near it.
 */
class PaintedPatch
{
public:
  /** Paints on the isosurface of an image's point scalars; the radius is in world units. */
  PaintedPatch(
    vtkImageData* image, vtkDataArray* scalars, int component, double value, double radius);
  ~PaintedPatch();

  /**
   * Moves the brush to a position in the world. False if no part of the surface is within the
   * radius plus three voxels: then nothing is painted, and the next position begins a new line.
   */
  bool LeadTo(const Vector3& position);

  /** Makes the next position begin a new line. */
  void Lift() { this->Last.reset(); }

  /** Whether an image has its samples at the positions of this patch's samples. */
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
   * Calls `visit` for each part of the isosurface within `distance` of the box around two
   * positions.
   */
  template <typename F>
  void Visit(const Vector3& from, const Vector3& to, double distance, F&& visit);
  Part& Get(const Block& block);
  void Mesh(const Block& block, Part& part) const;
  std::optional<Vector3> FindNearest(const Vector3& position);

  vtkNew<vtkImageData> Image; ///< geometry only: that of the user's image may change
  vtkSmartPointer<vtkDataArray> Scalars;
  const int Component;
  const double Value;
  const double Radius;
  double Voxel = 1.0; ///< smallest spacing
  std::map<Block, Part> Parts;
  std::optional<Vector3> Last;  ///< last position on the surface
  std::vector<Vector3> Visited; ///< positions on the surface
};

} // namespace VolumeHaptics

#endif
