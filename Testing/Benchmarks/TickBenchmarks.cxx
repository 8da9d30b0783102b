// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks.h"
#include "Motion.h"

#include <benchmark/benchmark.h>

#include <algorithm>

using namespace VolumeHaptics;

namespace benchmarks
{
namespace
{

/**
 * The parts of a model. Each benchmark makes its model when it runs, so that no other model takes
 * memory or cache.
 */
struct Scene
{
  const BallVolume& Volume;
  Estimator Gradient;
  HapticMethod Method;
  HapticSolver Solver = HapticSolver::Paper;
  bool IsPlacedAsThePaper = false;
};

void MeasureSlide(benchmark::State& bench, const Scene& scene)
{
  ModelChoice choice;
  choice.Method = scene.Method;
  choice.Solver = scene.Solver;
  choice.IsPlacedAsThePaper = scene.IsPlacedAsThePaper;
  const auto model = MakeModel(scene.Volume, scene.Gradient, choice);
  const Slide slide(scene.Volume);
  slide.Measure(bench, *model);
  if (scene.Method == HapticMethod::Proxy && !slide.IsSliding(*model))
  {
    bench.SkipWithError("the proxy does not slide");
  }
}

/** Whether time steps have displacements, which describe the material's motion. */
enum class Displacements
{
  None,
  Given
};

/**
 * A ball that grows and shrinks by 1 mm in 50 ms, as a time span of three time steps.
 */
class Beating
{
public:
  Beating(const BallVolume& volume, Displacements displacements)
  {
    const auto* const from = static_cast<const std::int16_t*>(volume.View.Data);
    const std::int64_t* const n = volume.View.Dimensions;
    this->Grown.assign(from, from + n[0] * n[1] * n[2]);
    for (std::int16_t& sample : this->Grown)
    {
      sample = static_cast<std::int16_t>(sample + 10); // V falls by 10 per mm at the surface
    }
    VolumeView grown = volume.View;
    grown.Data = this->Grown.data();
    this->TimeSteps = { { 0.0, volume.View, nullptr }, { FrameTime, grown, nullptr },
      { 2.0 * FrameTime, volume.View, nullptr } };
    if (displacements == Displacements::Given)
    {
      this->FillMotion(volume);
      for (std::size_t i = 0; i < 2; ++i)
      {
        this->TimeSteps[i].Displacements = { this->Motion[i].data(), ScalarType::Float32 };
      }
    }
  }

  static constexpr double FrameTime = 0.05;
  std::vector<VolumeTimeStep> TimeSteps;

private:
  /**
   * Fills in displacements: outwards by 1 mm in the first time step, inwards in the second, and
   * zero at the centre.
   */
  void FillMotion(const BallVolume& volume)
  {
    const std::int64_t* const n = volume.View.Dimensions;
    for (std::vector<float>& motion : this->Motion)
    {
      motion.reserve(static_cast<std::size_t>(3 * n[0] * n[1] * n[2]));
    }
    const Vector3 middle = 0.5 * Vector3{ double(n[0] - 1), double(n[1] - 1), double(n[2] - 1) };
    for (std::int64_t k = 0; k < n[2]; ++k)
    {
      for (std::int64_t j = 0; j < n[1]; ++j)
      {
        for (std::int64_t i = 0; i < n[0]; ++i)
        {
          const Vector3 out = Vector3{ double(i), double(j), double(k) } - middle;
          const Vector3 u = (1.0 / std::max(Norm(out), 4.0)) * out;
          for (const double component : { u.X, u.Y, u.Z })
          {
            this->Motion[0].push_back(static_cast<float>(component));
            this->Motion[1].push_back(static_cast<float>(-component));
          }
        }
      }
    }
  }

  std::vector<std::int16_t> Grown;
  std::vector<float> Motion[2]; ///< displacements, world units
};

void MeasureBlended(benchmark::State& bench, const Scene& scene, Displacements displacements)
{
  const Beating beating(scene.Volume, displacements);
  ModelChoice choice;
  choice.Method = scene.Method;
  choice.Solver = scene.Solver;
  choice.TimeSteps = beating.TimeSteps;
  const auto model = MakeModel(scene.Volume, scene.Gradient, choice);
  const Slide slide(scene.Volume);
  ServoState state = slide.Start;
  TickRecord record;
  TickMemory memory;
  Cycle tip(slide.Tips);
  double step = 0.001;
  for (auto _ : bench)
  {
    // Let the time oscillate through the time span, so that it never jumps.
    step = state.DataTime + step > 2.0 * Beating::FrameTime || state.DataTime + step < 0.0 ? -step
                                                                                           : step;
    state.DataTime += step;
    Tick(*model, state, tip.Next(), record, LocalSurfaceResult::Simulated(), &memory);
    benchmark::DoNotOptimize(record);
    if (tip.IsAtStart())
    {
      const double time = state.DataTime;
      state = slide.Start;
      state.DataTime = state.CarriedTo = time;
    }
  }
  if (bench.iterations() > 1000 && record.Contact != ContactState::Sliding)
  {
    bench.SkipWithError("the proxy does not slide");
  }
}

void MeasureInPlace(benchmark::State& bench, const Scene& scene)
{
  MeasureBlended(bench, scene, Displacements::None);
}

void MeasureDisplaced(benchmark::State& bench, const Scene& scene)
{
  MeasureBlended(bench, scene, Displacements::Given);
}

void Jump(benchmark::State& bench, const Scene& scene)
{
  const auto model = MakeModel(scene.Volume, scene.Gradient, { scene.Method });
  const Positions positions = Scattered(scene.Volume);
  const Vector3 lag = 0.001 * Depth / std::sqrt(3.0) * Vector3{ 1.0, 1.0, 1.0 };
  ServoState state;
  state.Enabled = true;
  TickRecord record;
  Cycle proxy(positions);
  for (auto _ : bench)
  {
    state.Proxy = 0.001 * proxy.Next();
    state.Proxy.X += Wait(record.Force.X);
    Tick(*model, state, state.Proxy + lag, record);
    benchmark::DoNotOptimize(record);
  }
}

} // namespace

void RegisterTickBenchmarks(const BallVolume& volume)
{
  for (const Estimator& estimator : GetEstimators())
  {
    const Scene scene{ volume, estimator, HapticMethod::Proxy };
    benchmark::RegisterBenchmark(
      NameOf("tick", estimator.Name, "slide", volume.Name).c_str(), MeasureSlide, scene);
    benchmark::RegisterBenchmark(
      NameOf("tick", estimator.Name, "random", volume.Name).c_str(), Jump, scene);
    benchmark::RegisterBenchmark(
      NameOf("precise_tick", estimator.Name, "slide", volume.Name).c_str(), MeasureSlide,
      Scene{ volume, estimator, HapticMethod::Proxy, HapticSolver::Precise });
    if (volume.Name == "256^3")
    {
      benchmark::RegisterBenchmark(
        NameOf("blended_tick", estimator.Name, "slide", volume.Name).c_str(), MeasureInPlace,
        Scene{ volume, estimator, HapticMethod::Proxy, HapticSolver::Precise });
      benchmark::RegisterBenchmark(
        NameOf("blended_paper_tick", estimator.Name, "slide", volume.Name).c_str(), MeasureInPlace,
        scene);
      benchmark::RegisterBenchmark(
        NameOf("displaced_tick", estimator.Name, "slide", volume.Name).c_str(), MeasureDisplaced,
        Scene{ volume, estimator, HapticMethod::Proxy, HapticSolver::Precise });
    }
    benchmark::RegisterBenchmark(
      NameOf("placed_as_paper_tick", estimator.Name, "slide", volume.Name).c_str(), MeasureSlide,
      Scene{ volume, estimator, HapticMethod::Proxy, HapticSolver::Precise, true });
    benchmark::RegisterBenchmark(
      NameOf("force_field_tick", estimator.Name, "slide", volume.Name).c_str(), MeasureSlide,
      Scene{ volume, estimator, HapticMethod::ForceField });
  }
}

} // namespace benchmarks
