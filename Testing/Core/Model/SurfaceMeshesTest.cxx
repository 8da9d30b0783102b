// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests meshes as they occur in practice (coarse, sharp, cracked, overlapping or empty), with fast
 * hands.
 */

#include "Rigs/SurfaceRig.h"

#include <random>

using namespace coretest;
using SurfaceMeshes = SurfaceTest;

TEST_F(SurfaceMeshes, ShadingSmoothsTheForceOverACoarseMesh)
{
  double worst[2];
  for (const bool isShaded : { false, true })
  {
    HapticModelDescription description = DescribeMesh(this->Volume, MakeBall(20.0, 12, true));
    description.Settings.ForceShading = isShaded;
    Hand hand(description, { 0.0, 25.0, 0.0 });
    hand.Lead({ 0.0, 18.0, 0.0 });
    worst[isShaded] = 0.0;
    for (int i = 0; i < 600; ++i)
    {
      const Vector3 out = { std::sin(0.01 * i), std::cos(0.01 * i), 0.0 };
      hand.Lead(18.0 * out, 1.0);
      const double cosine = Dot(hand.Record.Force, out) / Norm(hand.Record.Force);
      worst[isShaded] = std::max(worst[isShaded], std::acos(std::min(1.0, cosine)));
    }
  }
  EXPECT_GT(worst[0], 0.08) << "the facets turn by 15 degrees";
  EXPECT_LT(worst[1], 0.6 * worst[0]);
}

TEST_F(SurfaceMeshes, ShadingStopsAtSharpEdges)
{
  // A cube whose faces have separate corners and normals.
  Corners points;
  Corners normals;
  Faces faces;
  const Vector3 axes[3] = { { 10, 0, 0 }, { 0, 10, 0 }, { 0, 0, 10 } };
  for (int face = 0; face < 6; ++face)
  {
    const Vector3 n = face < 3 ? axes[face] : -axes[face - 3];
    const Vector3& u = axes[(face + 1) % 3];
    const Vector3& v = axes[(face + 2) % 3];
    const int p = int(points.size());
    for (const Vector3& corner : { n - u - v, n + u - v, n + u + v, n - u + v })
    {
      points.push_back(corner);
      normals.push_back(0.1 * n);
    }
    faces.push_back({ p, p + 1, p + 2 });
    faces.push_back({ p, p + 2, p + 3 });
  }
  const auto cube = std::make_shared<SurfaceMesh>(points, faces, normals);
  Hand hand(DescribeMesh(this->Volume, cube), { 14.0, 0.3, 14.0 });
  hand.Lead({ 10.2, 0.3, 10.2 });
  const double s = std::sqrt(0.5);
  this->ExpectAt(hand, { 10.0 + s, 0.3, 10.0 + s });
  hand.Lead({ 5.0, 0.3, 9.0 });
  this->ExpectAt(hand, { 5.0, 0.3, 11.0 });
}

TEST_F(SurfaceMeshes, WhatItOverlapsDoesNotThrowItOut)
{
  Hand hand(DescribeMesh(this->Volume, MakeFloor()), { 0.0, 0.0, 0.2 });
  hand.Lead({ 0.0, 0.0, 0.1 });
  this->ExpectAt(hand, { 0.0, 0.0, 0.2 });
  hand.Lead({ 0.0, 0.0, 5.0 });
  hand.Lead({ 0.0, 0.0, -1.0 });
  this->ExpectAt(hand, { 0.0, 0.0, 1.0 });
}

TEST_F(SurfaceMeshes, WhatItOverlapsDoesNotKeepItFromSliding)
{
  Hand hand(DescribeMesh(this->Volume, MakeFloor(200)), { 0.1, 0.2, 0.3 });
  hand.Lead({ 0.1, 0.2, -1.5 });
  hand.Lead({ 8.1, 3.2, -1.5 });
  this->ExpectAt(hand, { 8.1, 3.2, 0.3 });
}

TEST_F(SurfaceMeshes, NothingGetsThroughAtAnySpeed)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto point = [&](double reach) {
    return Vector3{ reach * any(random), reach * any(random), reach * any(random) };
  };
  for (const double friction : { 0.0, 0.4 })
  {
    Hand outside(
      DescribeMesh(this->Volume, MakeBall(20.0, 16, true), friction), { 0.0, 0.0, 40.0 });
    Hand inside(DescribeMesh(this->Volume, MakeCube(10.0), friction), {});
    for (int i = 0; i < 3000; ++i)
    {
      outside.Lead(point(30.0), 3.0); // 3 m/s
      ASSERT_GT(Norm(outside.Proxy()), 19.0) << i;
      inside.Lead(point(30.0), 60.0);
      ASSERT_LE(std::max({ std::abs(inside.Proxy().X), std::abs(inside.Proxy().Y),
                  std::abs(inside.Proxy().Z) }),
        9.0 + 1e-6)
        << i;
    }
  }
}

TEST_F(SurfaceMeshes, CracksNarrowerThanTheSphereAreNoWayThrough)
{
  const Corners points = { { -50, -50, 0 }, { 50, -50, 0 }, { 50, -0.6, 0 }, { -50, -0.6, 0 },
    { -50, 0.6, 0 }, { 50, 0.6, 0 }, { 50, 50, 0 }, { -50, 50, 0 } };
  const Faces faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } };
  const auto mesh = std::make_shared<SurfaceMesh>(points, faces, Corners{});
  Hand hand(DescribeMesh(this->Volume, mesh), { 0.0, 0.0, 5.0 });
  hand.Lead({ 0.0, 0.0, -6.0 });
  this->ExpectAt(hand, { 0.0, 0.0, 0.8 });
}

TEST_F(SurfaceMeshes, WithoutTrianglesNothingIsFelt)
{
  const auto flat = std::make_shared<SurfaceMesh>(
    Corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, Faces{ { 0, 1, 2 }, { 0, 0, 1 } }, Corners{});
  EXPECT_EQ(flat->GetNumberOfTriangles(), 0);
  Hand hand(DescribeMesh(this->Volume, flat), { 1.0, 0.0, 5.0 });
  hand.Lead({ 1.0, 0.0, -5.0 });
  EXPECT_EQ(Norm(hand.Record.Force), 0.0);
  EXPECT_LE(Norm(hand.Proxy() - hand.Tip), 1e-9);
}
