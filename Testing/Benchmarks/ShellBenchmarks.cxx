// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Medians.h"
#include "Motion.h"

#include "Core/Tools/PointShell/ShellCoupling.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

constexpr int ShellPoints = 10000;
/**
 * Radius (mm) of the tool. The hand is 4 mm deep in the ball and the tool 2 mm, because both
 * springs share the lag. So a quarter of the sphere's area is inside the ball.
 */
constexpr double ToolRadius = 4.0;

/** Returns points on a sphere that represent equal areas. */
std::vector<ShellPoint> MakeTool()
{
  const double pi = std::acos(-1.0);
  const double golden = pi * (3.0 - std::sqrt(5.0));
  std::vector<ShellPoint> points;
  for (int i = 0; i < ShellPoints; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / ShellPoints;
    const double r = std::sqrt(1.0 - z * z);
    const Vector3 on{ r * std::cos(golden * i), r * std::sin(golden * i), z };
    points.push_back(
      { 0.001 * ToolRadius * on, 4e-6 * pi * ToolRadius * ToolRadius / ShellPoints });
  }
  return points;
}

/** A tool that rotates while it slides around the ball at 0.1 m/s. */
struct ShellSlide
{
  explicit ShellSlide(const BallVolume& volume)
    : Shell(MakeTool())
    , Memory(this->Shell)
  {
    HapticModelDescription description;
    description.View = volume.View;
    description.DeviceToWorld.Linear = 1000.0 * Matrix3{};
    this->Model = std::make_unique<HapticModel>(description);
    this->Settings.Level = BallLevel;
    this->Ways = SlideAt(volume, BallRadius + ToolRadius - 4.0);
    // Move from outside into contact.
    const Vector3 out = this->Ways.front() - volume.GetCentre();
    for (int i = 100; i > 0; --i)
    {
      this->Tick(this->Ways.front() + (6e-2 * i / Norm(out)) * out);
    }
    for (int i = 0; i < 100; ++i)
    {
      this->Next();
    }
  }

  void Tick(const Vector3& index) noexcept
  {
    this->Angle += 1e-3;
    const ShellPose hand{ 0.001 * index,
      { std::cos(this->Angle), 0.6 * std::sin(this->Angle), 0.0, 0.8 * std::sin(this->Angle) } };
    TickShell(
      *this->Model, this->Shell, this->Settings, hand, this->State, this->Memory, this->Record);
  }
  void Next() noexcept
  {
    this->Step = this->Step + 1 < this->Ways.size() ? this->Step + 1 : 0;
    this->Tick(this->Ways[this->Step]);
  }

  std::unique_ptr<HapticModel> Model;
  const PointShell Shell;
  ShellSettings Settings;
  ShellMemory Memory;
  ShellState State;
  ShellRecord Record;
  Positions Ways;
  std::size_t Step = 0;
  double Angle = 0.0;
};

void MeasureShell(benchmark::State& bench, const BallVolume* volume)
{
  ShellSlide slide(*volume);
  for (auto _ : bench)
  {
    slide.Next();
    benchmark::DoNotOptimize(slide.Record);
  }
  std::vector<double> times;
  double contacts = 0.0;
  double looks = 0.0;
  constexpr int ticks = 200;
  for (int i = 0; i < ticks; ++i)
  {
    const double begin = ReadClock();
    slide.Next();
    times.push_back(ReadClock() - begin);
    contacts += slide.Record.Contacts;
    looks += slide.Record.Looks;
  }
  bench.counters["p50"] = Summarize(times).Median;
  bench.counters["contacts"] = contacts / ticks;
  bench.counters["looks"] = looks / ticks;
  if (!(contacts > 0.2 * ShellPoints * ticks))
  {
    bench.SkipWithError("less than a fifth of the tool is in contact");
  }
}

/**
 * Measures the least cost of a tick: reading 8 samples for each point, and 40 more for each
 * contact.
 */
void MeasureTaps(benchmark::State& bench, const BallVolume* volume)
{
  ShellSlide slide(*volume);
  const VolumeView& view = volume->View;
  const auto* const samples = static_cast<const std::int16_t*>(view.Data);
  const Affine3 toIndex = Compose(slide.Model->DeviceToIndex,
    { ToMatrix(slide.Record.Tool.Orientation), slide.Record.Tool.Position });
  const ShellContacts& contacts = slide.Memory.GetCurrent();
  const auto find = [&](std::size_t i)
  {
    const Vector3 at = toIndex(slide.Shell.GetPosition(i));
    return static_cast<std::int64_t>(at.X) + static_cast<std::int64_t>(at.Y) * view.Stride[1] +
      static_cast<std::int64_t>(at.Z) * view.Stride[2];
  };
  std::vector<std::int64_t> all;
  std::vector<std::int64_t> held;
  for (std::size_t i = 0; i < slide.Shell.GetSize(); ++i)
  {
    all.push_back(find(i));
  }
  for (std::size_t i = 0; i < contacts.Count; ++i)
  {
    held.push_back(find(contacts.List[i].Point));
  }
  const std::int64_t sy = view.Stride[1];
  const std::int64_t sz = view.Stride[2];
  const auto pair = [](const std::int16_t* p) { return p[0] + p[1]; };
  const auto cell = [&](const std::int16_t* p)
  { return pair(p) + pair(p + sy) + pair(p + sz) + pair(p + sy + sz); };
  for (auto _ : bench)
  {
    std::int32_t sum = 0;
    for (const std::int64_t at : all)
    {
      sum += cell(samples + at);
    }
    for (const std::int64_t at : held)
    {
      const std::int16_t* const p = samples + at;
      const auto line = [&](std::int64_t offset) { return p[offset - 1] + p[offset + 2]; };
      sum += cell(p) + line(0) + line(sy) + line(sz) + line(sy + sz);
      sum += pair(p - sy) + pair(p - sy + sz) + pair(p + 2 * sy) + pair(p + 2 * sy + sz);
      sum += pair(p - sz) + pair(p - sz + sy) + pair(p + 2 * sz) + pair(p + 2 * sz + sy);
      sum += cell(p + 2); // reads the samples for the material
    }
    benchmark::DoNotOptimize(sum);
  }
}

} // namespace

void RegisterShellBenchmarks(const BallVolume& volume)
{
  benchmark::RegisterBenchmark(
    NameOf("shell_tick", "sphere", "slide", volume.Name).c_str(), MeasureShell, &volume);
  benchmark::RegisterBenchmark(
    NameOf("shell_gather", "sphere", "slide", volume.Name).c_str(), MeasureTaps, &volume);
}

} // namespace benchmarks
