// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Meshes whose contacts are known, and a model to touch them.
 */
#ifndef MeshScene_h
#define MeshScene_h

#include "CoreScene.h"
#include "SurfaceMesh.h"

#include <memory>

namespace coretest
{
using Corners = std::vector<Vector3>;
using Faces = std::vector<SurfaceMesh::Indices>;

/// The square |x|, |y| <= 50 at z = 0, of 2 n^2 triangles.
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

/// The cube |x|, |y|, |z| <= half.
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

/// A ball round 0 of n x 2n facets, with the normals of the sphere or none.
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

/// World units of a millimetre, a sphere of 1 mm, 500 N/m.
inline HapticModelDescription DescribeMesh(
  const TestVolume& volume, std::shared_ptr<const SurfaceMesh> mesh, double friction = 0.0)
{
  HapticModelDescription description = Describe(volume);
  description.Settings.Method = HapticMethod::SurfaceProxy;
  description.Settings.ProxyRadius = 1.0;
  description.Material.Friction = ConstantPolyline(friction);
  description.Mesh = std::move(mesh);
  return description;
}

/// Leads a tip (mm) along straight ways, step by step (mm).
class Hand
{
public:
  Hand(const HapticModelDescription& description, const Vector3& start)
    : Model(description)
    , Tip(start)
  {
    this->Tick();
  }
  const TickRecord& Lead(const Vector3& goal, double step = 0.1)
  {
    const Vector3 way = goal - this->Tip;
    const double steps = std::ceil(Norm(way) / step);
    const Vector3 from = this->Tip;
    for (double i = 1.0; i <= steps; i += 1.0)
    {
      this->Tip = from + (i / steps) * way;
      this->Tick();
    }
    return this->Record;
  }
  const TickRecord& Tick()
  {
    VolumeHaptics::Tick(this->Model, this->State, 0.001 * this->Tip, this->Record);
    return this->Record;
  }
  Vector3 Proxy() const { return 1000.0 * this->Record.Proxy; }

  const HapticModel Model;
  Vector3 Tip;
  ServoState State;
  TickRecord Record;
};
} // namespace coretest

#endif
