// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests invariants of every tick of solver PRECISE in unlikely scenes: more than 10^5 ticks of
 * random volumes, materials and walks, with jumps and excursions out of the volume.
 */

#include "RandomScene.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace reference;

namespace
{
constexpr int Scenes = 300;
constexpr int Ticks = 400;
// Rounding error of a force (N): positions of several hundred mm times several thousand N/m.
constexpr double Rounding = 1e-9;

/// Runs `check` on random scenes, half of which have a constant stiffness.
template <typename Check>
void OnRandomScenes(Check&& check)
{
  for (int seed = 0; seed < Scenes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene;
    Random random(20000 + seed);
    RandomScene(scene, random, seed % 3 ? Curves::Linear : Curves::Curved, Ticks);
    scene.method = Method::Proxy;
    scene.solver = Solver::Precise;
    if (seed % 2)
    {
      ConstantStiffness(scene, random);
    }
    check(scene, random);
  }
}

/// Returns whether the solver has reached the force of its spring. After a jump, this may take
/// several ticks.
bool IsThere(const Scene& scene, const TickRecord& tick)
{
  const Vec3 spring = tick.stiffness * scene.metersPerWorldUnit * (tick.proxy - tick.tip);
  return Norm(tick.force - spring) <= Rounding;
}

/// Returns the energy (J) of the spring.
double Energy(const Scene& scene, const TickRecord& tick)
{
  return 0.5 * Dot(tick.force, scene.metersPerWorldUnit * (tick.proxy - tick.tip));
}
} // namespace

TEST(PreciseProperties, ForcesAreFiniteAndWithinWhatTheMaterialHolds)
{
  int felt = 0;
  int ticks = 0;
  OnRandomScenes(
    [&](Scene& scene, Random&)
    {
      for (const TickRecord& tick : RunFilter(scene))
      {
        ASSERT_TRUE(std::isfinite(Norm(tick.force)) && std::isfinite(Norm(tick.proxy)));
        EXPECT_LE(tick.normalForce, tick.surfaceStrength + Rounding);
        EXPECT_LE(tick.frictionForce, tick.friction * tick.normalForce + Rounding);
        EXPECT_LE(tick.dragForce, tick.viscosity + Rounding);
        const double most = tick.surfaceStrength * std::hypot(1.0, tick.friction) + tick.viscosity;
        EXPECT_LE(Norm(tick.force), most + Rounding);
        EXPECT_NEAR(Norm(tick.normal), 1.0, 1e-12);
        felt += Norm(tick.force) > 0.01;
        ++ticks;
      }
    });
  EXPECT_GE(ticks, 100000);
  EXPECT_GT(felt, ticks / 10) << "the scenes are meant to be felt";
}

TEST(PreciseProperties, ARestingTipGainsNoEnergy)
{
  int held = 0;
  OnRandomScenes(
    [&](Scene& scene, Random&)
    {
      if (scene.estimator == Estimator::CentralDifference)
      {
        return; // its normals are not those of level sets
      }
      scene.path = WithStops(scene.path);
      const Trace trace = RunFilter(scene);
      // Tolerance of the solver: 2e-3 of a voxel, expressed as a length of the spring (m).
      double spacing[3];
      scene.image->GetSpacing(spacing);
      const double longest =
        2e-3 * scene.metersPerWorldUnit * std::max({ spacing[0], spacing[1], spacing[2] });
      double atRest = -1.0;
      for (std::size_t tick = 1; tick < trace.size(); ++tick)
      {
        const bool rests = Norm(trace[tick].tip - trace[tick - 1].tip) == 0.0;
        if (!rests || !IsThere(scene, trace[tick]))
        {
          atRest = -1.0;
          continue;
        }
        const double energy = Energy(scene, trace[tick]);
        if (atRest >= 0.0)
        {
          EXPECT_LE(energy, atRest + longest * Norm(trace[tick].force) + 1e-12) << "tick " << tick;
          held += energy > 1e-6;
        }
        atRest = atRest < 0.0 ? energy : std::min(energy, atRest);
      }
    });
  EXPECT_GT(held, Scenes) << "there must be energy to gain";
}

TEST(PreciseProperties, TheSameInputGivesTheSameBits)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    Scene scene;
    Random random(21000 + seed);
    RandomScene(scene, random, Curves::Linear, Ticks);
    scene.solver = Solver::Precise;
    const Trace first = RunFilter(scene);
    const Trace second = RunFilter(scene);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t tick = 0; tick < first.size(); ++tick)
    {
      ASSERT_EQ(Norm(first[tick].force - second[tick].force), 0.0);
      ASSERT_EQ(Norm(first[tick].proxy - second[tick].proxy), 0.0);
    }
  }
}
