// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Moves shaped tools through small volumes. Lengths are in millimetres unless stated otherwise. */
#ifndef ShellRig_h
#define ShellRig_h

#include "CoreScene.h"

#include "Core/Tools/PointShell/BakedShell.h"

#include <vector>

namespace coretest
{
constexpr double Pi = 3.14159265358979323846;
/// N/m^3, pressure per depth: the default stiffness of 500 N/m divided by the default area of 25
/// mm^2.
constexpr double Kappa = 2e7;

/// Returns points on a sphere around the origin that represent equal areas. They are on a spiral
/// with the golden angle.
inline std::vector<ShellPoint> MakeSphere(double radius, int count)
{
  std::vector<ShellPoint> points;
  const double area = 4.0 * Pi * radius * radius / count;
  const double golden = Pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt(1.0 - z * z);
    const Vector3 on{ r * std::cos(golden * i), r * std::sin(golden * i), z };
    points.push_back({ 1e-3 * radius * on, 1e-6 * area });
  }
  return points;
}

/// Returns a square of points around the origin, perpendicular to z.
inline std::vector<ShellPoint> MakeSquare(double side, int count)
{
  std::vector<ShellPoint> points;
  for (int i = 0; i < count * count; ++i)
  {
    const auto at = [&](int n) { return 1e-3 * side * ((n + 0.5) / count - 0.5); };
    points.push_back({ { at(i % count), at(i / count), 0.0 }, 1e-6 * side * side / count / count });
  }
  return points;
}

inline Quaternion TurnAbout(const Vector3& axis, double angle)
{
  const Vector3 half = (std::sin(0.5 * angle) / Norm(axis)) * axis;
  return { std::cos(0.5 * angle), half.X, half.Y, half.Z };
}

template <typename Engine>
Vector3 RandomIn(Engine& engine, double half)
{
  std::uniform_real_distribution<double> uniform(-half, half);
  const double x = uniform(engine);
  const double y = uniform(engine);
  return { x, y, uniform(engine) };
}

template <typename Engine>
Quaternion RandomTurn(Engine& engine)
{
  std::normal_distribution<double> normal;
  Quaternion q;
  for (double* number : { &q.W, &q.X, &q.Y, &q.Z })
  {
    *number = normal(engine);
  }
  return (1.0 / std::sqrt(SquaredNorm(q))) * q;
}

/// Returns a cube with the values V = 100 r, where r is the distance from its middle.
inline TestVolume MakeCavity(std::int64_t samples)
{
  TestVolume volume(ScalarType::Float64, { samples, samples, samples });
  const double middle = 0.5 * static_cast<double>(samples - 1);
  volume.Fill<double>(
    [middle](std::int64_t i, std::int64_t j, std::int64_t k) {
      return 100.0 * Norm(Vector3{ i - middle, j - middle, k - middle });
    });
  return volume;
}

/// A tool that a hand moves through a volume.
class ShellHand
{
public:
  ShellHand(const HapticModelDescription& description, std::vector<ShellPoint> points,
    const ShellSettings& settings)
    : Model(description)
    , Shell(std::move(points))
    , Settings(settings)
    , Memory(this->Shell)
  {
  }

  const ShellRecord& Tick(const Vector3& position, const Quaternion& turn = {})
  {
    return this->TickAt({ 0.001 * position, turn });
  }
  const ShellRecord& TickAt(const ShellPose& pose)
  {
    const ShellRecord last = this->Record;
    if (this->State.Enabled)
    {
      // Add the hand's work on the springs while the tool rests.
      this->Work += this->EnergyOfSprings(this->Record.Tool, pose) -
        this->EnergyOfSprings(this->Record.Tool, last.Hand);
    }
    TickShell(
      this->Model, this->Shell, this->Settings, pose, this->State, this->Memory, this->Record);
    const Vector3 mean = 0.5 * (last.Force + this->Record.Force);
    this->ForceWork -= Dot(mean, this->Record.Hand.Position - last.Hand.Position);
    return this->Record;
  }
  /// Moves the tool along a straight path, in steps of at most `step` (mm).
  const ShellRecord& Lead(const Vector3& goal, double step = 0.05, const Quaternion& turn = {})
  {
    const Vector3 from = 1000.0 * this->Record.Hand.Position;
    const double steps = std::ceil(Norm(goal - from) / step);
    for (double i = 1.0; i <= steps; i += 1.0)
    {
      this->Tick(from + (i / steps) * (goal - from), turn);
    }
    return this->Record;
  }
  const ShellRecord& Rest(int ticks = 50)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->TickAt(ShellPose(this->Record.Hand));
    }
    return this->Record;
  }
  /// Returns the energy (J) of the springs, computed independently from the angle between tool and
  /// hand.
  double EnergyOfSprings(const ShellPose& tool, const ShellPose& hand) const
  {
    const Vector3 lag = tool.Position - hand.Position;
    const Quaternion turn = tool.Orientation * Conjugate(hand.Orientation);
    const double half = std::acos(std::min(1.0, std::abs(turn.W)));
    return 0.5 * this->Settings.CouplingStiffness * Dot(lag, lag) +
      2.0 * this->Settings.TurningStiffness * std::pow(std::sin(half), 2);
  }

  const HapticModel Model;
  const PointShell Shell;
  const ShellSettings Settings;
  ShellMemory Memory;
  ShellState State;
  ShellRecord Record;
  double Work = 0.0; ///< J, work of the hand, computed as if the tool rested while the hand moves
  double ForceWork = 0.0; ///< J, work of the hand by the mean force of two ticks, without rotation
};
} // namespace coretest

#endif
