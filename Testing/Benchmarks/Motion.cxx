// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Motion.h"

#include <random>

using namespace VolumeHaptics;

namespace benchmarks
{

Positions SlideAt(const BallVolume& volume, double radius)
{
  const double pi = std::acos(-1.0);
  const Vector3 pole = (1.0 / std::sqrt(14.0)) * Vector3{ 1.0, 2.0, 3.0 };
  const Vector3 across = (1.0 / std::sqrt(5.0)) * Vector3{ 2.0, -1.0, 0.0 };
  const Vector3 along = Cross(pole, across);
  const int steps = static_cast<int>(2.0 * pi * radius / 0.1);
  Positions positions;
  for (int step = 0; step < steps; ++step)
  {
    const double angle = 2.0 * pi * step / steps;
    positions.push_back(
      volume.GetCentre() + radius * (std::cos(angle) * across + std::sin(angle) * along));
  }
  return positions;
}

Slide::Slide(const BallVolume& volume)
  : Tips(SlideAt(volume, BallRadius - Depth))
{
  for (Vector3& tip : this->Tips)
  {
    tip = 0.001 * tip;
  }
  this->Start.Proxy = 0.001 * SlideAt(volume, BallRadius).front();
  this->Start.PreviousTip = this->Tips.front();
  this->Start.Precise.ReachedTip = this->Start.Proxy;
  this->Start.Enabled = true;
}

TickRecord Slide::Measure(benchmark::State& bench, const HapticModel& model) const
{
  ServoState state = this->Start;
  TickRecord record;
  TickMemory memory;
  Cycle tip(this->Tips);
  for (auto _ : bench)
  {
    Tick(model, state, tip.Next(), record, LocalSurfaceResult::Simulated(), &memory);
    benchmark::DoNotOptimize(record);
    if (tip.IsAtStart())
    {
      state = this->Start; // resets the proxy, which would drift from its level in thousands of
                           // turns
    }
  }
  return record;
}

bool Slide::IsSliding(const HapticModel& model) const
{
  ServoState state = this->Start;
  TickRecord record;
  std::size_t sliding = 0;
  for (const Vector3& tip : this->Tips)
  {
    Tick(model, state, tip, record);
    sliding += record.Contact == ContactState::Sliding ? 1 : 0;
  }
  return 10 * sliding >= 9 * this->Tips.size();
}

Positions Scattered(const BallVolume& volume)
{
  constexpr double margin = 8.0;
  std::mt19937 random(2002);
  const auto along = [&](int axis)
  {
    const double last = static_cast<double>(volume.View.Dimensions[axis] - 1);
    return std::uniform_real_distribution<double>(margin, last - margin)(random);
  };
  Positions positions(1 << 16);
  for (Vector3& position : positions)
  {
    position.X = along(0);
    position.Y = along(1);
    position.Z = along(2);
  }
  return positions;
}

} // namespace benchmarks
