// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Triangles in the world, in an immutable tree of boxes that finds the triangles near a position.
 *
 * If the surface moves, the corners of its triangles move along straight lines to their positions
 * in the next time step. The boxes contain these lines.
 *
 * A mesh is built outside the servo thread. Queries visit each triangle at most once and allocate
 * nothing. Each box that a query visits counts against a budget; the query fails when the budget is
 * spent.
 */
#ifndef SurfaceMesh_h
#define SurfaceMesh_h

#include "Core/Math/Triangle.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** The point of a mesh that is nearest to a position. */
struct MeshPlace
{
  std::int32_t Triangle = -1; ///< -1 if the mesh has no triangles
  TrianglePoint Point{};
  double Square = 0.0; ///< squared distance from the position
};

class SurfaceMesh
{
public:
  using Indices = std::array<std::int32_t, 3>;

  /**
   * Makes a mesh of triangles, which are indices into `points` (world units). `normals` are the
   * points' unit normals for shading, or empty. `motions` are the points' motions to the next time
   * step, or empty. Drops triangles without an area, or with a corner that is not finite.
   */
  SurfaceMesh(std::vector<Vector3> points, const std::vector<Indices>& triangles,
    std::vector<Vector3> normals, std::vector<Vector3> motions = {});

  std::int64_t GetNumberOfTriangles() const noexcept
  {
    return static_cast<std::int64_t>(this->Triangles.size());
  }
  bool HasNormals() const noexcept { return !this->Normals.empty(); }
  std::size_t GetMemorySize() const noexcept;

  /** @param fraction position of the points between this time step (0) and the next one (1) */
  Triangle GetTriangle(std::int32_t i, double fraction = 0.0) const noexcept
  {
    const Indices& corners = this->Triangles[i];
    Triangle triangle{ { this->Points[corners[0]], this->Points[corners[1]],
      this->Points[corners[2]] } };
    for (int c = 0; c < 3 && fraction != 0.0 && !this->Motions.empty(); ++c)
    {
      triangle.Corner[c] += fraction * this->Motions[corners[c]];
    }
    return triangle;
  }
  const Indices& GetCorners(std::int32_t i) const noexcept { return this->Triangles[i]; }
  const std::vector<Vector3>& GetPoints() const noexcept { return this->Points; }
  /** Returns the length (world units) of the longest motion of any point to the next time step. */
  double GetLongestMotion() const noexcept { return this->LongestMotion; }
  /** Returns the interpolated normal at a point of a triangle. Its length is only roughly 1. */
  Vector3 GetNormal(std::int32_t i, const TrianglePoint& point) const noexcept;

  /**
   * Estimates the largest number of boxes that VisitNear() visits, from queries around some hundred
   * triangles all over the mesh.
   */
  int EstimateVisits(double distance) const noexcept;

  /**
   * Calls visit(i) for all triangles whose boxes are within a distance of a position. Returns false
   * if the budget is spent.
   */
  template <typename Visitor>
  bool VisitNear(
    const Vector3& position, double distance, int& budget, Visitor&& visit) const noexcept
  {
    const double center[3] = { position.X, position.Y, position.Z };
    const auto isNear = [&](const Box& box)
    {
      bool is = true;
      for (int a = 0; a < 3; ++a)
      {
        is = is && box.Low[a] <= center[a] + distance && box.High[a] >= center[a] - distance;
      }
      return is;
    };
    return this->Visit(isNear, budget, visit);
  }

  /**
   * Returns the place nearest to a finite position. If the budget is spent, the result is the
   * nearest place so far. The mesh must not move.
   */
  MeshPlace FindNearest(const Vector3& position, int budget) const noexcept;

  /**
   * Calls visit(i) for the triangles that a moving sphere may meet. `visit` returns the fraction (0
   * to 1) of the displacement after which other triangles no longer matter. Returns false if the
   * budget is spent.
   */
  template <typename Visitor>
  bool VisitAlong(const Vector3& start, const Vector3& displacement, double radius, int& budget,
    Visitor&& visit) const noexcept
  {
    const double from[3] = { start.X, start.Y, start.Z };
    const double inverse[3] = { 1.0 / displacement.X, 1.0 / displacement.Y, 1.0 / displacement.Z };
    double last = 1.0;
    const auto isOnTheWay = [&](const Box& box)
    {
      double enter = 0.0;
      double leave = last;
      for (int a = 0; a < 3; ++a)
      {
        const double low = box.Low[a] - radius - from[a];
        const double high = box.High[a] + radius - from[a];
        if (std::isinf(inverse[a]))
        {
          leave = low <= 0.0 && high >= 0.0 ? leave : -1.0;
          continue;
        }
        const double t0 = low * inverse[a];
        const double t1 = high * inverse[a];
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
      }
      return enter <= leave;
    };
    return this->Visit(isOnTheWay, budget, [&](std::int32_t i) { last = visit(i); });
  }

private:
  /** A box of single-precision coordinates, which are rounded outward. */
  struct Box
  {
    float Low[3];
    float High[3];
  };
  struct Node
  {
    Box Bounds;
    std::int32_t First; ///< first triangle of a leaf; otherwise the first of two children
    std::int32_t Count; ///< number of a leaf's triangles; 0 if the node is not a leaf
  };

  static constexpr int LeafSize = 4;
  /** Limit of the tree's depth. Each level halves the nodes, so even 2^31 triangles need less. */
  static constexpr int Deepest = 64;

  void Build();
  Box MakeBox(std::int32_t first, std::int32_t count) const;
  static Box MakeBox(const Triangle& triangle);
  static Box Unite(const Box& one, const Box& other);
  static double SquareDistance(const Box& box, const Vector3& position) noexcept;

  template <typename Filter, typename Visitor>
  bool Visit(Filter&& filter, int& budget, Visitor&& visit) const noexcept
  {
    std::int32_t waiting[Deepest];
    int count = 0;
    if (!this->Nodes.empty())
    {
      waiting[count++] = 0;
    }
    while (count > 0)
    {
      const Node& node = this->Nodes[waiting[--count]];
      budget -= 1 + node.Count;
      if (budget < 0)
      {
        return false;
      }
      if (!filter(node.Bounds))
      {
        continue;
      }
      if (node.Count == 0)
      {
        waiting[count++] = node.First + 1;
        waiting[count++] = node.First;
      }
      for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
      {
        if (filter(this->Boxes[i]))
        {
          visit(i);
        }
      }
    }
    return true;
  }

  std::vector<Vector3> Points;
  std::vector<Vector3> Normals;
  std::vector<Vector3> Motions; ///< motions of the points; empty if the mesh does not move
  double LongestMotion = 0.0;
  std::vector<Indices> Triangles; ///< in the order of the leaves
  std::vector<Box> Boxes;         ///< box of each triangle
  std::vector<Node> Nodes;
};

} // namespace VolumeHaptics

#endif
