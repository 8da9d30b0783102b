// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The positions at which the volumes are touched.
 */
#ifndef Motion_h
#define Motion_h

#include "BallVolume.h"
#include "Core/Servo/ServoTick.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace benchmarks
{

/** How deep the tip is held below the surface, mm. */
constexpr double Depth = 2.0;

/** Continuous indices, which are also mm, unless it is said that they are m. */
using Positions = std::vector<VolumeHaptics::Vector3>;

/**
 * Once around the volume's centre on a great circle oblique to all axes, 0.1 mm a step, which is
 * 0.1 m/s at 1 kHz.
 */
Positions SlideAt(const BallVolume& volume, double radius);

/** A tip that slides along the ball's surface, below it by Depth. */
struct Slide
{
  explicit Slide(const BallVolume& volume);

  Positions Tips;                  ///< m, once around
  VolumeHaptics::ServoState Start; ///< in contact, with the proxy on the surface

  /** Measures ticks, round after round, and returns the last one. */
  VolumeHaptics::TickRecord Measure(
    benchmark::State& bench, const VolumeHaptics::HapticModel& model) const;
  /** Whether the proxy slides in nine tenths of a round: it sticks for single ticks. */
  bool IsSliding(const VolumeHaptics::HapticModel& model) const;
};

/** Anywhere, but clear of the border. Touches far more memory than a cache holds. */
Positions Scattered(const BallVolume& volume);

/** Goes through positions again and again. */
class Cycle
{
public:
  explicit Cycle(const Positions& positions)
    : All(positions)
  {
  }

  const VolumeHaptics::Vector3& Next()
  {
    this->Step = this->Step + 1 < this->All.size() ? this->Step + 1 : 0;
    return this->All[this->Step];
  }
  bool IsAtStart() const { return this->Step == 0; }

private:
  const Positions& All;
  std::size_t Step = 0;
};

/**
 * A zero that depends on a result. Added to the next position it keeps the processor from starting
 * on that one early: out of the cache a servo waits for every one of its ticks.
 */
inline double Wait(double result)
{
  return 0.0 * result;
}

} // namespace benchmarks

#endif
