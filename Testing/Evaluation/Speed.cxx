// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Figure.h"
#include "Shapes.h"
#include "Tracking.h"

#include <algorithm>
#include <chrono>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
/** Returns the times (s) of ticks that slide around a ball, in ascending order. */
std::vector<double> TimeTicks(const Candidate& candidate, double millimetersPerTick, int ticks)
{
  const Volume volume([](const Vector3& x)
    { return BlurredStep(SphereRadius - Norm(x - OddCentre), 1.5, 1000.0); },
    { 27.0, { 1.0, 1.0, 1.0 }, ScalarType::Int16, 0.0, 1, false });
  const auto model =
    volume.Bake(TouchingOf(candidate, MakeMaterial(500.0, 0.2, 0.1, Impenetrable)));
  ServoState state;
  TickRecord record;
  Tick(*model, state, 0.001 * OnOddCircle(SphereRadius, 0.0), record);
  std::vector<double> times;
  for (int i = 0; i < ticks; ++i)
  {
    const Vector3 tip = 0.001 * OnOddCircle(18.0, millimetersPerTick / 18.0 * i);
    const auto start = std::chrono::steady_clock::now();
    Tick(*model, state, tip, record);
    times.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times;
}
} // namespace

Figures MeasureSpeed(const Candidate& candidate, const Effort& effort)
{
  const int ticks = effort.Pick(20000, 200000);
  const auto at = [](const std::vector<double>& times, double fraction) {
    return 1e6 * times[static_cast<std::size_t>(fraction * static_cast<double>(times.size() - 1))];
  };
  const std::vector<double> slow = TimeTicks(candidate, 0.1, ticks);
  const std::vector<double> paper =
    TimeTicks({ HapticSolver::Paper, candidate.Estimator }, 0.1, ticks);
  const std::vector<double> fast = TimeTicks(candidate, 1.0, ticks);
  return { { "tick in contact at 0.1 m/s, median", "us", at(slow, 0.5), 1.0, true },
    { "the same beside PAPER", "", at(slow, 0.5) / at(paper, 0.5), 4.0, true },
    { "PAPER's 99th percentile beside its median", "", at(paper, 0.99) / at(paper, 0.5), 2.0,
      true },
    { "tick in contact at 1 m/s, 99th percentile", "us", at(fast, 0.99), 10.0, true } };
}

} // namespace evaluation
