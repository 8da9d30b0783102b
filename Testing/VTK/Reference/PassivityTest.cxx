// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a resting hand gains no energy from the volume: 1/2 k |d|^2 must never increase. */

#include "RandomScene.h"

#include <gtest/gtest.h>

using namespace reference;

namespace
{
constexpr double Rounding = 1e-10; // N, rounding error of a force
} // namespace

TEST(Passivity, AStaticTipNeverGainsEnergy)
{
  const int scenes = 120;
  int held = 0;
  for (int seed = 0; seed < scenes; ++seed)
  {
    Scene scene;
    Random random(4000 + seed);
    RandomScene(scene, random, seed % 2 ? Curves::Linear : Curves::Curved, 150);
    ConstantStiffness(scene, random);
    scene.path = WithStops(scene.path);
    const Trace trace = RunFilter(scene);
    for (std::size_t tick = 1; tick < trace.size(); ++tick)
    {
      if (Norm(trace[tick].tip - trace[tick - 1].tip) == 0.0)
      {
        // The stiffness is constant, so the energy is |f|^2 / 2k, and the force must not increase.
        const double before = Norm(trace[tick - 1].force);
        EXPECT_LE(Norm(trace[tick].force), before + Rounding)
          << "seed " << seed << " tick " << tick;
        held += before > 0.01;
      }
    }
  }
  EXPECT_GT(held, 10 * scenes) << "there must be energy to gain";
}
