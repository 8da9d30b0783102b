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

/** A tip that slides along the ball's surface at `Depth`. */
struct Slide
{
  explicit Slide(const BallVolume& volume);

  Positions Tips;                  ///< m, once around
  VolumeHaptics::ServoState Start; ///< state in contact, with the proxy on the surface

  /** Measures ticks for several rounds. Returns the last tick's record. */
  VolumeHaptics::TickRecord Measure(
    benchmark::State& bench, const VolumeHaptics::HapticModel& model) const;
  /**
   * Returns whether the proxy slides in at least nine tenths of a round's ticks. The proxy may
   * stick in single ticks.
   */
  bool IsSliding(const VolumeHaptics::HapticModel& model) const;
};

/**
 * Returns random positions away from the volume's border. Their samples need far more memory than a
 * cache has.
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
 * Returns a zero that depends on a result. Added to the next position, it makes the processor wait
 * for the result before it begins with that position, as a servo waits for each tick.
 */
inline double Wait(double result)
{
  return 0.0 * result;
}

} // namespace benchmarks

#endif
