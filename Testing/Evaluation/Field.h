// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Analytic fields, sampled to volumes that can be touched. Lengths are in millimetres, which are
 * the world units.
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

/** A scalar function of the position (mm). */
using Field = std::function<double(const Vector3&)>;

/** How a field is sampled. The samples form a cube around the origin. */
struct Sampling
{
  double HalfSize = 24.0;              ///< mm: half of the cube's edge
  Vector3 Spacing = { 1.0, 1.0, 1.0 }; ///< mm
  VolumeHaptics::ScalarType Type = VolumeHaptics::ScalarType::Float64;
  double Noise = 0.0; ///< standard deviation of the noise
  unsigned Seed = 1;
  bool IsTurned = false; ///< rotated by an arbitrary angle about a centre off the grid
};

/** Material, solver and settings. The defaults are those of the closed forms. */
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

/** Returns a material whose functions are constant. */
VolumeHaptics::HapticMaterial MakeMaterial(double stiffness = 500.0, double friction = 0.0,
  double viscosity = 0.0, double surfaceStrength = 2.0, double distinctness = 1.0);

/** Surface strength (N) that no hand exceeds. */
constexpr double Impenetrable = 1e9;

/** The samples of a field. Integer types are rounded and saturated. */
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

/** Tip positions (mm), one for each tick. */
using Path = std::vector<Vector3>;
using Trace = std::vector<VolumeHaptics::TickRecord>;

/** Appends points towards a goal, `step` (mm) apart; the last point is exactly the goal. */
void MoveTo(Path& path, const Vector3& goal, double step);

/** Runs a tick for each position of a path; 1 mm of the path is 1 mm of the hand. */
Trace Play(const VolumeHaptics::HapticModel& model, const Path& path);

/** Returns the tick's proxy (mm). */
inline Vector3 ProxyOf(const VolumeHaptics::TickRecord& tick)
{
  return 1000.0 * tick.Proxy;
}

} // namespace evaluation

#endif
