// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Roughness.h"

#include "Shapes.h"

#include <numeric>

namespace evaluation
{
namespace
{
constexpr double TicksPerSecond = 1000.0;
constexpr std::size_t LeastTicks = 100;
constexpr std::size_t Window = 5; // ticks, within which a drop occurs
constexpr double Fall = 0.3;
constexpr double LeastForce = 0.05; // N: smaller forces are imperceptible
constexpr double ReversalFraction = 0.05;

/** Returns the root mean square of a signal in a frequency band (Hz), without the signal's mean. */
double ComputeBand(const std::vector<double>& signal, double low, double high)
{
  const std::size_t count = signal.size();
  const auto n = static_cast<double>(count);
  std::vector<double> windowed(count);
  double weight = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double w = 0.5 - 0.5 * std::cos(TwoPi * static_cast<double>(i) / n);
    windowed[i] = w * signal[i];
    weight += w * w;
  }
  // Use Goertzel's algorithm for several spectral lines at once.
  constexpr std::size_t lanes = 8;
  double power = 0.0;
  const double step = TicksPerSecond / n;
  const auto last = static_cast<std::size_t>(std::ceil(high / step));
  for (auto line = static_cast<std::size_t>(std::ceil(low / step)); line < last; line += lanes)
  {
    double turn[lanes];
    double one[lanes] = {};
    double two[lanes] = {};
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      turn[lane] = 2.0 * std::cos(TwoPi * static_cast<double>(line + lane) / n);
    }
    for (const double sample : windowed)
    {
      for (std::size_t lane = 0; lane < lanes; ++lane)
      {
        const double next = sample + turn[lane] * one[lane] - two[lane];
        two[lane] = one[lane];
        one[lane] = next;
      }
    }
    for (std::size_t lane = 0; lane < lanes && line + lane < last; ++lane)
    {
      power += 2.0 *
        (one[lane] * one[lane] + two[lane] * two[lane] - turn[lane] * one[lane] * two[lane]) /
        (n * weight);
    }
  }
  return std::sqrt(power);
}

/** Counts how often the force rises by a threshold after a fall by at least the same amount. */
int CountReversals(const std::vector<double>& force, double threshold)
{
  int reversals = 0;
  bool falls = false;
  double extreme = force.front();
  for (const double f : force)
  {
    extreme = falls ? std::min(extreme, f) : std::max(extreme, f);
    if (std::abs(f - extreme) > threshold)
    {
      reversals += falls ? 1 : 0;
      falls = !falls;
      extreme = f;
    }
  }
  return reversals;
}
} // namespace

std::vector<std::size_t> DetectDrops(const std::vector<double>& force)
{
  std::vector<std::size_t> drops;
  for (std::size_t i = Window; i < force.size(); ++i)
  {
    if (force[i - Window] > LeastForce && force[i] < (1.0 - Fall) * force[i - Window])
    {
      drops.push_back(i);
      i += 4 * Window; // do not count this fall twice
    }
  }
  return drops;
}

Roughness MeasureRoughness(const std::vector<double>& force)
{
  Roughness found;
  if (force.size() < LeastTicks)
  {
    return found;
  }
  const double mean =
    std::accumulate(force.begin(), force.end(), 0.0) / static_cast<double>(force.size());
  if (mean < LeastForce)
  {
    return found;
  }
  found.Duration = static_cast<double>(force.size()) / TicksPerSecond;
  found.Mean = mean;
  std::vector<double> rest = force;
  for (double& f : rest)
  {
    f -= mean;
  }
  found.Low = 100.0 / mean * ComputeBand(rest, 30.0, 100.0);
  found.High = 100.0 / mean * ComputeBand(rest, 100.0, 500.0);
  found.Both = std::hypot(found.Low, found.High);
  found.Drops = static_cast<int>(DetectDrops(force).size());
  found.Reversals = CountReversals(force, ReversalFraction * mean);
  for (std::size_t i = 1; i < force.size(); ++i)
  {
    found.LargestStep = std::max(found.LargestStep, std::abs(force[i] - force[i - 1]));
  }
  return found;
}

Roughness Average(const std::vector<Roughness>& strokes)
{
  Roughness all;
  for (const Roughness& one : strokes)
  {
    all.Duration += one.Duration;
    all.Mean += one.Duration * one.Mean;
    all.Low += one.Duration * one.Low;
    all.High += one.Duration * one.High;
    all.Both += one.Duration * one.Both;
    all.Drops += one.Drops;
    all.Reversals += one.Reversals;
    all.LargestStep = std::max(all.LargestStep, one.LargestStep);
  }
  if (all.Duration > 0.0)
  {
    all.Mean /= all.Duration;
    all.Low /= all.Duration;
    all.High /= all.Duration;
    all.Both /= all.Duration;
  }
  return all;
}

} // namespace evaluation
