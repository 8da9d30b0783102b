// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A hand that holds still gets no energy from the volume, and gives none: 1/2 k |d|^2 never rises.
 */

#include "RandomScene.h"

#include <gtest/gtest.h>
#include <vtkPiecewiseFunction.h>

using namespace reference;

namespace
{
constexpr double Rounding = 1e-10; // N

// A walk that stops for 20 ticks at every 30th.
std::vector<Vec3> WithStops(const std::vector<Vec3>& path)
{
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    result.insert(result.end(), i % 30 == 29 ? 20 : 1, path[i]);
  }
  return result;
}
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
    vtkPiecewiseFunction* stiffness = scene.property->GetStiffness();
    stiffness->RemoveAllPoints();
    stiffness->AddPoint(0.0, random.Uniform(50.0, 2000.0));
    scene.path = WithStops(scene.path);
    const Trace trace = RunFilter(scene);
    for (std::size_t tick = 1; tick < trace.size(); ++tick)
    {
      if (Norm(trace[tick].tip - trace[tick - 1].tip) == 0.0)
      {
        // The stiffness is constant, so the force stands for the energy |f|^2 / 2k.
        const double before = Norm(trace[tick - 1].force);
        EXPECT_LE(Norm(trace[tick].force), before + Rounding)
          << "seed " << seed << " tick " << tick;
        held += before > 0.01;
      }
    }
  }
  EXPECT_GT(held, 10 * scenes) << "there must be energy to gain";
}
