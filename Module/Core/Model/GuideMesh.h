// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mesh that guides a hand. Finds the nearest place on it, with a normal that does not jump.
 *
 *   GuideMesh guide(mesh, 1.0);
 *   const GuideMeshPlace place = guide.Find(world);
 *
 * A proxy on the plane through the nearest place comes to rest where the lag is along the normal.
 * But a tip may be outside an edge, where the lag is along no triangle's normal. The normal
 * therefore turns steadily within half of the rounding from an edge or corner. With u_e = min(1,
 * h_e / turn), where h_e is the distance of the place from edge e of its triangle, and a = min(1, d
 * / turn of the corner), where d is the distance from the nearest corner, the normal is along
 *
 *   (1 - a) n_corner + a (w n_face + sum w_e n_e) / (w + sum w_e),
 *   w = u_0 u_1 u_2,   w_0 = (1 - u_0) u_1 u_2 and so on,
 *
 * where n_e is the bisector of two faces, and n_corner the mean of faces weighted by their angles.
 * On an edge, both triangles give the same normal. Places stay on the mesh, and faces wider than
 * the rounding stay flat.
 */
#ifndef GuideMesh_h
#define GuideMesh_h

#include "Core/Model/SurfaceMesh.h"

#include <memory>

namespace VolumeHaptics
{

struct GuideMeshPlace
{
  Vector3 Nearest;
  Vector3 Normal; ///< unit vector to the side from which the corners are counterclockwise
  bool IsThere = false;
};

/** A mesh with the normals that guiding needs. Immutable. */
class GuideMesh
{
public:
  /**
   * Makes a guide of a mesh. Merges points that coincide.
   * @param rounding width of rounded edges, in the units of the mesh
   */
  GuideMesh(std::shared_ptr<const SurfaceMesh> mesh, double rounding);

  /**
   * Returns the place nearest to a position, which must be finite. Returns an empty place if the
   * mesh has no triangles.
   */
  GuideMeshPlace Find(const Vector3& position) const noexcept;

  double GetRounding() const noexcept { return this->Rounding; }
  std::size_t GetMemorySize() const noexcept;

private:
  struct Face
  {
    Vector3 Normal;
    Vector3 AtEdge[3]; ///< normals at the edges, each with the number of the opposite corner
    double Height[3] = { 0.0, 0.0, 0.0 };
    double Turn = 0.0;
  };
  struct Corner
  {
    Vector3 Normal;
    double Turn = 0.0;
  };
  /**
   * The most boxes that a query visits. A query near the mesh visits far fewer. Visiting this many
   * takes some tens of microseconds.
   */
  static constexpr int Budget = 2000;

  void CollectFaces();
  /** Returns a number for each corner of each triangle. Corners that coincide share a number. */
  std::vector<SurfaceMesh::Indices> MergeCorners();
  void ComputeCorners(const std::vector<SurfaceMesh::Indices>& merged);
  void CollectEdges(const std::vector<SurfaceMesh::Indices>& merged);

  std::shared_ptr<const SurfaceMesh> Mesh;
  double Rounding;
  std::vector<Face> Faces;
  std::vector<Corner> Corners;
  std::vector<SurfaceMesh::Indices> CornersOf; ///< for each triangle, indices into Corners
};

} // namespace VolumeHaptics

#endif
