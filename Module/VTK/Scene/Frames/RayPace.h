// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How far apart rays are cast, so that a frame does not take too long.
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
  static constexpr double MostSteps = 6.0; ///< of a factor of the square root of two between rays

  /** For the next frame, pixels. `longest`: that it may take, s. */
  double Next(double longest)
  {
    if (this->Time > longest || this->Time < 0.6 * longest)
    {
      // As if all of the time were spent on rays, whose number falls with the square of their
      // distance. What else is drawn takes its time, so that the next frames may correct this.
      const double steps = std::log2(this->Time / longest);
      this->Steps = std::clamp(
        this->Steps + (steps > 0.0 ? std::ceil(steps) : std::trunc(steps)), 0.0, MostSteps);
      this->Time = longest; // until a frame tells
    }
    return std::exp2(0.5 * this->Steps);
  }
  /** Takes the time of a frame with all its rays, s. */
  void Note(double time)
  {
    this->Time = time;
    this->IsKnown = true;
  }

  double Time = 0.05; ///< that the last one took, s
  double Steps = 2.0;
  bool IsKnown = false; ///< the time was measured
};

} // namespace VolumeHaptics

#endif
