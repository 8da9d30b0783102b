// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Makes a ball in a volume, a model of the whole volume, and models of regions that contain no
 * other samples.
 */
#ifndef RegionRig_h
#define RegionRig_h

#include "Core/Safety/ForceGate.h"
#include "Core/Servo/ResidentServo.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

namespace servotest
{
using namespace coretest;

inline constexpr std::int64_t Samples = 72;

/// Returns a ball with a surface of 24 mm radius, an edge `width` mm wide, and slight bumps.
inline TestVolume MakeBall(double width)
{
  TestVolume volume(ScalarType::Float32, { Samples, Samples, Samples });
  volume.Fill<float>(
    [width](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const double x = i - 35.3, y = 0.9 * (j - 36.1), z = 1.1 * (k - 35.8);
      const double r = std::sqrt(x * x + y * y + z * z);
      return static_cast<float>(
        1000.0 / (1.0 + std::exp((r - 24.0) / width)) + 20.0 * std::sin(0.7 * i + 0.4 * k));
    });
  return volume;
}

inline const TestVolume& Ball()
{
  static const TestVolume ball = MakeBall(1.0);
  return ball;
}

inline HapticModelDescription DescribeBall(
  HapticMethod method, HapticSolver solver, MaterialPlacement placement)
{
  HapticModelDescription d = Describe(Ball());
  d.IndexToWorld.Linear =
    Matrix3::FromColumns({ 1.0, 0.0, 0.0 }, { 0.0, 0.9, 0.0 }, { 0.0, 0.0, 1.1 });
  d.IndexToWorld.Offset = { -35.3, -0.9 * 36.1, -1.1 * 35.8 };
  d.Settings.Method = method;
  d.Settings.Solver = solver;
  d.Settings.Placement = placement;
  d.Settings.IsoValue = 500.0;
  d.Settings.HasIsoSurface = method == HapticMethod::LocalSurface;
  d.Settings.ForceFieldGain = 0.01;
  d.Settings.ForceFieldDamping = 1.0;
  d.Material.Stiffness = { { 0.0, 400.0 }, { 1000.0, 600.0 } };
  d.Material.Friction = ConstantPolyline(0.25);
  d.Material.Viscosity = ConstantPolyline(0.05);
  d.Material.SurfaceStrength = ConstantPolyline(0.9);
  return d;
}

using Index = std::array<std::int64_t, 3>;

/// Describes only the region of the ball's samples from `first` to `last`.
inline HapticModelDescription Crop(
  HapticModelDescription d, Index first, Index last, const TestVolume& ball = Ball())
{
  Index size;
  for (int a = 0; a < 3; ++a)
  {
    first[a] = std::clamp<std::int64_t>(first[a], 0, Samples - 1);
    last[a] = std::clamp<std::int64_t>(last[a], 0, Samples - 1);
    size[a] = last[a] - first[a] + 1;
  }
  const auto part = std::make_shared<TestVolume>(ScalarType::Float32, size);
  part->Fill<float>([&](std::int64_t i, std::int64_t j, std::int64_t k)
    { return static_cast<float>(ball(first[0] + i, first[1] + j, first[2] + k)); });
  d.View = part->View;
  d.Samples = part;
  for (int a = 0; a < 3; ++a)
  {
    d.View.First[a] = first[a];
    d.View.Whole[a] = Samples;
  }
  return d;
}

/// Describes the region that reaches `half` voxels to each side of a tip (m).
inline HapticModelDescription CropAround(
  const HapticModelDescription& whole, const Vector3& tip, std::int64_t half)
{
  const Vector3 at = Inverse(whole.IndexToWorld)(whole.DeviceToWorld(tip));
  const Index middle = { std::llround(at.X), std::llround(at.Y), std::llround(at.Z) };
  return Crop(whole, { middle[0] - half, middle[1] - half, middle[2] - half },
    { middle[0] + half, middle[1] + half, middle[2] + half });
}

/// Returns the tip (m) at a tick. The tip slides over the ball at 0.1 m/s and moves in and out, so
/// that the proxy is held, slides and goes through the surface.
inline Vector3 TipOf(int tick)
{
  const double angle = 0.004 * tick;
  const double depth = 2.0 * std::sin(0.013 * tick) + 0.6;
  const double r = 24.0 - depth;
  return 1e-3 *
    Vector3{ r * std::cos(angle), 0.6 * r * std::sin(angle), 0.8 * r * std::sin(angle) };
}

inline bool IsSame(const Vector3& a, const Vector3& b)
{
  return a.X == b.X && a.Y == b.Y && a.Z == b.Z;
}

struct MethodCase
{
  const char* Name;
  HapticMethod Method;
  HapticSolver Solver;
  MaterialPlacement Placement = MaterialPlacement::Kernel;
};
inline constexpr MethodCase MethodCases[] = {
  { "Precise", HapticMethod::Proxy, HapticSolver::Precise },
  { "FarSide", HapticMethod::Proxy, HapticSolver::Precise, MaterialPlacement::FarSide },
  { "Paper", HapticMethod::Proxy, HapticSolver::Paper },
  { "ForceField", HapticMethod::ForceField, HapticSolver::Precise },
  { "LocalSurface", HapticMethod::LocalSurface, HapticSolver::Precise },
};
inline std::string NameOf(const testing::TestParamInfo<MethodCase>& info)
{
  return info.param.Name;
}
} // namespace servotest

#endif
