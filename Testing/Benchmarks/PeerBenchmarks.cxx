// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Motion.h"

#include <benchmark/benchmark.h>
#include <vtkImageInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProbeFilter.h>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/**
 * Number of positions for a value and a central-difference gradient: the position itself, and its
 * six neighbours.
 */
constexpr int StencilSize = 7;
constexpr double StencilReach = 2.0;

void PlaceStencil(const Vector3& position, double stencil[StencilSize][3])
{
  for (int point = 0; point < StencilSize; ++point)
  {
    stencil[point][0] = position.X;
    stencil[point][1] = position.Y;
    stencil[point][2] = position.Z;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    stencil[1 + 2 * axis][axis] -= StencilReach;
    stencil[2 + 2 * axis][axis] += StencilReach;
  }
}

void MeasureInterpolator(benchmark::State& bench, const BallVolume& volume, bool isRandom)
{
  vtkNew<vtkImageInterpolator> interpolator;
  interpolator->SetInterpolationModeToLinear();
  interpolator->Initialize(volume.Image);
  interpolator->Update();
  const Positions positions = isRandom ? Scattered(volume) : SlideAt(volume, BallRadius);
  Cycle position(positions);
  double wait = 0.0;
  for (auto _ : bench)
  {
    Vector3 index = position.Next();
    index.X += wait;
    double stencil[StencilSize][3];
    double values[StencilSize];
    PlaceStencil(index, stencil);
    for (int point = 0; point < StencilSize; ++point)
    {
      interpolator->InterpolateIJK(stencil[point], values + point);
    }
    benchmark::DoNotOptimize(values);
    wait = isRandom ? Wait(values[0]) : 0.0;
  }
}

void MeasureProbe(benchmark::State& bench, const BallVolume& volume)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(StencilSize);
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(input);
  probe->SetSourceData(volume.Image);
  const Positions positions = SlideAt(volume, BallRadius);
  Cycle position(positions);
  for (auto _ : bench)
  {
    double stencil[StencilSize][3];
    PlaceStencil(position.Next(), stencil);
    for (int point = 0; point < StencilSize; ++point)
    {
      points->SetPoint(point, stencil[point]);
    }
    points->Modified();
    probe->Update();
  }
}

} // namespace

void RegisterPeerBenchmarks(const BallVolume& volume)
{
  for (const bool isRandom : { false, true })
  {
    benchmark::RegisterBenchmark(
      NameOf("InterpolateIJK", "value+6", isRandom ? "random" : "slide", volume.Name).c_str(),
      MeasureInterpolator, volume, isRandom);
  }
  benchmark::RegisterBenchmark(
    NameOf("vtkProbeFilter", "value+6", "slide", volume.Name).c_str(), MeasureProbe, volume);
}

} // namespace benchmarks
