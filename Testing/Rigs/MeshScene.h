// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Makes meshes with known contacts, and random shapes. */
#ifndef MeshScene_h
#define MeshScene_h

#include "Core/Model/SurfaceMesh.h"

#include <memory>
#include <random>

namespace coretest
{
using namespace VolumeHaptics;
using Corners = std::vector<Vector3>;
using Faces = std::vector<SurfaceMesh::Indices>;

/// Returns a floor of 2 n^2 triangles at z = 0, for |x|, |y| <= 50.
inline std::shared_ptr<SurfaceMesh> MakeFloor(int n = 1)
{
  Corners points;
  Faces faces;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ 100.0 * i / n - 50.0, 100.0 * j / n - 50.0, 0.0 });
      if (i < n && j < n)
      {
        const int p = j * (n + 1) + i;
        faces.push_back({ p, p + 1, p + n + 2 });
        faces.push_back({ p, p + n + 2, p + n + 1 });
      }
    }
  }
  return std::make_shared<SurfaceMesh>(points, faces, Corners{});
}

/// Returns a cube around the origin with |x|, |y|, |z| <= half.
inline std::shared_ptr<SurfaceMesh> MakeCube(double half)
{
  Corners points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half });
  }
  const Faces faces = { { 0, 1, 3 }, { 0, 3, 2 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 2, 3, 7 }, { 2, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return std::make_shared<SurfaceMesh>(points, faces, Corners{});
}

/// Returns a ball around the origin with n x 2n facets, with or without the normals of the sphere.
inline std::shared_ptr<SurfaceMesh> MakeBall(double radius, int n, bool hasNormals)
{
  Corners points;
  Corners normals;
  Faces faces;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i < 2 * n; ++i)
    {
      const double polar = 3.14159265358979323846 * j / n;
      const double around = 3.14159265358979323846 * i / n;
      const Vector3 normal = { std::sin(polar) * std::cos(around),
        std::sin(polar) * std::sin(around), std::cos(polar) };
      points.push_back(radius * normal);
      normals.push_back(normal);
      if (j < n)
      {
        const int p = j * 2 * n + i;
        const int q = j * 2 * n + (i + 1) % (2 * n);
        faces.push_back({ p, q, q + 2 * n });
        faces.push_back({ p, q + 2 * n, p + 2 * n });
      }
    }
  }
  return std::make_shared<SurfaceMesh>(points, faces, hasNormals ? normals : Corners{});
}

inline double Distance(const Triangle& triangle, const Vector3& x)
{
  return Norm(x - NearestPoint(triangle, x).Position);
}

/// Draws random numbers, points and triangles.
class Dice
{
public:
  explicit Dice(int seed)
    : Random(seed)
  {
  }
  double operator()(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  Vector3 Point(double reach)
  {
    return { (*this)(-reach, reach), (*this)(-reach, reach), (*this)(-reach, reach) };
  }
  Triangle Any() { return { { this->Point(2.0), this->Point(2.0), this->Point(2.0) } }; }

private:
  std::mt19937 Random;
};

} // namespace coretest

#endif
