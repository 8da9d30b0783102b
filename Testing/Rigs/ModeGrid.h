// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A sampled field with one mode, and the proxy that the mode guides.
 */
#ifndef ModeGrid_h
#define ModeGrid_h

#include "Core/Solvers/Primitives/ModePrimitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace modegrid
{
using namespace VolumeHaptics;

inline constexpr double CouplingOf = 500.0; // N/m, coupling stiffness
inline const double HalfTurn = std::acos(-1.0);

/// A field on a grid with the spacing h (mm), centred at the world's origin.
class ModeGrid
{
public:
  template <typename F>
  ModeGrid(int nx, int ny, int nz, double h, int components, F&& f)
    : Samples(static_cast<std::size_t>(nx) * ny * nz * components)
    , QuarterVoxel(0.25e-3 * h)
  {
    this->Mode.View.Volume.Data = this->Samples.data();
    const std::int64_t n[3] = { nx, ny, nz };
    std::int64_t stride = components;
    for (int a = 0; a < 3; ++a)
    {
      this->Mode.View.Volume.Dimensions[a] = n[a];
      this->Mode.View.Volume.Stride[a] = stride;
      stride *= n[a];
    }
    this->Mode.View.Components = components;
    this->IndexToWorld = { h * Matrix3{},
      { -0.5 * h * (nx - 1), -0.5 * h * (ny - 1), -0.5 * h * (nz - 1) } };
    double* to = this->Samples.data();
    for (int k = 0; k < nz; ++k)
    {
      for (int j = 0; j < ny; ++j)
      {
        for (int i = 0; i < nx; ++i, to += components)
        {
          f(this->IndexToWorld({ double(i), double(j), double(k) }), to);
        }
      }
    }
  }

  /// Bakes a model with one mode, in a world of millimetres.
  void Bake(ModeKind kind, const Polyline& first, const Polyline& second = ConstantPolyline(0.0))
  {
    this->Mode.Kind = kind;
    this->Mode.First = first;
    this->Mode.Second = second;
    this->Baked = std::make_unique<BakedMode>(this->Mode, this->IndexToWorld);
    this->Field = std::make_unique<ModeField>(this->IndexToWorld, this->DeviceToWorld);
    ASSERT_TRUE(this->Field->Add(*this->Baked));
    this->Motion = {};
    this->Memory = {};
  }

  /// Returns the set of primitives at a position (mm).
  PrimitiveSet At(const Vector3& place) const
  {
    PrimitiveSet set;
    const PrimitiveField field = this->Field->GetField();
    field.Collect(field.Context, 1e-3 * place, set);
    return set;
  }

  /// Runs a tick with the tip at a position (mm).
  void Move(const Vector3& tip)
  {
    this->Motion = SolvePrimitives(this->Field->GetField(), CouplingOf, this->QuarterVoxel,
      this->Motion.Proxy, 1e-3 * tip, this->Memory);
    const double force = Norm(this->Motion.Force);
    if (force > this->At(1e3 * this->Motion.Proxy).SumStrengths())
    {
      EXPECT_LE(force, this->ComputeStrengths());
    }
  }
  void StartAt(const Vector3& place) { this->Motion.Proxy = 1e-3 * place; }

  /// Returns the largest total strength (N) of the primitives near the proxy, computed at the
  /// corners of a cube around it. The cube's size is the unfinished part of a step, by which the
  /// proxy may be ahead of its force.
  double ComputeStrengths() const
  {
    const double part = PrimitiveFollower::FinishedFraction * this->QuarterVoxel;
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 beside{ corner & 1 ? part : -part, corner & 2 ? part : -part,
        corner & 4 ? part : -part };
      most = std::max(most, this->At(1e3 * (this->Motion.Proxy + beside)).SumStrengths());
    }
    return most + 1e-9;
  }

  std::vector<double> Samples;
  double QuarterVoxel;
  ModeDescription Mode;
  Affine3 IndexToWorld;
  Affine3 DeviceToWorld{ 1000.0 * Matrix3{}, {} };
  std::unique_ptr<BakedMode> Baked;
  std::unique_ptr<ModeField> Field;
  PrimitiveMotion Motion;
  PrimitiveMemory Memory;
};

} // namespace modegrid

#endif
