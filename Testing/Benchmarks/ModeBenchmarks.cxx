// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Medians.h"

#include "Core/Servo/ServoTick.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

constexpr int GridSize = 96; // number of points along each axis, 1 mm apart
const Vector3 GridMiddle{ 0.5 * (GridSize - 1), 0.5 * (GridSize - 1), 0.5 * (GridSize - 1) };

/** Returns a flow that rotates around an axis and moves along it. */
ModeDescription MakeFlow(ModeKind kind, const Vector3& axis, double strength)
{
  auto samples = std::make_shared<std::vector<float>>();
  samples->reserve(std::size_t{ 3 } * GridSize * GridSize * GridSize);
  for (int k = 0; k < GridSize; ++k)
  {
    for (int j = 0; j < GridSize; ++j)
    {
      for (int i = 0; i < GridSize; ++i)
      {
        const Vector3 away = Vector3{ double(i), double(j), double(k) } - GridMiddle;
        const Vector3 v = Cross(axis, away) + 5.0 * axis;
        samples->insert(samples->end(), { float(v.X), float(v.Y), float(v.Z) });
      }
    }
  }
  ModeDescription mode;
  mode.Kind = kind;
  mode.First = ConstantPolyline(strength);
  mode.View.Volume.Data = samples->data();
  mode.View.Volume.Type = ScalarType::Float32;
  for (int a = 0; a < 3; ++a)
  {
    mode.View.Volume.Dimensions[a] = GridSize;
    mode.View.Volume.Stride[a] = a == 0 ? 3 : mode.View.Volume.Stride[a - 1] * GridSize;
  }
  mode.Samples = samples;
  return mode;
}

std::vector<ModeDescription> MakeOblique()
{
  const auto unit = [](const Vector3& v) { return (1.0 / Norm(v)) * v; };
  return { MakeFlow(ModeKind::VectorFollow, unit({ 0.2, 0.1, 1.0 }), 0.5),
    MakeFlow(ModeKind::VectorFront, unit({ 1.0, 0.3, 0.2 }), 0.4),
    MakeFlow(ModeKind::VectorFollow, unit({ 0.3, 1.0, -0.4 }), 0.3),
    MakeFlow(ModeKind::VectorFront, unit({ -0.5, 0.4, 0.8 }), 0.3) };
}

HapticModelDescription Describe(const std::vector<ModeDescription>& modes)
{
  HapticModelDescription d;
  d.View = modes.front().View.Volume;
  d.Samples = modes.front().Samples;
  d.DeviceToWorld.Linear = 1000.0 * Matrix3{};
  d.Settings.Method = HapticMethod::Primitives;
  d.Modes = modes;
  return d;
}

/**
 * Measures ticks of a tip that moves at 0.1 m/s near a circle with a radius of 20 mm. The modes
 * resist only part of the lag.
 */
void MeasureModes(benchmark::State& bench, const std::vector<ModeDescription>& modes)
{
  const HapticModel model(Describe(modes));
  std::vector<Vector3> tips;
  constexpr int steps = 1257;
  for (int i = 0; i < steps; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / steps;
    const double radius = 20.0 + 2.0 * std::sin(3.0 * angle);
    tips.push_back(0.001 *
      (GridMiddle +
        Vector3{
          radius * std::cos(angle), radius * std::sin(angle), 2.0 * std::sin(5.0 * angle) }));
  }
  ServoState state;
  TickRecord record;
  for (const Vector3& tip : tips) // moves the tip into contact
  {
    Tick(model, state, tip, record);
  }
  std::size_t next = 0;
  for (auto _ : bench)
  {
    Tick(model, state, tips[next], record);
    next = next + 1 < tips.size() ? next + 1 : 0;
    benchmark::DoNotOptimize(record);
  }
  std::vector<double> times;
  std::vector<double> clocks;
  double force = 0.0;
  for (const Vector3& tip : tips)
  {
    const double begin = ReadClock();
    Tick(model, state, tip, record);
    const double end = ReadClock();
    times.push_back(end - begin);
    clocks.push_back(ReadClock() - end);
    force = std::max(force, Norm(record.Force));
  }
  bench.counters["p50"] = Summarize(times).Median - Summarize(clocks).Median;
  if (!(force > 0.1))
  {
    bench.SkipWithError("nothing is felt");
  }
}

/**
 * Measures the work after a tick that computes the force of each mode, as the servo and the filter
 * do.
 */
void MeasureModeForces(benchmark::State& bench, const std::vector<ModeDescription>& modes)
{
  const HapticModel model(Describe(modes));
  ServoState state;
  TickRecord record;
  Tick(model, state, 0.001 * GridMiddle, record);
  Tick(model, state, 0.001 * (GridMiddle + Vector3{ 1.0, 2.0, 0.5 }), record);
  for (auto _ : bench)
  {
    benchmark::DoNotOptimize(ComputeModeForces(model, state));
  }
}

} // namespace

void RegisterModeBenchmarks()
{
  const Vector3 up{ 0.0, 0.0, 1.0 };
  benchmark::RegisterBenchmark("mode_tick/follow/slide/96^3", MeasureModes,
    std::vector<ModeDescription>{ MakeFlow(ModeKind::VectorFollow, up, 2.0) });
  benchmark::RegisterBenchmark("mode_tick/vortex/slide/96^3", MeasureModes,
    std::vector<ModeDescription>{ MakeFlow(ModeKind::VortexTube, up, 2.0) });
  benchmark::RegisterBenchmark("mode_tick/four_oblique/slide/96^3", MeasureModes, MakeOblique());
  benchmark::RegisterBenchmark(
    "mode_forces/four_oblique/slide/96^3", MeasureModeForces, MakeOblique());
}

} // namespace benchmarks
