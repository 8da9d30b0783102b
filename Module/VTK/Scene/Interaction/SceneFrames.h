// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides when the scene of an interaction is drawn, and whether it is drawn quickly or finely.
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
 * Draws a frame if the tip or the proxy has visibly moved since the last frame, or if an event has
 * happened; otherwise HapticRenderPace decides. Does not draw a closed window, because drawing
 * would open another window.
 */
class SceneFrames
{
public:
  /** `drawScene` draws the scene, quickly (true) or finely. */
  SceneFrames(
    TouchedScene& scene, const HapticWindowWatch& window, std::function<void(bool)> drawScene);

  /** Sets the window in which the quality of volumes is adjusted; nullptr for no window. */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false)
  {
    this->Quality.SetWindow(window, offScreen);
  }
  void Draw(bool quickly);
  /** Draws a fine frame that no input interrupts. Returns false if there is no open window. */
  bool DrawWhole();
  /**
   * Draws a frame if one is due, and returns whether it did. The timer calls this. `isNew`: whether
   * the device has a new state.
   */
  bool DrawIfDue(bool isNew);
  /**
   * Returns whether a motion of the mouse in the touch mode should draw a frame now, because timers
   * are late: see HapticRenderPace::IsLate. After a rest, first waits until the motion has been
   * felt and the hand has arrived; `travel` is the time (s) that the hand needs.
   */
  bool AwaitLateMotion(double travel) const;
  /** Records an event that the next frame has to show. */
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
  Vector3 DrawnTip; ///< position in the last frame (world)
  Vector3 DrawnProxy;
  /** fraction of the values that the editor had counted in the last frame */
  double CountedFraction = 1.0;
  bool HasHappened = false;
};

} // namespace VolumeHaptics

#endif
