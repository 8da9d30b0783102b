// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Core/Servo/ServoTick.h"
#include "Motion.h"

#include <benchmark/benchmark.h>

#include <algorithm>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/** How deep the tip is held below the surface, mm. */
constexpr double Depth = 2.0;

/** Entries for the ball and its surroundings. */
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

/** Label 1 within BallRadius of the volume's centre, 0 elsewhere. */
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

void Slide(benchmark::State& bench, const BallVolume& volume, const ModelChoice& choice)
{
  const auto model = MakeModel(volume, GetEstimators()[2], choice);
  Positions tips = SlideAt(volume, BallRadius - Depth);
  for (Vector3& tip : tips)
  {
    tip = 0.001 * tip;
  }
  ServoState start;
  start.Proxy = 0.001 * SlideAt(volume, BallRadius).front();
  start.PreviousTip = tips.front();
  start.Precise.ReachedTip = start.Proxy;
  start.Enabled = true;

  ServoState state = start;
  TickRecord record;
  Cycle tip(tips);
  for (auto _ : bench)
  {
    Tick(*model, state, tip.Next(), record);
    benchmark::DoNotOptimize(record);
    if (tip.IsAtStart())
    {
      state = start;
    }
  }
  // One more round, since a proxy sticks to a wall of voxels now and then.
  state = start;
  const auto sliding = std::count_if(tips.begin(), tips.end(),
    [&](const Vector3& at)
    {
      Tick(*model, state, at, record);
      return record.Contact == ContactState::Sliding;
    });
  bench.counters["sliding"] = static_cast<double>(sliding) / static_cast<double>(tips.size());
  if (10 * sliding < 9 * static_cast<std::ptrdiff_t>(tips.size()))
  {
    bench.SkipWithError("the proxy does not slide");
  }
}

void Register(const BallVolume& volume, const BakedLabels& labels, const std::string& type)
{
  const auto bare = std::make_shared<const BakedLabels>(labels);
  BakedLabels tabled = labels;
  tabled.Table = MakeTable();
  const auto withTable = std::make_shared<const BakedLabels>(tabled);
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const std::string tick = solver == HapticSolver::Paper ? "tick" : "precise_tick";
    const auto add = [&](const std::string& variant,
                       const std::shared_ptr<const BakedLabels>& touched, SurfaceGeometry geometry)
    {
      ModelChoice choice;
      choice.Solver = solver;
      choice.Labels = touched;
      choice.Geometry = geometry;
      benchmark::RegisterBenchmark(
        NameOf(tick, variant + "_" + type, "slide", volume.Name).c_str(), Slide, volume, choice);
    };
    add("materials", withTable, SurfaceGeometry::Scalars);
    add("geometry", bare, SurfaceGeometry::Labels);
    add("geometry+materials", withTable, SurfaceGeometry::Labels);
  }
}

} // namespace

void RegisterLabelBenchmarks(const BallVolume& volume)
{
  Register(volume, MakeBall<std::uint8_t>(volume, ScalarType::UInt8), "uint8");
  Register(volume, MakeBall<std::int16_t>(volume, ScalarType::Int16), "int16");
  Register(volume, MakeBall<std::int32_t>(volume, ScalarType::Int32), "int32");
}

} // namespace benchmarks
