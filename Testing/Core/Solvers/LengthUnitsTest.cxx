// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the force does not depend on the world's length unit: a ball in micrometres,
 * centimetres, metres and kilometres must give the same forces as in millimetres.
 */

#include "Rigs/CoreScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace coretest;

namespace
{
/// Presses and strokes. `unit` is the number of millimetres in a world unit, and `step` the tip's
/// motion (mm) per tick. Returns the force of each tick.
std::vector<Vector3> Touch(
  const TestVolume& volume, double unit, HapticMethod method, HapticSolver solver, double step)
{
  HapticModelDescription description = Describe(volume);
  description.IndexToWorld.Linear = (0.7 / unit) * Matrix3{};
  description.DeviceToWorld.Linear = (1000.0 / unit) * Matrix3{};
  description.Material.Stiffness = { { -955.0, 0.0 }, { -900.0, 400.0 } };
  description.Material.SurfaceStrength = { { -955.0, 0.0 }, { -900.0, 0.4 }, { 50.0, 2.2 } };
  description.Material.Friction = ConstantPolyline(0.2);
  description.Material.Viscosity = { { -955.0, 0.0 }, { -900.0, 0.02 } };
  description.Material.Distinctness = { { 8.0 * unit, 0.0 }, { 40.0 * unit, 1.0 } };
  description.Settings.Method = method;
  description.Settings.Solver = solver;
  const HapticModel model(description);
  ServoState state;
  TickRecord record;
  std::vector<Vector3> forces;
  const Vector3 centre{ 13.9, 14.1, 14.3 };
  const int ticks = static_cast<int>(12.0 / step);
  for (int i = 0; i <= ticks; ++i)
  {
    const double depth = std::min(1.5, -2.0 + step * i);
    const double angle = 0.1 * std::max(0.0, step * i - 4.0);
    const Vector3 out{ std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle) };
    Tick(model, state, 1e-3 * (centre + (9.0 - depth) * out), record);
    forces.push_back(record.Force);
  }
  return forces;
}

double LargestDifference(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, Norm(a[i] - b[i]));
  }
  return largest;
}

TestVolume MakeBall()
{
  TestVolume volume(ScalarType::Float64, { 40, 40, 40 });
  volume.Fill<double>(
    [](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const Vector3 x{ 0.7 * double(i), 0.7 * double(j), 0.7 * double(k) };
      return -1000.0 +
        530.0 * std::erfc((Norm(x - Vector3{ 13.9, 14.1, 14.3 }) - 9.0) / (0.45 * std::sqrt(2.0)));
    });
  return volume;
}
} // namespace

TEST(LengthUnits, ChangeNoForce)
{
  const TestVolume volume = MakeBall();
  for (const double step : { 0.02, 0.05, 0.11 })
  {
    for (const auto& [method, solver] : { std::pair(HapticMethod::Proxy, HapticSolver::Paper),
           std::pair(HapticMethod::Proxy, HapticSolver::Precise),
           std::pair(HapticMethod::LocalSurface, HapticSolver::Precise) })
    {
      SCOPED_TRACE(testing::Message()
        << "method " << int(method) << ", solver " << int(solver) << ", " << step << " mm a tick");
      const std::vector<Vector3> expected = Touch(volume, 1.0, method, solver, step);
      EXPECT_GT(Norm(expected.back()), 0.1);
      for (const double unit : { 0x1p-10, 0x1p20 })
      {
        EXPECT_EQ(LargestDifference(Touch(volume, unit, method, solver, step), expected), 0.0);
      }
      // World units of a micrometre, a centimetre, a metre and a kilometre, whose numbers are
      // rounded differently.
      for (const double unit : { 1e-3, 10.0, 1e3, 1e6 })
      {
        const double found = LargestDifference(Touch(volume, unit, method, solver, step), expected);
        // The solver Paper chatters on the ball, so rounding alone changes its force by up to 0.02
        // N.
        EXPECT_LT(found, solver == HapticSolver::Paper ? 0.02 : 1e-9);
      }
    }
  }
}
