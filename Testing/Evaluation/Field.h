// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Analytic fields, sampled to volumes that can be touched. Lengths are millimetres, which are world
 * units.
 */
#ifndef Evaluation_Field_h
#define Evaluation_Field_h

#include "Core/Servo/ServoTick.h"

#include <functional>
#include <memory>
#include <vector>

namespace evaluation
{
using VolumeHaptics::Vector3;

/** A scalar at a position (mm). */
using Field = std::function<double(const Vector3&)>;

/** How a field is sampled, around the origin. */
struct Sampling
{
  double HalfSize = 24.0;              ///< mm, of a cube
  Vector3 Spacing = { 1.0, 1.0, 1.0 }; ///< mm
  VolumeHaptics::ScalarType Type = VolumeHaptics::ScalarType::Float64;
  double Noise = 0.0; ///< standard deviation
  unsigned Seed = 1;
  bool IsTurned = false; ///< by an odd rotation, about an odd centre
};

/** The material and the solver; the defaults are those of the closed forms. */
struct Touching
{
  VolumeHaptics::HapticSolver Solver = VolumeHaptics::HapticSolver::Precise;
  VolumeHaptics::ContactAlignment Alignment = VolumeHaptics::ContactAlignment::Edge;
  VolumeHaptics::MaterialPlacement Placement = VolumeHaptics::MaterialPlacement::FarSide;
  VolumeHaptics::SurfaceSide Side = VolumeHaptics::SurfaceSide::Higher;
  VolumeHaptics::GradientEstimator Estimator = VolumeHaptics::GradientEstimator::Gaussian;
  int KernelRadius = 2;
  VolumeHaptics::HapticMaterial Material;
  double ReleaseTime = VolumeHaptics::HapticSettings{}.ReleaseTime; ///< s
};

/** Constant material functions. */
VolumeHaptics::HapticMaterial MakeMaterial(double stiffness = 500.0, double friction = 0.0,
  double viscosity = 0.0, double surfaceStrength = 2.0, double distinctness = 1.0);

/** No hand breaks it (N). */
constexpr double Impenetrable = 1e9;

/** The samples of a field. Integer types round and saturate. */
class Volume
{
public:
  Volume(const Field& field, const Sampling& sampling);

  VolumeHaptics::HapticModelDescription Describe(const Touching& touching) const;
  std::unique_ptr<VolumeHaptics::HapticModel> Bake(const Touching& touching) const;

private:
  std::shared_ptr<std::vector<char>> Samples;
  VolumeHaptics::VolumeView View;
  VolumeHaptics::Affine3 IndexToWorld;
};

/** Tip positions (mm), one a tick. */
using Path = std::vector<Vector3>;
using Trace = std::vector<VolumeHaptics::TickRecord>;

/** Appends points on the way to a goal, `step` (mm) apart; the last one is exactly the goal. */
void MoveTo(Path& path, const Vector3& goal, double step);

/** Ticks along a path, life-size. */
Trace Play(const VolumeHaptics::HapticModel& model, const Path& path);

/** The tick's proxy in mm. */
inline Vector3 ProxyOf(const VolumeHaptics::TickRecord& tick)
{
  return 1000.0 * tick.Proxy;
}

} // namespace evaluation

#endif
