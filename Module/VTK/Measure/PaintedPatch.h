// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The part of an isosurface over which a brush was led.
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
 * A point of the isosurface is painted if it is nearer than the radius, straight through space, to
 * the line that the brush took on the surface: from one position's nearest point of the surface to
 * the next one's. So a dab on a plane or on a sphere has the area pi r^2, and a straight stroke of
 * length L on a plane 2 r L + pi r^2. A part that is not connected with the brush's line, such as
 * the other side of a thin wall, is not painted.
 *
 * The isosurface (vtkFlyingEdges3D) is made in small blocks, each once, when the brush first comes
 * near it.
 */
class PaintedPatch
{
public:
  /** Of the image's point scalars of an array; the radius is in world units. */
  PaintedPatch(
    vtkImageData* image, vtkDataArray* scalars, int component, double value, double radius);
  ~PaintedPatch();

  /**
   * Leads the brush to a position in the world. False if no part of the surface is within the
   * radius plus three voxels: nothing is painted then, and the next position begins a new line.
   */
  bool LeadTo(const Vector3& position);

  /** The next position begins a new line. */
  void Lift() { this->Last.reset(); }

  /** Whether an image has its samples where this one had them. */
  bool IsOf(vtkImageData* image) const;

  /** The triangles that are painted; empty if there are none. */
  vtkSmartPointer<vtkPolyData> Cut() const;

private:
  using Block = std::array<int, 3>;
  struct Part
  {
    vtkNew<vtkPolyData> Surface; ///< world
    vtkNew<vtkStaticCellLocator> Locator;
    std::vector<double> Distances; ///< squared, of each point to the brush's line
  };

  /** Calls with each part that is within a distance of two positions. */
  template <typename F>
  void Visit(const Vector3& from, const Vector3& to, double distance, F&& visit);
  Part& Get(const Block& block);
  void Mesh(const Block& block, Part& part) const;
  std::optional<Vector3> FindNearest(const Vector3& position);

  vtkNew<vtkImageData> Image; ///< the structure alone: that of the given one may change
  vtkSmartPointer<vtkDataArray> Scalars;
  const int Component;
  const double Value;
  const double Radius;
  double Voxel = 1.0; ///< the smallest spacing
  std::map<Block, Part> Parts;
  std::optional<Vector3> Last;  ///< on the surface
  std::vector<Vector3> Visited; ///< on the surface
};

} // namespace VolumeHaptics

#endif
