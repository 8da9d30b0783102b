// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mesh that guides a hand, with the nearest place on it and a normal that does not jump.
 *
 *   GuideMesh guide(mesh, 1.0);
 *   const GuideMeshPlace place = guide.Find(world);
 *
 * A proxy on the plane through the nearest place rests where the lag is along the normal. But a tip
 * may be outside of an edge, where the lag is along no triangle's normal. So the normal turns
 * steadily within half of the rounding from an edge or corner. With u_e = min(1, h_e / turn), h_e
 * the distance of the place from edge e of its triangle, and a = min(1, d / turn of the corner), d
 * the distance from the nearest corner, the normal is along
 *
 *   (1 - a) n_corner + a (w n_face + sum w_e n_e) / (w + sum w_e),
 *   w = u_0 u_1 u_2,   w_0 = (1 - u_0) u_1 u_2 and so on,
 *
 * with n_e the bisector of two faces and n_corner the mean of faces by their angles. On an edge,
 * both of its triangles give the same. Places stay on the mesh, and faces wider than the rounding
 * stay flat.
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
   * Makes a guide of a mesh. Merges points at the same place.
   * @param rounding in the units of the mesh
   */
  GuideMesh(std::shared_ptr<const SurfaceMesh> mesh, double rounding);

  /**
   * Returns the place nearest to a position, which must be finite. Returns no place if the mesh has
   * no triangles.
   */
  GuideMeshPlace Find(const Vector3& position) const noexcept;

  double GetRounding() const noexcept { return this->Rounding; }
  std::size_t GetMemorySize() const noexcept;

private:
  struct Face
  {
    Vector3 Normal;
    Vector3 AtEdge[3]; ///< normals at the edges; each edge has the number of the opposite corner
    double Height[3] = { 0.0, 0.0, 0.0 };
    double Turn = 0.0;
  };
  struct Corner
  {
    Vector3 Normal;
    double Turn = 0.0;
  };
  /**
   * Limit of the boxes that a query visits. It is many more than a place near the mesh needs, and
   * takes some tens of microseconds.
   */
  static constexpr int Budget = 2000;

  void CollectFaces();
  /** Returns the triangles' corners as numbers. Corners at the same place share a number. */
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
