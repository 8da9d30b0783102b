// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/SurfaceMesh.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace VolumeHaptics
{
namespace
{

/**
 * The normal of a triangle is not reliable if the triangle's height is below this fraction of its
 * longest edge.
 */
constexpr double LeastHeight = 1e-9;

bool HasArea(const Triangle& triangle)
{
  const Vector3 ab = triangle.Corner[1] - triangle.Corner[0];
  const Vector3 ac = triangle.Corner[2] - triangle.Corner[0];
  const Vector3 bc = ac - ab;
  const double longest = std::max({ Dot(ab, ab), Dot(ac, ac), Dot(bc, bc) });
  // The comparison is false for NaN, too.
  return Norm(Cross(ab, ac)) > LeastHeight * longest && std::isfinite(longest);
}

float RoundDown(double x)
{
  const float rounded = static_cast<float>(x);
  return rounded <= x ? rounded : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

float RoundUp(double x)
{
  return -RoundDown(-x);
}

} // namespace

SurfaceMesh::SurfaceMesh(std::vector<Vector3> points, const std::vector<Indices>& triangles,
  std::vector<Vector3> normals, std::vector<Vector3> motions)
  : Points(std::move(points))
  , Normals(std::move(normals))
  , Motions(std::move(motions))
{
  for (const Vector3& motion : this->Motions)
  {
    this->LongestMotion = std::max(this->LongestMotion, Norm(motion));
  }
  this->Triangles.reserve(triangles.size());
  for (const Indices& corners : triangles)
  {
    const Triangle triangle{ { this->Points[corners[0]], this->Points[corners[1]],
      this->Points[corners[2]] } };
    if (HasArea(triangle))
    {
      this->Triangles.push_back(corners);
    }
  }
  this->Build();
}

std::size_t SurfaceMesh::GetMemorySize() const noexcept
{
  return sizeof(*this) + this->Points.capacity() * sizeof(Vector3) +
    this->Normals.capacity() * sizeof(Vector3) + this->Motions.capacity() * sizeof(Vector3) +
    this->Triangles.capacity() * sizeof(Indices) + this->Boxes.capacity() * sizeof(Box) +
    this->Nodes.capacity() * sizeof(Node);
}

int SurfaceMesh::EstimateVisits(double distance) const noexcept
{
  constexpr std::int64_t places = 256;
  const std::int64_t step = std::max<std::int64_t>(1, this->GetNumberOfTriangles() / places);
  int most = 0;
  for (std::int64_t i = 0; i < this->GetNumberOfTriangles(); i += step)
  {
    const auto& [a, b, c] = this->GetTriangle(static_cast<std::int32_t>(i)).Corner;
    int budget = std::numeric_limits<int>::max();
    this->VisitNear((1.0 / 3.0) * (a + b + c), distance, budget, [](std::int32_t) {});
    most = std::max(most, std::numeric_limits<int>::max() - budget);
  }
  return most;
}

Vector3 SurfaceMesh::GetNormal(std::int32_t i, const TrianglePoint& point) const noexcept
{
  const Indices& corners = this->Triangles[i];
  return point.Weight[0] * this->Normals[corners[0]] + point.Weight[1] * this->Normals[corners[1]] +
    point.Weight[2] * this->Normals[corners[2]];
}

double SurfaceMesh::SquareDistance(const Box& box, const Vector3& position) noexcept
{
  const Vector3 below{ box.Low[0] - position.X, box.Low[1] - position.Y, box.Low[2] - position.Z };
  const Vector3 above{ position.X - box.High[0], position.Y - box.High[1],
    position.Z - box.High[2] };
  const Vector3 outside = Most(Most(below, above), Vector3{});
  return Dot(outside, outside);
}

MeshPlace SurfaceMesh::FindNearest(const Vector3& position, int budget) const noexcept
{
  struct Waiting
  {
    std::int32_t Node;
    double Square;
  };
  MeshPlace found;
  found.Square = std::numeric_limits<double>::infinity();
  Waiting waiting[Deepest + 1];
  int count = 0;
  if (!this->Nodes.empty())
  {
    waiting[count++] = { 0, 0.0 };
  }
  while (count > 0 && budget > 0)
  {
    const Waiting next = waiting[--count];
    if (!(next.Square < found.Square))
    {
      continue;
    }
    const Node& node = this->Nodes[next.Node];
    budget -= 1 + node.Count;
    if (node.Count == 0)
    {
      // Visit the nearer child first.
      Waiting near = { node.First, SquareDistance(this->Nodes[node.First].Bounds, position) };
      Waiting far = { node.First + 1,
        SquareDistance(this->Nodes[node.First + 1].Bounds, position) };
      if (far.Square < near.Square)
      {
        std::swap(near, far);
      }
      waiting[count++] = far;
      waiting[count++] = near;
    }
    for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
    {
      if (SquareDistance(this->Boxes[i], position) < found.Square)
      {
        const TrianglePoint point = NearestPoint(this->GetTriangle(i), position);
        const Vector3 away = position - point.Position;
        if (Dot(away, away) < found.Square)
        {
          found = { i, point, Dot(away, away) };
        }
      }
    }
  }
  return found;
}

SurfaceMesh::Box SurfaceMesh::MakeBox(const Triangle& triangle)
{
  const auto& [a, b, c] = triangle.Corner;
  const double low[3] = { std::min({ a.X, b.X, c.X }), std::min({ a.Y, b.Y, c.Y }),
    std::min({ a.Z, b.Z, c.Z }) };
  const double high[3] = { std::max({ a.X, b.X, c.X }), std::max({ a.Y, b.Y, c.Y }),
    std::max({ a.Z, b.Z, c.Z }) };
  return { { RoundDown(low[0]), RoundDown(low[1]), RoundDown(low[2]) },
    { RoundUp(high[0]), RoundUp(high[1]), RoundUp(high[2]) } };
}

SurfaceMesh::Box SurfaceMesh::MakeBox(std::int32_t first, std::int32_t count) const
{
  Box all = this->Boxes[first];
  for (std::int32_t i = first + 1; i < first + count; ++i)
  {
    all = Unite(all, this->Boxes[i]);
  }
  return all;
}

SurfaceMesh::Box SurfaceMesh::Unite(const Box& one, const Box& other)
{
  Box both = one;
  for (int a = 0; a < 3; ++a)
  {
    both.Low[a] = std::min(one.Low[a], other.Low[a]);
    both.High[a] = std::max(one.High[a], other.High[a]);
  }
  return both;
}

void SurfaceMesh::Build()
{
  const auto size = static_cast<std::int32_t>(this->Triangles.size());
  if (size == 0)
  {
    return;
  }
  std::vector<Box> boxes(size);
  for (std::int32_t i = 0; i < size; ++i)
  {
    boxes[i] = MakeBox(this->GetTriangle(i));
    if (!this->Motions.empty())
    {
      boxes[i] = Unite(boxes[i], MakeBox(this->GetTriangle(i, 1.0)));
    }
  }
  std::vector<std::int32_t> order(size);
  std::iota(order.begin(), order.end(), 0);

  // Split the triangles into two halves of equal number, along the axis on which their centres are
  // spread most.
  const auto twiceMiddle = [&](std::int32_t i, int axis)
  { return boxes[i].Low[axis] + boxes[i].High[axis]; };
  this->Nodes.push_back({ {}, 0, size });
  for (std::size_t n = 0; n < this->Nodes.size(); ++n)
  {
    const auto [bounds, first, count] = this->Nodes[n];
    if (count <= LeafSize)
    {
      continue;
    }
    const auto begin = order.begin() + first;
    int axis = 0;
    float widest = -1.0f;
    for (int a = 0; a < 3; ++a)
    {
      const auto [low, high] = std::minmax_element(begin, begin + count,
        [&](std::int32_t i, std::int32_t j) { return twiceMiddle(i, a) < twiceMiddle(j, a); });
      const float width = twiceMiddle(*high, a) - twiceMiddle(*low, a);
      axis = width > widest ? a : axis;
      widest = std::max(width, widest);
    }
    const std::int32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count,
      [&](std::int32_t i, std::int32_t j) { return twiceMiddle(i, axis) < twiceMiddle(j, axis); });
    this->Nodes[n].First = static_cast<std::int32_t>(this->Nodes.size());
    this->Nodes[n].Count = 0;
    this->Nodes.push_back({ {}, first, half });
    this->Nodes.push_back({ {}, first + half, count - half });
  }

  std::vector<Indices> triangles(size);
  this->Boxes.resize(size);
  for (std::int32_t i = 0; i < size; ++i)
  {
    triangles[i] = this->Triangles[order[i]];
    this->Boxes[i] = boxes[order[i]];
  }
  this->Triangles = std::move(triangles);
  // Children come after their parents, so start from the end to compute their boxes first.
  for (auto node = this->Nodes.rbegin(); node != this->Nodes.rend(); ++node)
  {
    if (node->Count > 0)
    {
      node->Bounds = this->MakeBox(node->First, node->Count);
      continue;
    }
    node->Bounds = Unite(this->Nodes[node->First].Bounds, this->Nodes[node->First + 1].Bounds);
  }
}

} // namespace VolumeHaptics
