// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the positions at which the volumes are touched.
 */
#ifndef Motion_h
#define Motion_h

#include "BallVolume.h"
#include "Core/Servo/ServoTick.h"

#include <benchmark/benchmark.h>

#include <vector>

namespace benchmarks
{

/** Depth (mm) at which the tip is held below the surface. */
constexpr double Depth = 2.0;

/** Positions in index space, which are also mm. Some functions return m instead. */
using Positions = std::vector<VolumeHaptics::Vector3>;

/**
 * Returns positions once around the volume's centre, on a great circle oblique to all axes. Their
 * steps are 0.1 mm, which is 0.1 m/s at 1 kHz.
 */
Positions SlideAt(const BallVolume& volume, double radius);

/** A tip that slides along the ball's surface at the depth Depth. */
struct Slide
{
  explicit Slide(const BallVolume& volume);

  Positions Tips;                  ///< m, once around
  VolumeHaptics::ServoState Start; ///< state in contact, with the proxy on the surface

  /** Measures ticks, round after round. Returns the last tick's record. */
  VolumeHaptics::TickRecord Measure(
    benchmark::State& bench, const VolumeHaptics::HapticModel& model) const;
  /**
   * Returns whether the proxy slides in at least nine tenths of a round's ticks. It may stick for
   * single ticks.
   */
  bool IsSliding(const VolumeHaptics::HapticModel& model) const;
};

/**
 * Returns random positions away from the border. Their samples take far more memory than a cache
 * has.
 */
Positions Scattered(const BallVolume& volume);

/** Repeats positions endlessly. */
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
 * Returns a zero that depends on a result. If the zero is added to the next position, the processor
 * can't begin with that position before the result is known: a servo, too, waits for each tick.
 */
inline double Wait(double result)
{
  return 0.0 * result;
}

} // namespace benchmarks

#endif
