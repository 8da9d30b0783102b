// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The invariants of every tick in any scene, by the module's own trace arrays.
 */

#include "CompareTraces.h"
#include "RandomScene.h"

#include <gtest/gtest.h>
#include <vtkPiecewiseFunction.h>

using namespace reference;

namespace
{
constexpr int Scenes = 80;
constexpr int Ticks = 150;

// The rounding error of a force: positions of some hundred mm, some thousand N/m.
constexpr double Rounding = 1e-10;

template <typename Check>
void OnRandomScenes(int firstSeed, Check&& check)
{
  for (int seed = firstSeed; seed < firstSeed + Scenes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Scene scene;
    Random random(seed);
    RandomScene(scene, random, seed % 2 ? Curves::Linear : Curves::Curved, Ticks);
    check(scene, random);
  }
}
} // namespace

TEST(Invariants, ForcesStayWithinTheMaterialsThresholds)
{
  int inContact = 0;
  OnRandomScenes(3000,
    [&](Scene& scene, Random&)
    {
      for (const TickRecord& tick : RunFilter(scene))
      {
        EXPECT_LE(tick.normalForce, tick.surfaceStrength + Rounding);
        EXPECT_LE(tick.frictionForce, tick.friction * tick.normalForce + Rounding);
        EXPECT_LE(tick.dragForce, tick.viscosity + Rounding);
        const double most = tick.surfaceStrength * std::hypot(1.0, tick.friction) + tick.viscosity;
        EXPECT_LE(Norm(tick.force), most + Rounding);
        EXPECT_NEAR(Norm(tick.normal), 1.0, 1e-12);
        inContact += tick.contact != 0;
      }
    });
  EXPECT_GT(inContact, Scenes * Ticks / 10) << "the scenes are meant to be felt";
}

TEST(Invariants, TheForceIsTheSpringBetweenProxyAndTip)
{
  OnRandomScenes(3000,
    [&](Scene& scene, Random&)
    {
      for (const TickRecord& tick : RunFilter(scene))
      {
        const double springRate = tick.stiffness * scene.metersPerWorldUnit;
        const Vec3 spring = springRate * (tick.proxy - tick.tip);
        EXPECT_LE(Norm(tick.force - spring), Rounding);
      }
    });
}

TEST(Invariants, NothingIsFeltWithoutStrengthAndViscosity)
{
  int empty = 0;
  OnRandomScenes(5000,
    [&](Scene& scene, Random& random)
    {
      double range[2];
      scene.property->GetSurfaceStrength()->GetRange(range);
      const double middle = random.Uniform(range[0], range[1] + 1.0);
      for (vtkPiecewiseFunction* function :
        { scene.property->GetSurfaceStrength(), scene.property->GetViscosity() })
      {
        function->RemoveAllPoints();
        function->AddPoint(middle, 0.0);
        function->AddPoint(middle + 50.0, 1.0);
      }
      for (const TickRecord& tick : RunFilter(scene))
      {
        if (tick.surfaceStrength == 0.0 && tick.viscosity == 0.0)
        {
          // Not bit for bit: the specification's proxy gets to the tip by two moves that round.
          EXPECT_LE(Norm(tick.force), Rounding);
          EXPECT_LE(Norm(tick.proxy - tick.tip), 1e-10);
          EXPECT_EQ(tick.contact, 0);
          ++empty;
        }
      }
    });
  EXPECT_GT(empty, Scenes);
}

TEST(Invariants, TheSameSceneGivesTheSameBits)
{
  OnRandomScenes(6000,
    [&](Scene& scene, Random&)
    {
      const Difference difference = CompareTraces(RunFilter(scene), RunFilter(scene));
      EXPECT_EQ(difference.worst, 0.0) << difference.text;
    });
}
