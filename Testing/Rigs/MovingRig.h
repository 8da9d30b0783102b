// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a pulsating ball and an approaching wall in time steps, and a resting hand.
 */
#ifndef MovingRig_h
#define MovingRig_h

#include "Core/Model/HapticModel.h"
#include "Rigs/CoreScene.h"

#include <array>
#include <cmath>
#include <functional>
#include <list>
#include <vector>

namespace movingtest
{
using namespace coretest;

inline constexpr double Pi = 3.14159265358979323846;
inline constexpr double K = 500.0;    // N/m, coupling stiffness
inline constexpr double Width = 1.5;  // mm, width of the edges
inline constexpr double Period = 1.0; // s, period of the ball
inline constexpr double Dt = 1e-3;    // s, duration of a tick

/// A function that returns the position (mm along x) of a surface at a time (s).
using Place = std::function<double(double)>;

inline double BallRadius(double t)
{
  return 20.0 + 2.0 * std::sin(2.0 * Pi * t / Period);
}

/// The time steps of a volume that is 25 mm long along x and begins at x = `from` (mm). For voxels
/// of 1 mm, it has 26 x 25 x 25 samples; for voxels of another size (mm), the number along x
/// changes.
class Movie
{
public:
  using Value = std::function<double(double x, double y, double z, double t)>;

  Movie(const Value& value, double from, double end, double step, double voxel = 1.0)
    : Voxel(voxel)
    , From(from)
  {
    const std::int64_t along = std::lround(25.0 / voxel) + 1;
    for (int i = 0; i * step < end + 0.5 * step; ++i)
    {
      const double t = i * step;
      TestVolume& timeStep = this->Volumes.emplace_back(
        ScalarType::Float64, std::array<std::int64_t, 3>{ along, 25, 25 });
      timeStep.Fill<double>(
        [&](std::int64_t x, std::int64_t y, std::int64_t z)
        {
          return value(from + voxel * static_cast<double>(x),
            voxel * (static_cast<double>(y) - 12.0), voxel * (static_cast<double>(z) - 12.0), t);
        });
      this->TimeSteps.push_back({ t, timeStep.View, nullptr });
    }
  }

  HapticModelDescription Describe() const
  {
    HapticModelDescription description = coretest::Describe(this->Volumes.front());
    description.TimeSteps = this->TimeSteps;
    description.IndexToWorld.Linear = this->Voxel * Matrix3{};
    description.IndexToWorld.Offset = { this->From, -12.0 * this->Voxel, -12.0 * this->Voxel };
    description.Material.Stiffness = ConstantPolyline(K);
    description.Settings.Placement = MaterialPlacement::Kernel;
    description.Settings.Alignment = ContactAlignment::Edge;
    return description;
  }

private:
  const double Voxel;
  const double From;
  std::list<TestVolume> Volumes;
  std::vector<VolumeTimeStep> TimeSteps;
};

inline Movie MakeBall(double step, double voxel = 1.0)
{
  return { [](double x, double y, double z, double t)
    {
      const double rho = std::sqrt(x * x + y * y + z * z);
      return 500.0 * (1.0 - std::tanh((rho - BallRadius(t)) / Width));
    },
    6.0, 2.0, step, voxel };
}

/// Returns a wall on the side of lower x, whose surface moves along x.
inline Movie MakeWall(const Place& at, double step, double voxel = 1.0)
{
  return { [at](double x, double, double, double t)
    { return 500.0 * (1.0 - std::tanh((x - at(t)) / Width)); },
    6.0, 2.0, step, voxel };
}

/// A hand that moves straight to a position on the x axis at a constant data time, and then rests
/// there.
class RestingHand
{
public:
  RestingHand(const HapticModelDescription& description, double from, double to)
    : Model(description)
    , At{ 0.001 * to, 0.0, 0.0 }
  {
    const int ticks = static_cast<int>(std::abs(from - to) / 0.01);
    for (int i = 0; i <= ticks; ++i)
    {
      this->Touch({ 0.001 * (from + (to - from) * i / std::max(1, ticks)), 0.0, 0.0 });
    }
  }

  /// Runs a tick at a data time (s).
  const TickRecord& Go(double time)
  {
    this->State.DataTime = time;
    return this->Touch(this->At);
  }

  const TickRecord& Touch(const Vector3& tip)
  {
    VolumeHaptics::Tick(this->Model, this->State, tip, this->Record);
    return this->Record;
  }

  const HapticModel Model;
  const Vector3 At;
  ServoState State;
  TickRecord Record;
};

inline HapticModelDescription WithStrength(HapticModelDescription description, double strength)
{
  description.Material.SurfaceStrength = ConstantPolyline(strength);
  return description;
}

/// Selects the spline as gradient estimator. Its blur moves a ball's surface by 0.016 mm, compared
/// with 0.03 mm for the Gaussian (see the evaluation).
inline HapticModelDescription WithSpline(HapticModelDescription description)
{
  description.Estimator = GradientEstimator::CubicBSpline;
  return description;
}

} // namespace movingtest

#endif
