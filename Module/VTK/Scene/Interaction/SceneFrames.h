// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides when the scene of an interaction is drawn, and whether quickly or finely.
 */
#ifndef SceneFrames_h
#define SceneFrames_h

#include "VTK/Scene/Frames/FrameQuality.h"
#include "VTK/Scene/Frames/HapticRenderPace.h"
#include "VTK/Scene/Interaction/TouchedScene.h"

#include <functional>
#include <string>

namespace VolumeHaptics
{

class HapticWindowWatch;

/**
 * Draws if the tip or the proxy has moved visibly, or an event has happened, since the last frame;
 * else HapticRenderPace decides. A closed window is not drawn, because drawing would open another
 * window.
 */
class SceneFrames
{
public:
  /** `drawScene` draws the scene, quickly (true) or finely. */
  SceneFrames(
    TouchedScene& scene, const HapticWindowWatch& window, std::function<void(bool)> drawScene);

  /** Adjusts how finely the volumes in this window are drawn; nullptr for none. */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false)
  {
    this->Quality.SetWindow(window, offScreen);
  }
  void Draw(bool quickly);
  /**
   * Draws a frame if one is due, and returns whether it did; the timer calls this. `isNew`: the
   * device has a new state.
   */
  bool DrawIfDue(bool isNew);
  /**
   * Whether a motion of the mouse in the touch mode is to draw now, because timers are late:
   * HapticRenderPace::IsLate. After a rest, it first waits until the motion has been felt and the
   * hand has arrived, which takes `travel` (s).
   */
  bool AwaitLateMotion(double travel) const;
  /** Records an event that the next frame has to show. */
  void RecordEvent() { this->HasHappened = true; }
  /** Shows a notice in the head-up display at once. */
  void Notify(const std::string& notice);

private:
  bool HasMoved() const;
  /** Whether no input waits, as far as is known. */
  bool IsIdle() const;
  /** Records an event if the editor has counted more than the last frame shows. */
  void PollEditor();

  TouchedScene& Scene;
  const HapticWindowWatch& Window;
  const std::function<void(bool)> DrawScene;
  FrameQuality Quality;
  HapticRenderPace Pace;
  Vector3 DrawnTip; ///< world position in the last frame
  Vector3 DrawnProxy;
  double CountedFraction = 1.0; ///< counted fraction of the editor in the last frame
  bool HasHappened = false;
};

} // namespace VolumeHaptics

#endif
