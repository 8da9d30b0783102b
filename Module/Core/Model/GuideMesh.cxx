// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/GuideMesh.h"

#include <numeric>
#include <tuple>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Returns the unit vector along a sum, or `otherwise` if the summands cancel. */
Vector3 UnitOf(const Vector3& sum, const Vector3& otherwise) noexcept
{
  const double length = Norm(sum);
  return length > 1e-6 ? (1.0 / length) * sum : otherwise;
}

double AngleBetween(const Vector3& a, const Vector3& b) noexcept
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b));
}

} // namespace

GuideMesh::GuideMesh(std::shared_ptr<const SurfaceMesh> mesh, double rounding)
  : Mesh(std::move(mesh))
  , Rounding(rounding)
{
  this->CollectFaces();
  const std::vector<SurfaceMesh::Indices> merged = this->MergeCorners();
  this->ComputeCorners(merged);
  this->CollectEdges(merged);
  this->CornersOf = merged;
}

std::size_t GuideMesh::GetMemorySize() const noexcept
{
  return sizeof(*this) + this->Mesh->GetMemorySize() + this->Faces.capacity() * sizeof(Face) +
    this->Corners.capacity() * sizeof(Corner) +
    this->CornersOf.capacity() * sizeof(SurfaceMesh::Indices);
}

void GuideMesh::CollectFaces()
{
  const std::int64_t count = this->Mesh->GetNumberOfTriangles();
  this->Faces.resize(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    const auto& [a, b, c] = this->Mesh->GetTriangle(static_cast<std::int32_t>(i)).Corner;
    Face& face = this->Faces[static_cast<std::size_t>(i)];
    const Vector3 cross = Cross(b - a, c - a);
    const double area = Norm(cross); // twice the area; more than 0 for all triangles of a mesh
    const double length[3] = { Norm(c - b), Norm(a - c), Norm(b - a) };
    face.Normal = (1.0 / area) * cross;
    for (int e = 0; e < 3; ++e)
    {
      face.AtEdge[e] = face.Normal;
      face.Height[e] = area / length[e];
    }
    // End the turn at the middle of the triangle, so that a place is near at most two edges.
    face.Turn = std::min(0.5 * this->Rounding, area / (length[0] + length[1] + length[2]));
  }
}

std::vector<SurfaceMesh::Indices> GuideMesh::MergeCorners()
{
  const std::vector<Vector3>& points = this->Mesh->GetPoints();
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t i) { return std::tie(points[i].X, points[i].Y, points[i].Z); };
  std::sort(
    order.begin(), order.end(), [&](std::int32_t i, std::int32_t j) { return key(i) < key(j); });
  std::vector<std::int32_t> number(points.size());
  std::int32_t count = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    count += i > 0 && key(order[i]) != key(order[i - 1]) ? 1 : 0;
    number[order[i]] = count;
  }
  this->Corners.resize(points.empty() ? 0 : static_cast<std::size_t>(count) + 1);
  std::vector<SurfaceMesh::Indices> merged(this->Faces.size());
  for (std::size_t i = 0; i < merged.size(); ++i)
  {
    const SurfaceMesh::Indices& corners = this->Mesh->GetCorners(static_cast<std::int32_t>(i));
    merged[i] = { number[corners[0]], number[corners[1]], number[corners[2]] };
  }
  return merged;
}

void GuideMesh::ComputeCorners(const std::vector<SurfaceMesh::Indices>& merged)
{
  for (Corner& corner : this->Corners)
  {
    corner.Turn = 0.5 * this->Rounding;
  }
  for (std::size_t i = 0; i < merged.size(); ++i)
  {
    const Triangle triangle = this->Mesh->GetTriangle(static_cast<std::int32_t>(i));
    for (int c = 0; c < 3; ++c)
    {
      const Vector3 ahead = triangle.Corner[(c + 1) % 3] - triangle.Corner[c];
      const Vector3 behind = triangle.Corner[(c + 2) % 3] - triangle.Corner[c];
      Corner& corner = this->Corners[merged[i][c]];
      corner.Normal += AngleBetween(ahead, behind) * this->Faces[i].Normal;
      corner.Turn = std::min({ corner.Turn, 0.5 * Norm(ahead), 0.5 * Norm(behind) });
    }
  }
  for (std::size_t i = 0; i < merged.size(); ++i)
  {
    for (const std::int32_t c : merged[i])
    {
      this->Corners[c].Normal = UnitOf(this->Corners[c].Normal, this->Faces[i].Normal);
    }
  }
}

void GuideMesh::CollectEdges(const std::vector<SurfaceMesh::Indices>& merged)
{
  struct Edge
  {
    std::int32_t Low;
    std::int32_t High;
    std::int32_t Face;
    int Opposite;
    auto Key() const { return std::tie(this->Low, this->High); }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * merged.size());
  for (std::size_t i = 0; i < merged.size(); ++i)
  {
    for (int e = 0; e < 3; ++e)
    {
      const auto [low, high] = std::minmax(merged[i][(e + 1) % 3], merged[i][(e + 2) % 3]);
      edges.push_back({ low, high, static_cast<std::int32_t>(i), e });
    }
  }
  std::sort(
    edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Key() < b.Key(); });
  for (auto first = edges.begin(); first != edges.end();)
  {
    Vector3 sum;
    auto last = first;
    for (; last != edges.end() && last->Key() == first->Key(); ++last)
    {
      sum += this->Faces[last->Face].Normal;
    }
    for (; first != last; ++first)
    {
      Face& face = this->Faces[first->Face];
      face.AtEdge[first->Opposite] = UnitOf(sum, face.Normal);
    }
  }
}

GuideMeshPlace GuideMesh::Find(const Vector3& position) const noexcept
{
  const MeshPlace place = this->Mesh->FindNearest(position, Budget);
  if (place.Triangle < 0)
  {
    return {};
  }
  const Face& face = this->Faces[place.Triangle];
  const double* const weight = place.Point.Weight;
  double u[3];
  for (int e = 0; e < 3; ++e)
  {
    u[e] = std::min(1.0, weight[e] * face.Height[e] / face.Turn);
  }
  double sum = u[0] * u[1] * u[2];
  Vector3 mixed = sum * face.Normal;
  for (int e = 0; e < 3; ++e)
  {
    const double fraction = (1.0 - u[e]) * u[(e + 1) % 3] * u[(e + 2) % 3];
    sum += fraction;
    mixed += fraction * face.AtEdge[e];
  }
  const int nearest = weight[0] > weight[1] ? (weight[0] > weight[2] ? 0 : 2)
    : weight[1] > weight[2]                 ? 1
                                            : 2;
  const Vector3& at = this->Mesh->GetPoints()[this->Mesh->GetCorners(place.Triangle)[nearest]];
  const Corner& corner = this->Corners[this->CornersOf[place.Triangle][nearest]];
  const double fraction = std::min(1.0, Norm(place.Point.Position - at) / corner.Turn);
  // At a corner, the edges contribute nothing.
  const Vector3 along = sum > 0.0 ? (fraction / sum) * mixed : Vector3{};
  return { place.Point.Position, UnitOf(along + (1.0 - fraction) * corner.Normal, face.Normal),
    true };
}

} // namespace VolumeHaptics
