// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the observer finds unstable loops and raises no false alarm for hands. The tests use
 * the theory of sampled springs (SampledLoop.h), and random sessions of an arm, a device and a
 * volume (ArmSessions.h).
 */

#include "Core/Safety/EnergyObserver.h"
#include "Core/Servo/SampledLoop.h"
#include "Rigs/ArmSessions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// An observer with a tip and a force that the test sets in each tick.
class Watched
{
public:
  /// Runs one tick of 1 ms. Returns whether the observer has found that the port gives energy.
  bool Step(const Vector3& tip, const Vector3& force)
  {
    this->IsFound = this->Observer.Observe(tip, 1e-3) || this->IsFound;
    this->Observer.RecordSent(force);
    return this->IsFound;
  }
  EnergyObserver Observer;
  bool IsFound = false;
};

/// Presses a tip 10 mm into a sampled spring of k (N/m) and lets the tip swing freely. Motion and
/// force are the exact solution. Returns whether the observer finds the swing.
bool SwingsFreely(double k, int delay, double swing)
{
  using namespace servotest;
  const Square loop = MakeLoop(k, delay);
  std::vector<double> state(loop.size(), 0.0);
  state[0] = swing;
  for (std::size_t i = 2; i < state.size(); ++i)
  {
    state[i] = -k * state[0];
  }
  constexpr double pressed = 10e-3;
  Watched watched;
  for (int i = 0; i < 2000 && std::abs(state[0]) < pressed; ++i)
  {
    watched.Step({ state[0], 0.0, 0.0 }, { -k * (state[0] - pressed), 0.0, 0.0 });
    std::vector<double> next(state.size(), 0.0);
    for (std::size_t row = 0; row < state.size(); ++row)
    {
      for (std::size_t column = 0; column < state.size(); ++column)
      {
        next[row] += loop[row][column] * state[column];
      }
    }
    state = next;
  }
  return watched.IsFound;
}
} // namespace

TEST(EnergyObserver, FindsWhatTheTheoryCallsUnstable)
{
  int unstable = 0;
  int stable = 0;
  for (const int delay : { 0, 1, 2, 3 })
  {
    for (double k = 300.0; k < 6000.0; k *= 1.2)
    {
      const double growth = servotest::SpectralRadius(servotest::MakeLoop(k, delay));
      const double rate = std::sqrt(k / servotest::Mass);
      // Factor by which the energy grows in a cycle.
      const double cycle = std::pow(growth, 2.0 * 2.0 * Pi / (rate * servotest::Period));
      const bool isQuick = rate > 2.0 * Pi * 1.1 / EnergyObserver::LongestCycle;
      // Skip larger growth, because the tip would leave the wall before the observer finds the
      // swing. The sessions in ArmSessions.h contain such walls, with a limited force.
      if (cycle > 1.01 && cycle < 2.0 && isQuick)
      {
        EXPECT_TRUE(SwingsFreely(k, delay, 3e-4)) << k << " N/m, delay " << delay;
        ++unstable;
      }
      else if (cycle < 0.97)
      {
        EXPECT_FALSE(SwingsFreely(k, delay, 5e-3)) << k << " N/m, delay " << delay;
        ++stable;
      }
    }
  }
  EXPECT_GT(unstable, 5);
  EXPECT_GT(stable, 3);
}

TEST(EnergyObserver, TellsTheEnergyOfAStretchedSpring)
{
  // Pressing a spring k by x in n steps takes the work k x^2 / 2, minus the work of half a step's
  // force.
  EnergyObserver observer;
  constexpr double k = 1000.0;
  constexpr int steps = 1000;
  constexpr double depth = 5e-3;
  for (int i = 0; i <= steps; ++i)
  {
    observer.Observe({ -depth * i / steps, 0.0, 0.0 }, 1e-3);
    observer.RecordSent({ k * depth * i / steps, 0.0, 0.0 });
  }
  EXPECT_NEAR(observer.GetEnergy(), -0.5 * k * depth * depth * (1.0 - 1.0 / steps), 1e-12);
}

TEST(EnergyObserver, FindsNoHandThatKeepsASwingGoing)
{
  // The hand taps a wall of 3000 N/m at 2 to 8 Hz, or presses with a tremor of 12 Hz and 1 mm.
  for (const double rate : { 2.0, 5.0, 8.0, 12.0 })
  {
    for (const double pressed : { 0.0, 2e-3 })
    {
      Watched watched;
      for (int i = 0; i < 10000; ++i)
      {
        const double x = pressed + (rate > 10.0 ? 1e-3 : 3e-3) * std::sin(2e-3 * Pi * rate * i);
        watched.Step({ -x, 0.0, 0.0 }, { 3000.0 * std::max(0.0, x), 0.0, 0.0 });
      }
      EXPECT_FALSE(watched.IsFound) << rate << " Hz";
    }
  }
}

TEST(EnergyObserver, FindsNoRippledSurface)
{
  // The hand strokes ripples with a length of 2 mm and a height of 0.1 mm at 0.2 m/s, and presses
  // with 2 N, so the tip swings at 100 Hz for seconds.
  Watched watched;
  for (int i = 0; i < 5000; ++i)
  {
    const double x = 0.2e-3 * i;
    const double turn = 2.0 * Pi / 2e-3;
    watched.Step(
      { x, 0.0, 2e-4 * std::sin(turn * x) }, { -2.0 * 2e-4 * turn * std::cos(turn * x), 0.0, 2.0 });
  }
  EXPECT_FALSE(watched.IsFound);
}

TEST(EnergyObserver, FindsNoFrictionAndNoStepsOfAnEncoder)
{
  // `rubbed`: the hand rubs at 25 Hz against friction. `still`: the tip rests, pressed by 8 N, but
  // its position jumps between two encoder steps.
  Watched rubbed;
  Watched still;
  double before = 0.0;
  for (int i = 0; i < 5000; ++i)
  {
    const double x = 1e-3 * std::sin(2e-3 * Pi * 25.0 * i);
    rubbed.Step({ x, 0.0, 0.0 }, { x > before ? -1.0 : 1.0, 0.0, 0.0 });
    before = x;
    still.Step({ i / 10 % 2 == 0 ? 0.0 : 6e-5, 0.0, 0.0 }, { 8.0, 0.0, 0.0 });
  }
  EXPECT_FALSE(rubbed.IsFound);
  EXPECT_FALSE(still.IsFound);
}

TEST(EnergyObserver, ExcusesWhatMovesTheForce)
{
  // The wall moves, and makes the tip swing at 20 Hz. With `isExcused`, a program publishes the
  // wall 30 times a second.
  for (const bool isExcused : { false, true })
  {
    Watched watched;
    for (int i = 0; i < 3000; ++i)
    {
      if (isExcused && i % 33 == 0)
      {
        watched.Observer.Excuse();
      }
      const double x = 2e-3 * std::sin(2e-3 * Pi * 20.0 * i);
      watched.Step({ -x, 0.0, 0.0 }, { 1000.0 * (0.005 + x), 0.0, 0.0 });
    }
    EXPECT_EQ(watched.IsFound, !isExcused);
  }
}

TEST(EnergyObserver, FindsNoHonestDevice)
{
  for (std::uint32_t seed = 0; seed < 150; ++seed)
  {
    const rigs::ArmResult result = rigs::ArmSession(rigs::ArmSession::DrawHonest(seed), seed).Run();
    EXPECT_FALSE(result.IsDamped) << seed;
    EXPECT_FALSE(result.IsCut) << seed;
  }
}

TEST(EnergyObserver, ABuzzingWallIsDampedUntilItRests)
{
  // With a mass of 100 g on a wall of 2000 N/m, the loop has a third of the damping that it needs.
  for (std::uint32_t seed = 0; seed < 10; ++seed)
  {
    rigs::ArmScene scene;
    scene.Mass = 0.1;
    scene.Stiffness = 2000.0;
    scene.Damping = 0.35;
    scene.IsHeld = false;
    scene.Weight = 3.0 + 0.05 * seed;
    scene.MaximumForce = 8.0;
    const rigs::ArmResult result = rigs::ArmSession(scene, seed).Run();
    EXPECT_TRUE(result.IsDamped) << seed;
    EXPECT_FALSE(result.IsCut) << seed;
    EXPECT_LT(result.GivenDamped, 0.02) << seed;
    EXPECT_LT(result.LastSwing, 2e-4) << seed;
  }
}

TEST(EnergyObserver, AWallThatBuzzesInSpiteOfDampingIsAFault)
{
  // The delay is three ticks longer, so that the added damping comes too late.
  int cut = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed)
  {
    rigs::ArmScene scene;
    scene.Mass = 0.05;
    scene.Stiffness = 5000.0;
    scene.Damping = 9.0;
    scene.Delay = 3;
    scene.IsHeld = false;
    scene.Weight = 1.0 + 0.05 * seed;
    scene.MaximumForce = 8.0;
    scene.Seconds = 4.0;
    const rigs::ArmResult result = rigs::ArmSession(scene, seed).Run();
    EXPECT_TRUE(result.IsDamped || !result.IsCut) << seed;
    cut += result.IsCut ? 1 : 0;
  }
  EXPECT_GE(cut, 8);
}
