// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides when to draw a touched scene, and how finely.
 */
#ifndef HapticRenderPace_h
#define HapticRenderPace_h

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

/**
 * Draws a moving scene at once, as coarsely as the interactive frame rate needs. If a frame is slow
 * even so, a gap follows it, unless it is known that no input waits. The gap is needed because
 * timers come due with each event: without it, a frame would be drawn between any two waiting
 * motions of the mouse, and a key would wait for all of these frames.
 * A scene that has come to rest is drawn once, finely. After that only figures change. Drawing them
 * may take a tenth of the time, so that an application whose volume takes a second to draw stays
 * responsive.
 */
class HapticRenderPace
{
public:
  enum class Frame
  {
    None,
    Quick,
    Still
  };
  static constexpr double Pause = 0.3;     ///< s: time without movement that counts as rest
  static constexpr double Shortest = 0.05; ///< s: shortest time between frames at rest
  static constexpr double Slow = 0.05; ///< s: a quick frame that takes longer is followed by a gap
  static constexpr double LongestGap = 0.1; ///< s: longest gap after a frame
  /** s: after a slower frame, VTK's timer is late by its period */
  static constexpr double LongestPeriod = 0.02;
  static constexpr double LongestStep = 0.05; ///< s: longest time between two motions of one stroke
  static constexpr double FeltTime = 0.004;   ///< s: time of a few ticks, in which a motion is felt
  static constexpr double LongestAwaited =
    0.03; ///< s: time for the hand to move before the first frame of a stroke

  /**
   * Decides how to draw at the time `now` (s). `moves`: whether something has moved since the last
   * frame. `isNew`: whether figures have changed. `isIdle`: whether it is known that no input
   * waits.
   */
  Frame Next(double now, bool moves, bool isNew, bool isIdle = false)
  {
    if (moves)
    {
      const double gap =
        this->QuickCost > Slow && !isIdle ? std::min(0.25 * this->QuickCost, LongestGap) : 0.0;
      return now - this->LastDrawn >= gap ? Frame::Quick : Frame::None;
    }
    if (!this->IsStill)
    {
      // Wait longer after a slow frame, because a motion during a frame is noticed only after it.
      const double rest = std::max(Pause, 0.5 * this->Cost);
      return now - this->LastDrawn >= rest ? Frame::Still : Frame::None;
    }
    const bool isDue = now - this->LastDrawn >= std::max(Shortest, 10.0 * this->Cost);
    return isNew && isDue ? Frame::Still : Frame::None;
  }

  /** Records a drawn frame. `now`: when the frame ended (s). `cost`: how long drawing took (s). */
  void Drawn(bool quickly, double now, double cost)
  {
    this->LastDrawn = now;
    this->IsStill = !quickly;
    (quickly ? this->QuickCost : this->Cost) = cost;
  }

  /**
   * Returns whether a motion of the mouse should draw the frame itself, because timers are late:
   * VTK's timers on X11 wait their whole period after a frame. It is true only FeltTime after the
   * last frame, so that the hand has felt the motion before.
   */
  bool IsLate(double now) const
  {
    const double elapsed = now - this->LastDrawn;
    return this->QuickCost > LongestPeriod && !this->IsStill && elapsed >= FeltTime &&
      elapsed <= LongestStep;
  }

  /**
   * Returns whether a motion of the mouse is the first one after a rest while timers are late. Such
   * a motion is drawn FeltTime later.
   */
  bool IsFirst(double now) const
  {
    return this->QuickCost > LongestPeriod &&
      (this->IsStill || now - this->LastDrawn > LongestStep);
  }

  /**
   * Records that the last frame was interrupted or coarse, so that a frame is due after the next
   * rest.
   */
  void Interrupted(double now)
  {
    this->LastDrawn = now;
    this->IsStill = false;
  }

  /** Records that the last frame was given up. If nothing moves, a coarser frame is due at once. */
  void GivenUp()
  {
    this->LastDrawn = -std::numeric_limits<double>::infinity();
    this->IsStill = false;
  }

private:
  double LastDrawn = 0.0;
  double Cost = 0.0;      ///< time that the last frame at rest took (s)
  double QuickCost = 0.0; ///< time that the last frame in motion took (s)
  bool IsStill = true;
};

} // namespace VolumeHaptics

#endif
