// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares pose, force and torque of random tools in random poses on a ball with the pose of least
 * energy. The search for this pose uses the ball's exact distance and no derivatives.
 */

#include "Rigs/ShellRig.h"

#include <gtest/gtest.h>

#include <array>

using namespace coretest;

namespace
{
constexpr double BallRadius = 20.0;
const Vector3 BallMiddle{ 31.5, 31.5, 31.5 };

/// Energy (J) of springs and contacts as a function of the tool's lag (three lengths in m, three
/// angles in rad).
class SlowShell
{
public:
  SlowShell(const std::vector<ShellPoint>& points, const ShellPose& hand, double strength)
    : Points(points)
    , Hand(hand)
    , Strength(strength)
  {
  }

  using Lag = std::array<double, 6>;

  double Energy(const Lag& lag) const
  {
    const Vector3 turn{ lag[3], lag[4], lag[5] };
    const double angle = Norm(turn);
    const Quaternion turned =
      angle > 0.0 ? TurnAbout(turn, angle) * this->Hand.Orientation : this->Hand.Orientation;
    const Matrix3 matrix = ToMatrix(turned);
    const Vector3 position = this->Hand.Position + Vector3{ lag[0], lag[1], lag[2] };
    double energy = 250.0 * (lag[0] * lag[0] + lag[1] * lag[1] + lag[2] * lag[2]) +
      2.0 * 0.5 * std::pow(std::sin(0.5 * angle), 2);
    for (const ShellPoint& point : this->Points)
    {
      const Vector3 at = matrix * point.Position + position;
      const double depth = 0.001 * BallRadius - Norm(at - 0.001 * BallMiddle);
      const double most = this->Strength / Kappa;
      if (depth > 0.0)
      {
        energy += point.Area *
          (depth < most ? 0.5 * Kappa * depth * depth : this->Strength * (depth - 0.5 * most));
      }
    }
    return energy;
  }

  /// Searches for the minimum by the pattern search of Hooke and Jeeves.
  Lag FindLeast() const
  {
    Lag base{};
    double least = this->Energy(base);
    for (double step = 1.0; step > 1e-6;)
    {
      Lag found = base;
      double energy = this->Explore(found, least, step);
      if (!(energy < least))
      {
        step *= 0.5;
        continue;
      }
      while (energy < least)
      {
        // Continue in the direction from the last base, and search around that point.
        Lag beyond;
        for (int i = 0; i < 6; ++i)
        {
          beyond[i] = 2.0 * found[i] - base[i];
        }
        base = found;
        least = energy;
        found = beyond;
        energy = this->Explore(found, this->Energy(beyond), step);
      }
    }
    return base;
  }

private:
  /// Moves by a step along each axis if this lowers the energy. Returns the energy.
  double Explore(Lag& at, double energy, double step) const
  {
    for (int i = 0; i < 6; ++i)
    {
      for (const double sign : { 1.0, -1.0 })
      {
        Lag tried = at;
        tried[i] += sign * step * (i < 3 ? 1e-4 : 1e-2);
        const double other = this->Energy(tried);
        if (other < energy)
        {
          energy = other;
          at = tried;
          break;
        }
      }
    }
    return energy;
  }

  const std::vector<ShellPoint>& Points;
  ShellPose Hand;
  double Strength;
};
} // namespace

TEST(ShellReference, RandomToolsOnABall)
{
  // Between samples h apart, the level of a ball of radius r is h^2/(6 r) too deep on average, so
  // the voxels must be fine.
  constexpr double h = 0.5;
  TestVolume volume(ScalarType::Float32, { 127, 127, 127 });
  volume.Fill<float>(
    [](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const Vector3 at = h * Vector3{ double(i), double(j), double(k) };
      return 100.0 * (BallRadius - Norm(at - BallMiddle));
    });
  HapticModelDescription scene = Describe(volume);
  scene.IndexToWorld.Linear = h * Matrix3{};
  ShellSettings settings;
  std::mt19937_64 engine(31);
  double worstForce = 0.0;
  double worstTorque = 0.0;
  int compared = 0;
  for (int i = 0; i < 24; ++i)
  {
    // In every third case, the tissue yields at 0.25 N per 25 mm^2.
    const double strength = i % 3 == 0 ? 0.25 : 2.0;
    scene.Material.SurfaceStrength = ConstantPolyline(strength);
    std::vector<ShellPoint> points = MakeSphere(1.0, 120);
    const Vector3 axes = Vector3{ 4.5, 4.5, 4.5 } + RandomIn(engine, 2.5);
    const Vector3 offset = RandomIn(engine, 2e-3);
    for (ShellPoint& point : points)
    {
      const Vector3& on = point.Position;
      point.Position = Vector3{ axes.X * on.X, axes.Y * on.Y, axes.Z * on.Z } + offset;
      point.Area = 1e-6 * std::uniform_real_distribution<double>(0.5, 3.0)(engine);
    }
    const Vector3 direction = RandomIn(engine, 1.0);
    const Vector3 away = (1.0 / Norm(direction)) * direction;
    const Quaternion turn = RandomTurn(engine);
    ShellHand hand(scene, points, settings);
    // The tool is some 10 mm long. Lead it from outside until a part of it is in the ball.
    hand.Tick(BallMiddle + 31.0 * away, turn);
    const auto lead = [&](double to)
    {
      for (double r = 31.0; r > to; r -= 0.03)
      {
        hand.Tick(BallMiddle + r * away, turn);
      }
      return hand.Rest(300);
    };
    const ShellRecord record = lead(std::uniform_real_distribution<double>(20.5, 23.5)(engine));
    const SlowShell slow(points, record.Hand, strength / 2.5e-5);
    const auto lag = slow.FindLeast();
    const Vector3 force = 500.0 * Vector3{ lag[0], lag[1], lag[2] };
    const Vector3 turned{ lag[3], lag[4], lag[5] };
    const double angle = Norm(turned);
    const Vector3 torque = angle > 0.0 ? (0.5 * std::sin(angle) / angle) * turned : Vector3{};
    const double size = Norm(force);
    if (size < 0.1)
    {
      continue; // hardly in contact
    }
    ++compared;
    worstForce = std::max(worstForce, Norm(record.Force - force) / size);
    worstTorque = std::max(worstTorque, Norm(record.Torque - torque) / (size * 5e-3));
  }
  EXPECT_GE(compared, 18);
  EXPECT_LE(worstForce, 0.01);
  EXPECT_LE(worstTorque, 0.01);
}
