// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Medians.h"
#include "Motion.h"

#include "Core/Tools/Burr/BakedBurr.h"
#include "Core/Tools/Burr/BurrTool.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

struct BurrChoice
{
  const char* Name;
  double Radius; ///< mm, which equals voxels
  double Energy; ///< J/mm^3, with the burr at 60 000/min
};

/**
 * Burrs large enough that the surface they leave is correct within 0.05 voxel. "soft": the burr
 * removes a layer of bone. "hard": the burr removes little.
 */
constexpr BurrChoice SmallBurrs[] = { { "soft", 4.0, 1.0 }, { "hard", 4.0, 100.0 } };
/** Burrs that use up the time that a tick reserves for removal. */
constexpr BurrChoice LargeBurrs[] = { { "radius16", 16.0, 0.05 }, { "radius30", 30.0, 0.05 } };

/** A burr that slides around the ball, 2 mm deep, and removes tissue. */
struct BurrSlide
{
  BurrSlide(const BallVolume& volume, const BurrChoice& burr)
    : Ways(SlideAt(volume, BallRadius + burr.Radius - 2.0))
  {
    HapticModelDescription d;
    d.View = volume.View;
    d.DeviceToWorld.Linear = 1000.0 * Matrix3{};
    d.Removal = std::make_shared<TissueRemoval>();
    BurrDescription tool;
    tool.Settings.Radius = burr.Radius;
    tool.SpecificEnergy = ConstantPolyline(burr.Energy);
    tool.Head.Points = std::make_shared<const PointShell>(BakedBurr::MakeHead(burr.Radius));
    tool.Head.Touch.Level = BallLevel;
    tool.Head.Touch.ContactArea = 0.1;
    d.Tool = std::make_shared<const BakedBurr>(tool);
    this->Model = std::make_unique<HapticModel>(d);
    this->Points = std::make_unique<ShellMemory>(*tool.Head.Points);
    // Move from outside into contact.
    const Vector3 out = this->Ways.front() - volume.GetCentre();
    for (int i = 100; i > 0; --i)
    {
      this->Tick(this->Ways.front() + (6e-2 * i / Norm(out)) * out);
    }
  }

  void Tick(const Vector3& index) noexcept
  {
    TickBurr(*this->Model, { 0.001 * index, true, 1e-3 }, this->Shell, this->State,
      { *this->Points, this->Carver }, this->Record);
    this->Removed += this->Record.RemovedVolume;
  }
  void Next() noexcept
  {
    this->Step = this->Step + 1 < this->Ways.size() ? this->Step + 1 : 0;
    this->Tick(this->Ways[this->Step]);
  }

  std::unique_ptr<HapticModel> Model;
  std::unique_ptr<ShellMemory> Points;
  SphereCarver Carver;
  ShellState Shell;
  BurrState State;
  BurrRecord Record;
  const Positions Ways;
  std::size_t Step = 0;
  double Removed = 0.0; ///< mm^3 of removed tissue
};

void MeasureBurr(benchmark::State& bench, const BallVolume* volume, const BurrChoice* burr)
{
  BurrSlide slide(*volume, *burr);
  for (auto _ : bench)
  {
    slide.Next();
    benchmark::DoNotOptimize(slide.Record);
  }
  std::vector<double> times;
  constexpr int ticks = 2000;
  for (int i = 0; i < ticks; ++i)
  {
    const double begin = ReadClock();
    slide.Next();
    times.push_back(ReadClock() - begin);
  }
  bench.counters["p50"] = Summarize(times).Median;
  bench.counters["p99"] = times[times.size() * 99 / 100]; // `times` is already sorted
  bench.counters["mm3_removed"] = slide.Removed;
  if (!(slide.Removed > 0.0))
  {
    bench.SkipWithError("nothing was removed");
  }
}

} // namespace

void RegisterBurrBenchmarks(const BallVolume& volume)
{
  const auto add = [&volume](const BurrChoice& burr)
  {
    benchmark::RegisterBenchmark(
      NameOf("burr_tick", burr.Name, "slide", volume.Name).c_str(), MeasureBurr, &volume, &burr);
  };
  std::for_each(std::begin(SmallBurrs), std::end(SmallBurrs), add);
  const std::int64_t* const n = volume.View.Dimensions;
  if (*std::min_element(n, n + 3) > 2.0 * (BallRadius + 2.0 * LargeBurrs[1].Radius))
  {
    std::for_each(std::begin(LargeBurrs), std::end(LargeBurrs), add);
  }
}

} // namespace benchmarks
