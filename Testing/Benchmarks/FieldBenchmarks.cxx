// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BareGather.h"
#include "Benchmarks.h"
#include "Motion.h"

#include <benchmark/benchmark.h>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/** Volume, kernel and motion of a measurement. */
struct Sampling
{
  const BallVolume& Volume;
  Estimator Gradient;
  bool IsRandom;
  InstructionSet Instructions;

  Positions GetPositions() const
  {
    return this->IsRandom ? Scattered(this->Volume) : SlideAt(this->Volume, BallRadius);
  }
};

void MeasureGradient(benchmark::State& bench, const Sampling& sampling)
{
  const GradientKernel kernel(sampling.Gradient.Kind, sampling.Gradient.Radius);
  const FieldSampler field(sampling.Volume.View, kernel, sampling.Instructions);
  const Positions positions = sampling.GetPositions();
  Cycle position(positions);
  double wait = 0.0;
  for (auto _ : bench)
  {
    Vector3 index = position.Next();
    index.X += wait;
    FieldSample sample = field.Gradient(index);
    benchmark::DoNotOptimize(sample);
    wait = sampling.IsRandom ? Wait(sample.Gradient.X) : 0.0;
  }
}

void MeasureValue(benchmark::State& bench, const Sampling& sampling)
{
  const GradientKernel kernel(sampling.Gradient.Kind, sampling.Gradient.Radius);
  const FieldSampler field(sampling.Volume.View, kernel, sampling.Instructions);
  const Positions positions = sampling.GetPositions();
  Cycle position(positions);
  double wait = 0.0;
  for (auto _ : bench)
  {
    Vector3 index = position.Next();
    index.X += wait;
    double value = field.Value(index);
    benchmark::DoNotOptimize(value);
    wait = sampling.IsRandom ? Wait(value) : 0.0;
  }
}

void MeasureGather(benchmark::State& bench, const Sampling& sampling)
{
  const VolumeView& view = sampling.Volume.View;
  const auto* const samples = static_cast<const std::int16_t*>(view.Data);
  const int taps = sampling.Gradient.Taps;
  std::vector<std::int64_t> corners;
  for (const Vector3& position : sampling.GetPositions())
  {
    const auto first = [&](double x) { return static_cast<std::int64_t>(x) - taps / 2 + 1; };
    corners.push_back(
      first(position.X) + first(position.Y) * view.Stride[1] + first(position.Z) * view.Stride[2]);
  }
  const Gather gather = SelectGather(taps);
  std::size_t step = 0;
  std::int64_t wait = 0;
  for (auto _ : bench)
  {
    step = step + 1 < corners.size() ? step + 1 : 0;
    std::int32_t sum = gather(samples + corners[step] + wait, view.Stride[1], view.Stride[2]);
    benchmark::DoNotOptimize(sum);
    wait = sampling.IsRandom ? static_cast<std::int64_t>(Wait(sum)) : 0;
  }
}

} // namespace

void RegisterFieldBenchmarks(const BallVolume& volume)
{
  const InstructionSet best = DetectInstructionSet();
  const auto add = [&](const std::string& subject, auto* function, const Sampling& sampling)
  {
    const std::string motion = sampling.IsRandom ? "random" : "slide";
    benchmark::RegisterBenchmark(
      NameOf(subject, sampling.Gradient.Name, motion, volume.Name).c_str(), function, sampling);
  };
  for (const Estimator& estimator : GetEstimators())
  {
    for (const bool isRandom : { false, true })
    {
      const Sampling sampling{ volume, estimator, isRandom, best };
      add("gradient", MeasureGradient, sampling);
      if (estimator.Taps > 0)
      {
        add("gather", MeasureGather, sampling);
      }
      // All estimators but the Gaussian interpolate values trilinearly.
      if (estimator.Kind != GradientEstimator::Gaussian)
      {
        add("value", MeasureValue, sampling);
      }
    }
    if (best != InstructionSet::Baseline)
    {
      add("baseline_gradient", MeasureGradient,
        { volume, estimator, false, InstructionSet::Baseline });
    }
  }
}

} // namespace benchmarks
