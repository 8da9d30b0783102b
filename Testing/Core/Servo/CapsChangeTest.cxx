// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a hand gains no energy when the caps of the stiffness change during contact.
 */

#include "Core/Servo/ServoTick.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
constexpr int Steps = 200;
constexpr double Depth = 2e-3; ///< m

/// Presses while the proxy stays in place, changes the stiffness cap from `before` to `after`, and
/// moves back. Returns the work (J) that the hand gets.
double Press(HapticSolver solver, double before, double after)
{
  const TestVolume volume = MakeRamp();
  HapticModelDescription description = Describe(volume);
  description.Settings.Solver = solver;
  description.Material.Stiffness = ConstantPolyline(1000.0);
  description.Material.Viscosity = ConstantPolyline(1e12); // holds the proxy in place
  const HapticModel bare(description);
  const HapticModel first(bare, description.DeviceToWorld, { before, 0.0 });
  const HapticModel second(bare, description.DeviceToWorld, { after, 0.0 });
  const Vector3 place{ 0.01, 0.01, 0.01 };
  ServoState state;
  TickRecord record;
  Tick(first, state, place, record);
  double work = 0.0;
  double force = 0.0;
  const auto move = [&](const HapticModel& model, int step)
  {
    const double x = Depth * step / Steps;
    const double dx = place.X + x - record.Tip.X;
    Tick(model, state, place + Vector3{ x, 0.0, 0.0 }, record);
    work += 0.5 * (force + record.Force.X) * dx;
    force = record.Force.X;
  };
  for (int i = 1; i <= Steps; ++i)
  {
    move(first, i);
  }
  const double pressed = force;
  EXPECT_NEAR(pressed, -before * Depth, 1e-9);
  CarryState(first, second, state);
  move(second, Steps);
  EXPECT_LE(std::abs(force), std::abs(pressed) * (1.0 + 1e-12)) << "no jump up";
  for (int i = Steps; i >= 0; --i)
  {
    move(second, i);
  }
  return work;
}
} // namespace

TEST(CapsChange, ALowerCapGivesNothingBack)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const double work = Press(solver, 500.0, 100.0);
    EXPECT_NEAR(work, -0.5 * 400.0 * Depth * Depth, 1e-5) << "of the difference, none comes back";
  }
}

TEST(CapsChange, AHigherCapGivesNothingToARestingHand)
{
  EXPECT_LE(Press(HapticSolver::Precise, 100.0, 500.0), 1e-12);
}
