// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The paper's law as primitives, on both roads, against the law that the solvers use and against
 * the ticks of PAPER.
 */

#include "Core/Solvers/MaterialLaw.h"
#include "Core/Solvers/Primitives/MaterialPrimitives.h"
#include "Core/Solvers/Primitives/PrimitiveSolver.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

using namespace coretest;

namespace
{
struct LawForces
{
  Vector3 Composed;
  Vector3 Descended;
};

LawForces ForcesOf(const MaterialPoint& point, double k, const Vector3& proxy, const Vector3& tip)
{
  PrimitiveSet set;
  AddMaterial(point, k, proxy, tip, set);
  PrimitiveForces forces{};
  PrimitiveBalance composed;
  PrimitiveBalance descended;
  EXPECT_TRUE(PrimitiveSolver::Compose(set, k, tip, forces, composed));
  PrimitiveSolver::Descend(set, k, tip, forces, descended);
  return { composed.Force, descended.Force };
}
} // namespace

TEST(PrimitivesLaw, IsThatOfTheSolvers)
{
  Wanderer dice(1.0, 11);
  const auto between = [&](double low, double high) { return low + (high - low) * dice.Uniform(); };
  double worst = 0.0;
  int slid = 0;
  int through = 0;
  for (int round = 0; round < 20000; ++round)
  {
    MaterialPoint point;
    Vector3 normal{ between(-1, 1), between(-1, 1), between(0.1, 1) };
    point.Normal = (1.0 / Norm(normal)) * normal;
    point.Friction = round % 4 == 0 ? 0.0 : between(0.0, 1.0);
    point.SurfaceStrength = round % 5 == 0 ? 1e5 : between(0.0, 3.0);
    point.Viscosity = round % 3 == 0 ? 0.0 : between(0.0, 2.0);
    const double k = between(50.0, 2000.0);
    const Vector3 proxy{ between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1) };
    const Vector3 lag{ between(-0.01, 0.01), between(-0.01, 0.01), between(-0.01, 0.01) };
    const Vector3 tip = proxy + lag;
    const SplitLag split = Law::Split(tip - proxy, point.Normal);
    const Balance balance = Law::Weigh(point, k, split);
    const Vector3 force = k * (Law::Move(point, k, split, balance, proxy) - tip);
    slid += balance.Slides;
    through += balance.IsThrough && split.Push > 0.0;
    const LawForces forces = ForcesOf(point, k, proxy, tip);
    worst = std::max(worst, Norm(forces.Composed - force));
    worst = std::max(worst, Norm(forces.Descended - force));
  }
  EXPECT_LT(worst, 1e-12) << "N";
  EXPECT_GT(slid, 5000);
  EXPECT_GT(through, 2000);
}

TEST(PrimitivesLaw, IsThatOfTicksOfPaper)
{
  TestVolume volume(ScalarType::Float64, { 24, 24, 24 });
  volume.Fill<double>([](std::int64_t i, std::int64_t j, std::int64_t k)
    { return 1000.0 + 400.0 * std::sin(0.5 * double(i) + 0.3 * double(j) - 0.4 * double(k)); });
  HapticModelDescription description = Describe(volume);
  description.Settings.Solver = HapticSolver::Paper;
  description.Material.Stiffness = { { 600.0, 200.0 }, { 1400.0, 1200.0 } };
  description.Material.Friction = { { 600.0, 0.0 }, { 1400.0, 0.6 } };
  description.Material.SurfaceStrength = { { 600.0, 0.2 }, { 1400.0, 3.0 } };
  description.Material.Viscosity = { { 800.0, 0.0 }, { 1200.0, 0.4 } };
  description.Settings.Side = SurfaceSide::Both;
  const HapticModel model(description);
  Wanderer wanderer(24.0, 5);
  ServoState state;
  TickRecord record;
  double worst = 0.0;
  int contacts[4] = {};
  for (int tick = 0; tick < 20000; ++tick)
  {
    const Vector3 proxy = state.Proxy;
    const bool isFirst = !state.Enabled;
    Tick(model, state, wanderer.Next(), record);
    if (!isFirst)
    {
      const LawForces forces = ForcesOf(record, record.Stiffness, proxy, record.Tip);
      worst = std::max(worst, Norm(forces.Composed - record.Force));
      ++contacts[static_cast<int>(record.Contact)];
    }
  }
  EXPECT_LT(worst, 1e-12) << "N";
  for (const int count : contacts)
  {
    EXPECT_GT(count, 100) << "the walk has met every case";
  }
}
