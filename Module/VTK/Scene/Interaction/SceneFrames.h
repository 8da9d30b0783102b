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
 * else HapticRenderPace decides. A window that was closed is not drawn, because that would open
 * another one.
 */
class SceneFrames
{
public:
  /** The function draws the scene, quickly (true) or finely. */
  SceneFrames(
    TouchedScene& scene, const HapticWindowWatch& window, std::function<void(bool)> drawScene);

  /** Adjusts how finely the volumes in this window are drawn; nullptr for none. */
  void SetWindow(vtkRenderWindow* window, bool offScreen = false)
  {
    this->Quality.SetWindow(window, offScreen);
  }
  void Draw(bool quickly);
  /**
   * Called by the timer: draws a frame if one is due, and tells whether. `isNew`: the device has a
   * new state.
   */
  bool DrawIfDue(bool isNew);
  /**
   * Whether a motion of the mouse that touches is to draw now, because timers are late:
   * HapticRenderPace::IsLate. If it is the first one after a rest, waits until it has been felt,
   * and for the hand to arrive, which takes the time `travel` (s).
   */
  bool AwaitLateMotion(double travel) const;
  /** Notes an event that the next frame has to show. */
  void NoteEvent() { this->HasHappened = true; }
  /** Shows a notice in the head-up display at once. */
  void Notify(const std::string& notice);

private:
  bool HasMoved() const;
  /** Whether it is known that no input waits. */
  bool IsIdle() const;
  /** Notes an event if the editor has counted more than the last frame shows. */
  void FollowEditor();

  TouchedScene& Scene;
  const HapticWindowWatch& Window;
  const std::function<void(bool)> DrawScene;
  FrameQuality Quality;
  HapticRenderPace Pace;
  Vector3 DrawnTip; ///< world, of the last frame
  Vector3 DrawnProxy;
  double CountedShare = 1.0; ///< of the editor, in the last frame
  bool HasHappened = false;
};

} // namespace VolumeHaptics

#endif
