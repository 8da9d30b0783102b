// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Core/Servo/ServoTick.h"
#include "Motion.h"

#include <vtkCellArray.h>
#include <vtkHapticProperty.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkVolumeHapticsFilter.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/** Depth (mm) at which the tip is held below the surface. */
constexpr double Depth = 2.0;
/** Number of ticks, large enough to make the other costs of an Update() negligible. */
constexpr int Ticks = 100000;

/** Returns a path into the ball, followed by several rounds along its surface. */
std::vector<Vector3> SlideFor(const BallVolume& volume, int ticks)
{
  constexpr int approach = 100; // ticks before contact
  const Positions tips = SlideAt(volume, BallRadius - Depth);
  const Positions above = SlideAt(volume, BallRadius + Depth);
  Cycle cycle(tips);
  std::vector<Vector3> all;
  all.reserve(static_cast<std::size_t>(ticks));
  for (int i = 0; i < ticks; ++i)
  {
    const double share = static_cast<double>(i) / approach;
    all.push_back(i < approach ? above[1] + share * (tips[1] - above[1]) : Vector3(cycle.Next()));
  }
  return all;
}

vtkSmartPointer<vtkPolyData> MakePaths(const std::vector<Vector3>& tips, int paths)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (int path = 0; path < paths; ++path)
  {
    lines->InsertNextCell(static_cast<int>(tips.size()));
    for (const Vector3& tip : tips)
    {
      lines->InsertCellPoint(points->InsertNextPoint(tip.X, tip.Y, tip.Z));
    }
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  polyData->SetPoints(points);
  polyData->SetLines(lines);
  return polyData;
}

void SetFunction(vtkPiecewiseFunction* function, const Polyline& points)
{
  function->RemoveAllPoints();
  for (const auto& point : points)
  {
    function->AddPoint(point.X, point.Y);
  }
}

/** Makes a filter that is equivalent to MakeModel() with the same estimator. */
vtkSmartPointer<vtkVolumeHapticsFilter> MakeFilter(
  const BallVolume& volume, HapticSolver solver, vtkPolyData* paths)
{
  auto filter = vtkSmartPointer<vtkVolumeHapticsFilter>::New();
  const HapticMaterial material = MakeMaterial(volume);
  vtkHapticProperty* const property = filter->GetProperty();
  property->DistinctnessFromNoiseOff();
  SetFunction(property->GetStiffness(), material.Stiffness);
  SetFunction(property->GetFriction(), material.Friction);
  SetFunction(property->GetViscosity(), material.Viscosity);
  SetFunction(property->GetSurfaceStrength(), material.SurfaceStrength);
  SetFunction(property->GetDistinctness(), material.Distinctness);
  filter->SetSolver(static_cast<int>(solver));
  filter->SetContactAlignmentToDistinctness();
  filter->SetMaterialPlacementToKernel();
  filter->SetInputDataObject(0, volume.Image);
  filter->SetPathData(paths);
  return filter;
}

/**
 * Measures the filter's ticks without its outputs, with or without reading the value at the proxy.
 */
void Bare(benchmark::State& bench, const BallVolume& volume, HapticSolver solver, bool withValue)
{
  const std::vector<Vector3> tips = SlideFor(volume, Ticks);
  const auto found = std::find_if(GetEstimators().begin(), GetEstimators().end(),
    [](const Estimator& estimator)
    { return estimator.Kind == GradientEstimator::Gaussian && estimator.Radius == 2; });
  ModelChoice choice{ HapticMethod::Proxy, solver };
  choice.IsPlacedAsThePaper = true; // as in MakeFilter()
  const auto model = MakeModel(volume, *found, choice);
  TickRecord record;
  while (bench.KeepRunningBatch(Ticks))
  {
    ServoState state;
    TickMemory memory;
    for (const Vector3& tip : tips)
    {
      Tick(*model, state, 0.001 * tip, record, LocalSurfaceResult::Simulated(), &memory);
      benchmark::DoNotOptimize(record);
      if (withValue)
      {
        benchmark::DoNotOptimize(model->ValueAtDevice(record.Proxy));
      }
    }
  }
}

/** Measures a whole Update() of the filter, as time per tick. */
void Whole(
  benchmark::State& bench, const BallVolume& volume, HapticSolver solver, const char* arrays)
{
  const auto paths = MakePaths(SlideFor(volume, Ticks), 1);
  const auto filter = MakeFilter(volume, solver, paths);
  filter->SetTraceArrays(arrays);
  while (bench.KeepRunningBatch(Ticks))
  {
    filter->Modified();
    filter->Update();
  }
  if (filter->GetOutput()->GetNumberOfPoints() != Ticks)
  {
    bench.SkipWithError("the filter does not feel the path");
  }
}

/** Returns the time (s) of an Update(). */
double Time(vtkVolumeHapticsFilter* filter)
{
  filter->Modified();
  const auto begin = std::chrono::steady_clock::now();
  filter->Update();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/** Returns the time (s) of a purely arithmetic task that several threads share. */
double TimeArithmetic(int threads)
{
  constexpr int steps = 40000000;
  const auto work = [=]
  {
    // Compute eight independent sums, which keep all floating-point units of the processor busy.
    double sums[8] = { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0 };
    for (int i = 0; i < steps / threads; ++i)
    {
      for (double& sum : sums)
      {
        sum = 0.5 * sum + 1.0;
      }
    }
    benchmark::DoNotOptimize(sums);
  };
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i)
  {
    others.emplace_back(work);
  }
  work();
  for (std::thread& other : others)
  {
    other.join();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/** Measures one thread and two threads alternately, and prints the speed-up. Returns its median. */
template <typename Timing>
double PrintSpeedup(const std::string& name, int repetitions, const Timing& timing)
{
  std::vector<double> times[2];
  timing(2);
  for (int i = 0; i < repetitions; ++i)
  {
    for (const int threads : { 1, 2 })
    {
      times[threads - 1].push_back(timing(threads));
    }
  }
  for (auto& one : times)
  {
    std::sort(one.begin(), one.end());
  }
  const std::size_t middle = times[0].size() / 2;
  const double median = times[0][middle] / times[1][middle];
  std::printf("  %-68s %7.2f %7.2f", name.c_str(), median, times[0].front() / times[1].front());
  return median;
}

} // namespace

void RegisterFilterBenchmarks(const BallVolume& volume)
{
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const std::string name = solver == HapticSolver::Paper ? "PAPER" : "PRECISE";
    for (const bool withValue : { false, true })
    {
      const std::string variant = name + (withValue ? "_bare+value" : "_bare");
      benchmark::RegisterBenchmark(NameOf("filter", variant, "slide", volume.Name).c_str(),
        [&volume, solver, withValue](benchmark::State& bench)
        { Bare(bench, volume, solver, withValue); });
    }
    for (const char* arrays : { "all", "Force" })
    {
      benchmark::RegisterBenchmark(
        NameOf("filter", name + "_" + arrays, "slide", volume.Name).c_str(),
        [&volume, solver, arrays](benchmark::State& bench)
        { Whole(bench, volume, solver, arrays); });
    }
  }
}

void PrintThroughput(const BallVolume& volume, bool isQuick)
{
  const int paths = isQuick ? 8 : 64;
  const int repetitions = isQuick ? 1 : 15;
  constexpr double target = 1.9;
  std::printf("\n%-70s %7s %7s %7s\n", "Ticks a second on two threads beside one", "median", "best",
    "target");
  // Measure the largest speed-up on this machine, whose processors may share a core or have other
  // work.
  const double machine = PrintSpeedup("arithmetic alone", repetitions, TimeArithmetic);
  std::printf("\n");
  for (const HapticSolver solver : { HapticSolver::Paper, HapticSolver::Precise })
  {
    const auto lines = MakePaths(SlideFor(volume, 10000), paths);
    const auto filter = MakeFilter(volume, solver, lines);
    const auto timing = [&](int threads)
    {
      vtkSMPTools::Initialize(threads);
      return Time(filter);
    };
    const double median = PrintSpeedup(
      std::to_string(paths) + " paths, " + (solver == HapticSolver::Paper ? "PAPER" : "PRECISE"),
      repetitions, timing);
    std::printf(" %7.2f %s; %.2f of the arithmetic's\n", target,
      median >= target ? "reached" : "NOT reached", median / machine);
  }
  vtkSMPTools::Initialize();
}

} // namespace benchmarks
