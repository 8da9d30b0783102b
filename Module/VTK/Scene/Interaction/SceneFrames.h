// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides when to render the scene of an interaction, and whether quickly or finely.
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
 * Renders a frame if the tip or the proxy has visibly moved since the last frame, or if an event
 * has occurred; otherwise HapticRenderPace decides. Never renders a closed window, because that
 * would open a new one.
 */
class SceneFrames
{
public:
  /** `drawScene` renders the scene, quickly if its argument is true, otherwise finely. */
  SceneFrames(
    TouchedScene& scene, const HapticWindowWatch& window, std::function<void(bool)> drawScene);

  /** Sets the window whose rendering quality is adjusted; nullptr for none. */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false)
  {
    this->Quality.SetWindow(window, offScreen);
  }
  void Draw(bool quickly);
  /** Draws a fine frame that input can't interrupt. Returns false without an open window. */
  bool DrawWhole();
  /**
   * Renders a frame if one is due, and returns whether it did. Call this on each timer event.
   * `isNew`: whether the device has a new state.
   */
  bool DrawIfDue(bool isNew);
  /**
   * Returns whether a motion of the mouse in the touch mode should render a frame now, because
   * timers are late: see HapticRenderPace::IsLate. After a rest, first waits until the motion is
   * felt and the hand has arrived; `travel` is the time (s) that the hand needs.
   */
  bool AwaitLateMotion(double travel) const;
  /** Records an event, so that the next update renders a frame. */
  void RecordEvent() { this->HasHappened = true; }
  /** Shows a notice in the head-up display at once. */
  void Notify(const std::string& notice);

private:
  bool HasMoved() const;
  /** Returns whether it is known that no input waits. */
  bool IsIdle() const;
  /** Records an event if the editor has counted more values than the last frame shows. */
  void PollEditor();

  TouchedScene& Scene;
  const HapticWindowWatch& Window;
  const std::function<void(bool)> DrawScene;
  FrameQuality Quality;
  HapticRenderPace Pace;
  Vector3 DrawnTip; ///< tip in the last frame (world)
  Vector3 DrawnProxy;
  /** Fraction of the values that the editor had counted in the last frame. */
  double CountedFraction = 1.0;
  bool HasHappened = false;
};

} // namespace VolumeHaptics

#endif
