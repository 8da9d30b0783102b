// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the paper's law in the form of primitives, for the solvers Paper and Precise. Compares it
 * with the law that the solvers use, and with the solvers' ticks in random scenes.
 */

#include "Core/Law/MaterialLaw.h"
#include "Core/Solvers/Primitives/MaterialPrimitives.h"
#include "Core/Solvers/Primitives/PrimitiveSolver.h"
#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

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

/// A volume with a ripple in a random direction (and noise in every third scene), and materials
/// that change with the value.
class RandomScene
{
public:
  RandomScene(unsigned seed, HapticSolver solver)
    : Dice(1.0, seed)
  {
    const Vector3 wave{ this->Between(-0.6, 0.6), this->Between(-0.6, 0.6),
      this->Between(-0.6, 0.6) };
    const double noise = seed % 3 == 0 ? this->Between(0.0, 200.0) : 0.0;
    this->Volume.Fill<double>(
      [&](std::int64_t i, std::int64_t j, std::int64_t k)
      {
        const double phase = Dot(wave, { double(i), double(j), double(k) });
        return 1000.0 + 400.0 * std::sin(phase) + this->Between(-0.5, 0.5) * noise;
      });
    HapticModelDescription d = Describe(this->Volume);
    d.Settings.Solver = solver;
    d.Settings.ReleaseTime = 0.0; // another test has a release time
    d.Settings.Side = seed % 2 ? SurfaceSide::Both : SurfaceSide::Higher;
    d.Estimator = static_cast<GradientEstimator>(seed % 3);
    d.KernelRadius = 1 + static_cast<int>(seed % 3);
    if (seed % 4 < 2)
    {
      PlaceAsThePaper(d);
    }
    d.Material.Stiffness = this->Ramp(100.0, 1500.0);
    d.Material.Friction = this->Ramp(0.0, 0.9);
    d.Material.SurfaceStrength = this->Ramp(0.1, 4.0);
    d.Material.Viscosity = this->Ramp(0.0, 0.6);
    if (seed % 5 == 0)
    {
      d.Material.Distinctness = { { 20.0, 0.0 }, { this->Between(50.0, 150.0), 1.0 } };
    }
    this->Model = std::make_unique<HapticModel>(d);
  }

  /// Walks through the scene at random. After each tick, calls `compare` with the record, and with
  /// the proxy's position before the tick.
  template <typename Compare>
  void Walk(unsigned seed, const Compare& compare)
  {
    Wanderer wanderer(24.0, seed);
    ServoState state;
    TickRecord record;
    Tick(*this->Model, state, wanderer.Next(), record);
    for (int tick = 0; tick < 3000; ++tick)
    {
      const Vector3 proxy = state.Proxy;
      Tick(*this->Model, state, wanderer.Next(), record);
      if (!record.IsUnfinished)
      {
        compare(record, proxy);
      }
    }
  }

private:
  double Between(double low, double high) { return low + (high - low) * this->Dice.Uniform(); }
  Polyline Ramp(double low, double high)
  {
    return { { this->Between(500.0, 900.0), this->Between(low, high) },
      { this->Between(1000.0, 1500.0), this->Between(low, high) } };
  }

  Wanderer Dice;
  TestVolume Volume{ ScalarType::Float64, { 24, 24, 24 } };
  std::unique_ptr<HapticModel> Model;
};

/// The largest error and the number of ticks of each ContactState.
struct Met
{
  double Worst[4] = {}; ///< largest error (N)
  int Count[4] = {};
};

template <typename AnchorOf>
Met CompareScenes(HapticSolver solver, const AnchorOf& anchorOf)
{
  Met met;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    RandomScene(100 + seed, solver)
      .Walk(seed,
        [&](const TickRecord& record, const Vector3& before)
        {
          const Vector3 anchor = anchorOf(record, before);
          const LawForces forces = ForcesOf(record, record.Stiffness, anchor, record.Tip);
          const auto contact = static_cast<std::size_t>(record.Contact);
          met.Worst[contact] = std::max(met.Worst[contact], Norm(forces.Composed - record.Force));
          ++met.Count[contact];
        });
  }
  return met;
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
  // The solver Paper reads the primitives where the proxy was before the tick.
  const Met met = CompareScenes(
    HapticSolver::Paper, [](const TickRecord&, const Vector3& before) { return before; });
  for (int contact = 0; contact < 4; ++contact)
  {
    EXPECT_LT(met.Worst[contact], 1e-12) << "N, contact " << contact;
    EXPECT_GT(met.Count[contact], 1000) << "the walks have met every case";
  }
}

TEST(PrimitivesLaw, HoldsTheProxyWhereTicksOfPreciseEnd)
{
  // The solver Precise applies the law along the proxy's path until the proxy rests. At the last
  // position, the primitives hold the proxy with the force of the tick. A sliding proxy stops
  // slightly before its balance, so its tolerance is larger.
  const Met met = CompareScenes(
    HapticSolver::Precise, [](const TickRecord& record, const Vector3&) { return record.Proxy; });
  for (int contact = 0; contact < 4; ++contact)
  {
    const bool slides = contact == static_cast<int>(ContactState::Sliding);
    EXPECT_LT(met.Worst[contact], slides ? 1e-3 : 1e-12) << "N, contact " << contact;
    EXPECT_GT(met.Count[contact], 1000) << "the walks have met every case";
  }
}
