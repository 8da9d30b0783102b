// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * When to draw a scene that is touched, and how well.
 */
#ifndef HapticRenderPace_h
#define HapticRenderPace_h

#include <algorithm>

namespace VolumeHaptics
{

/**
 * A scene that moves is drawn at once and as coarsely as the interactive frame rate needs; one that
 * has come to rest, once and well. After that only figures change: drawing them may take a tenth of
 * the time, so that a volume that takes a second to draw leaves the application free.
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
  static constexpr double Pause = 0.3;     ///< s without movement that count as rest
  static constexpr double Shortest = 0.05; ///< s between frames at rest

  /**
   * Times in s. Moves: something has moved since the last frame. IsNew: figures have changed.
   */
  Frame Next(double now, bool moves, bool isNew)
  {
    if (moves)
    {
      return Frame::Quick;
    }
    if (!this->IsStill)
    {
      // A motion during a frame is seen only after it, so a slow frame waits for a longer rest.
      const double rest = std::max(Pause, 0.5 * this->Cost);
      return now - this->LastDrawn >= rest ? Frame::Still : Frame::None;
    }
    const bool isDue = now - this->LastDrawn >= std::max(Shortest, 10.0 * this->Cost);
    return isNew && isDue ? Frame::Still : Frame::None;
  }

  /** After a frame: when it was done, and how long it took. */
  void Drawn(bool quickly, double now, double cost)
  {
    this->LastDrawn = now;
    this->IsStill = !quickly;
    this->Cost = quickly ? this->Cost : cost;
  }

private:
  double LastDrawn = 0.0;
  double Cost = 0.0; ///< of a still frame, s
  bool IsStill = true;
};

} // namespace VolumeHaptics

#endif
