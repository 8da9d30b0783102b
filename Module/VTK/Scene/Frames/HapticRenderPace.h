// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides when and how finely to render a touched scene.
 */
#ifndef HapticRenderPace_h
#define HapticRenderPace_h

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

/**
 * Renders a moving scene at once, as coarsely as the interactive frame rate requires. If even such
 * a frame is slow, a gap follows it, unless it is known that no input waits. Without the gap,
 * timers, which come due with each event, would render a frame between any two waiting motions of
 * the mouse, and a key would wait for all of these frames. A scene that has come to rest is
 * rendered once, finely. After that, only numbers change. Drawing them may take a tenth of the
 * time, so that an application whose volume takes a second to render stays responsive.
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
  static constexpr double Shortest = 0.05; ///< s: shortest interval between frames at rest
  static constexpr double Slow = 0.05; ///< s: a frame in motion that takes longer is followed by a
                                       ///< gap
  static constexpr double LongestGap = 0.1; ///< s: longest gap after a frame
  /** s: after a frame slower than this, VTK's timer is late by its period. */
  static constexpr double LongestPeriod = 0.02;
  static constexpr double LongestStep = 0.05; ///< s: longest pause between two motions of one
                                              ///< stroke
  /** Time (s) from a motion to its frame: a few ticks, so that it is felt before it is drawn. */
  static constexpr double FeltTime = 0.004;
  static constexpr double LongestAwaited =
    0.03; ///< s: time in which the hand may move before the first frame of a stroke

  /**
   * Decides how to render at the time `now` (s). `moves`: whether anything has moved since the last
   * frame. `isNew`: whether numbers have changed. `isIdle`: whether it is known that no input
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
      // Wait longer after a slow frame, because motions during a frame are noticed only after it.
      const double rest = std::max(Pause, 0.5 * this->Cost);
      return now - this->LastDrawn >= rest ? Frame::Still : Frame::None;
    }
    const bool isDue = now - this->LastDrawn >= std::max(Shortest, 10.0 * this->Cost);
    return isNew && isDue ? Frame::Still : Frame::None;
  }

  /** Records a rendered frame, which ended at the time `now` (s) and took `cost` (s). */
  void Drawn(bool quickly, double now, double cost)
  {
    this->LastDrawn = now;
    this->IsStill = !quickly;
    (quickly ? this->QuickCost : this->Cost) = cost;
  }

  /**
   * Returns whether a motion of the mouse should render the frame itself because timers are late:
   * VTK's timers on X11 wait a whole period after a frame. Returns true only FeltTime after the
   * last frame, so that the hand feels the motion first.
   */
  bool IsLate(double now) const
  {
    const double elapsed = now - this->LastDrawn;
    return this->QuickCost > LongestPeriod && !this->IsStill && elapsed >= FeltTime &&
      elapsed <= LongestStep;
  }

  /**
   * Returns whether a motion of the mouse is the first one after a rest while timers are late.
   * Render such a motion FeltTime later.
   */
  bool IsFirst(double now) const
  {
    return this->QuickCost > LongestPeriod &&
      (this->IsStill || now - this->LastDrawn > LongestStep);
  }

  /**
   * Records that the last frame was interrupted or coarse, so that another frame is due after the
   * next rest.
   */
  void Interrupted(double now)
  {
    this->LastDrawn = now;
    this->IsStill = false;
  }

  /**
   * Records that the last frame was abandoned. If nothing moves, a coarser frame is due at once.
   */
  void GivenUp()
  {
    this->LastDrawn = -std::numeric_limits<double>::infinity();
    this->IsStill = false;
  }

private:
  double LastDrawn = 0.0;
  double Cost = 0.0;      ///< time (s) of the last frame at rest
  double QuickCost = 0.0; ///< time (s) of the last frame in motion
  bool IsStill = true;
};

} // namespace VolumeHaptics

#endif
