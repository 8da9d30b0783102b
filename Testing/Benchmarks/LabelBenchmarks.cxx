// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Medians.h"
#include "Motion.h"

#include <benchmark/benchmark.h>

#include <vector>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/** Returns a table with entries for the ball and its surroundings. */
LabelTable MakeTable()
{
  std::vector<LabelledMaterial> entries(2);
  entries[0].Label = 0;
  entries[0].Material.Value = { 50.0, 0.05, 0.5, 0.05 };
  entries[1].Label = 1;
  entries[1].Material.Value = { 350.0, 0.2, 1.5, 0.1 };
  for (LabelledMaterial& entry : entries)
  {
    entry.Material.IsSet.fill(true);
  }
  return LabelTable(entries);
}

/** Returns a label image: label 1 within BallRadius of the volume's centre, and 0 elsewhere. */
template <typename T>
BakedLabels MakeBall(const BallVolume& volume, ScalarType type)
{
  VolumeView view = volume.View;
  const std::int64_t* const n = view.Dimensions;
  const auto samples =
    std::make_shared<std::vector<T>>(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  T* to = samples->data();
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        const Vector3 voxel{ double(i), double(j), double(k) };
        *to++ = Norm(voxel - volume.GetCentre()) < BallRadius ? 1 : 0;
      }
    }
  }
  view.Data = samples->data();
  view.Type = type;
  BakedLabels labels;
  labels.View = LabelView(view);
  labels.Samples = samples;
  return labels;
}

void MeasureSlide(benchmark::State& bench, const BallVolume& volume, const ModelChoice& choice)
{
  const auto model = MakeModel(volume, GetEstimators()[2], choice);
  const Slide slide(volume);
  TickRecord record = slide.Measure(bench, *model);
  // Run one more round tick by tick, and count the sliding ticks, because a proxy sometimes sticks
  // to a wall of voxels.
  ServoState state = slide.Start;
  std::size_t sliding = 0;
  std::vector<double> times;
  std::vector<double> clocks;
  for (const Vector3& at : slide.Tips)
  {
    const double begin = ReadClock();
    Tick(*model, state, at, record);
    const double end = ReadClock();
    times.push_back(end - begin);
    clocks.push_back(ReadClock() - end);
    sliding += record.Contact == ContactState::Sliding ? 1 : 0;
  }
  bench.counters["p50"] = Summarize(times).Median - Summarize(clocks).Median;
  if (10 * sliding < 9 * slide.Tips.size())
  {
    bench.SkipWithError("the proxy does not slide");
  }
  // Check the depth: since the labels' border is at x_v, a deeper proxy would not have the
  // materials of a contact. PAPER drifts, so it is not checked.
  const double depth = BallRadius - Norm(1000.0 * state.Proxy - volume.GetCentre());
  if (choice.Solver == HapticSolver::Precise && depth > 0.5 * Depth)
  {
    bench.SkipWithError("the surface gives way");
  }
}

void Add(const BallVolume& volume, HapticSolver solver, const std::string& variant,
  const std::shared_ptr<const BakedLabels>& labels, SurfaceGeometry geometry)
{
  ModelChoice choice;
  choice.Solver = solver;
  choice.Labels = labels;
  choice.Geometry = geometry;
  const char* const tick = solver == HapticSolver::Paper ? "label_tick" : "precise_label_tick";
  benchmark::RegisterBenchmark(
    NameOf(tick, variant, "slide", volume.Name).c_str(), MeasureSlide, volume, choice);
}

void Register(const BallVolume& volume, const BakedLabels& labels, const std::string& type)
{
  const auto bare = std::make_shared<const BakedLabels>(labels);
  BakedLabels tabled = labels;
  tabled.Table = MakeTable();
  const auto withTable = std::make_shared<const BakedLabels>(tabled);
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    Add(volume, solver, "materials_" + type, withTable, SurfaceGeometry::Scalars);
    Add(volume, solver, "geometry_" + type, bare, SurfaceGeometry::Labels);
    Add(volume, solver, "geometry+materials_" + type, withTable, SurfaceGeometry::Labels);
  }
}

} // namespace

void RegisterLabelBenchmarks(const BallVolume& volume)
{
  Add(volume, HapticSolver::Paper, "none", nullptr, SurfaceGeometry::Scalars);
  Add(volume, HapticSolver::Precise, "none", nullptr, SurfaceGeometry::Scalars);
  Register(volume, MakeBall<std::uint8_t>(volume, ScalarType::UInt8), "uint8");
  Register(volume, MakeBall<std::int16_t>(volume, ScalarType::Int16), "int16");
  Register(volume, MakeBall<std::int32_t>(volume, ScalarType::Int32), "int32");
}

} // namespace benchmarks
