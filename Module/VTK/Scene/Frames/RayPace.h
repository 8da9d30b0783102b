// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The distance between rays that keeps a frame short.
 */
#ifndef RayPace_h
#define RayPace_h

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{

/**
 * The distance between rays that keeps frames of one kind within a time. It changes in steps,
 * because a mapper whose distance changes makes new buffers.
 */
struct RayPace
{
  static constexpr double MostSteps = 6.0; ///< 8 pixels; a step multiplies the distance by sqrt(2)

  /** The distance for the next frame, pixels. `longest`: the most time for that frame, s. */
  double Next(double longest)
  {
    if (this->Time > longest || this->Time < 0.6 * longest)
    {
      // Assume that rays take all of the time: their number falls with the square of their
      // distance. Other drawing takes time, too; the next frames correct this.
      const double steps = std::log2(this->Time / longest);
      this->Steps = std::clamp(
        this->Steps + (steps > 0.0 ? std::ceil(steps) : std::trunc(steps)), 0.0, MostSteps);
      this->Time = longest; // assumed until the next frame's time is known
    }
    return std::exp2(0.5 * this->Steps);
  }
  /** Records the time of a frame with all its rays, s. */
  void Note(double time)
  {
    this->Time = time;
    this->IsKnown = true;
  }

  double Time = 0.05; ///< s, time of the last frame
  double Steps = 2.0;
  bool IsKnown = false; ///< whether the time was measured
};

} // namespace VolumeHaptics

#endif
