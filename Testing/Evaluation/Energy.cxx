// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Energy.h"

#include "Shapes.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
/** Returns a random field of hills and hollows. */
Field Hills(std::mt19937& random)
{
  Uniform uniform(random);
  struct Wave
  {
    Vector3 Number;
    double Phase;
    double Height;
  };
  std::vector<Wave> waves;
  for (int i = 0; i < 5; ++i)
  {
    const Vector3 direction = { uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0) };
    const double length = uniform(15.0, 50.0);
    waves.push_back(
      { (TwoPi / length / Norm(direction)) * direction, uniform(0.0, TwoPi), uniform(10.0, 40.0) });
  }
  return [waves](const Vector3& x)
  {
    double sum = 10.0 * Dot(x, OddNormal);
    for (const Wave& wave : waves)
    {
      sum += wave.Height * std::sin(Dot(wave.Number, x) + wave.Phase);
    }
    return sum;
  };
}

/**
 * Returns a path that presses, moves around, comes back and leaves, so that the spring has no
 * energy at either end.
 */
Path ClosedWay(std::mt19937& random)
{
  Uniform uniform(random);
  const Vector3 start = { uniform(-6.0, 6.0), uniform(-6.0, 6.0), uniform(-6.0, 6.0) };
  const double depth = uniform(0.5, 4.0);
  const double reach = uniform(1.0, 6.0);
  const double along = uniform(0.0, TwoPi);
  Path path;
  constexpr int ticks = 4000;
  for (int i = 0; i <= ticks; ++i)
  {
    const double t = TwoPi * i / ticks;
    const double in = 0.5 * (1.0 - std::cos(t)) * depth;
    const double round = reach * std::sin(0.5 * t) * std::sin(0.5 * t);
    path.push_back(start + in * OddNormal + (round * std::cos(2.0 * t + along)) * OddAside +
      (round * std::sin(2.0 * t + along)) * OddUp);
  }
  MoveTo(path, start - 6.0 * OddNormal, 0.01);
  return path;
}

HapticMaterial AnyMaterial(std::mt19937& random, int kind)
{
  Uniform uniform(random);
  HapticMaterial material = MakeMaterial(uniform(300.0, 1000.0), kind & 1 ? uniform(0.0, 0.5) : 0.0,
    kind & 2 ? uniform(0.0, 0.4) : 0.0, kind & 4 ? Impenetrable : uniform(0.5, 3.0));
  if (kind & 8)
  {
    // Model a soft layer on a stiff wall: the wall must not return more energy than the hand has
    // put into the layer.
    const double wall = uniform(20.0, 60.0);
    material.Stiffness = { { wall - 20.0, uniform(200.0, 500.0) },
      { wall, uniform(1000.0, 2000.0) } };
    material.SurfaceStrength = { { wall - 20.0, uniform(0.3, 1.0) }, { wall, Impenetrable } };
  }
  return material;
}

} // namespace

double EnergyGiven(const Path& path, const Trace& trace)
{
  double energy = 0.0;
  for (std::size_t i = 1; i < trace.size(); ++i)
  {
    const Vector3 way = 0.001 * (path[i] - path[i - 1]);
    energy += Dot(0.5 * (trace[i].Force + trace[i - 1].Force), way);
  }
  return energy;
}

std::vector<double> MeasureCycles(const Candidate& candidate, int cycles)
{
  std::vector<double> energies;
  std::mt19937 random(11);
  for (int cycle = 0; cycle < cycles; ++cycle)
  {
    const Volume volume(Hills(random), { 20.0, { 1.0, 1.0, 1.0 }, ScalarType::Float32 });
    const auto model = volume.Bake(TouchingOf(candidate, AnyMaterial(random, cycle)));
    const Path path = ClosedWay(random);
    energies.push_back(EnergyGiven(path, Play(*model, path)));
  }
  return energies;
}

Figures MeasureEnergy(const Candidate& candidate, const Effort& effort)
{
  double most = 0.0;
  for (const double energy : MeasureCycles(candidate, effort.Pick(32, 320)))
  {
    most = std::max(most, energy);
  }
  // T15: the tip rests 3.5 mm deep in a material whose stiffness is then multiplied by four.
  const Volume slab([](const Vector3& x) { return 100.0 * x.Z; }, {});
  const auto soft = slab.Bake(TouchingOf(candidate, MakeMaterial(500.0, 0.0, 0.0, Impenetrable)));
  const auto stiff = slab.Bake(TouchingOf(candidate, MakeMaterial(2000.0, 0.0, 0.0, Impenetrable)));
  ServoState state;
  TickRecord tick;
  Tick(*soft, state, {}, tick);
  const Vector3 tip = { 0.0, 0.0, 0.0035 };
  Tick(*soft, state, tip, tick);
  const double before = 0.5 * Dot(tick.Force, tick.Proxy - tip);
  CarryState(*soft, *stiff, state);
  Tick(*stiff, state, tip, tick);
  const double after = 0.5 * Dot(tick.Force, tick.Proxy - tip);
  return { { "energy created over closed cycles, most", "uJ", 1e6 * most, 0.1 },
    { "T15, stored energy after / before the step of k", "", after / before, 1.0 + 1e-9 } };
}

} // namespace evaluation
