// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Implements the touch mode, in which the mouse moves the virtual tip, starting in front of the
 * first surface.
 */
#ifndef TouchMode_h
#define TouchMode_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include <array>
#include <functional>
#include <limits>

namespace VolumeHaptics
{

class HapticWindowWatch;
class WorkspaceControl;

class TouchMode
{
public:
  TouchMode(TouchedScene& scene, HapticWindowWatch& window, const WorkspaceControl& workspace)
    : Scene(scene)
    , Window(window)
    , Workspace(workspace)
  {
  }

  /** Switches the touch mode: see vtkInteractorStyleHaptic::SetTouchMode. */
  void Set(bool on);
  /** Begins the mode with a virtual tip at a position in the world. */
  void BeginAt(const Vector3& world) { this->Begin(&world); }
  bool IsOn() const { return this->IsTouching; }
  /** Ends the mode for a new device, without a call to the old one. */
  void Reset() { this->IsTouching = this->IsPressed = false; }
  /**
   * Cancels a start of the touch mode in progress, before it arms the device. Call this when
   * something has disarmed the device.
   */
  void StopBeginning() { this->IsBeginning = false; }

  /** Returns whether the mouse moves the tip now. The functions below require it. */
  bool LeadsTip() const;
  /** Moves the tip towards a position in the world. */
  void LeadTo(const Vector3& world);
  /** Returns the position (world) that the tip is moving to. */
  const Vector3& GetLead() const { return this->Lead; }
  /** Returns the time (s) that the hand needs from the last known tip to the target. */
  double GetTravelTime() const;
  /** Moves the tip along the line of sight, away from the viewer, by steps of the wheel. */
  void MoveInDepth(double steps);
  /**
   * Moves the tip as the pointer moves from one position to the next (pixels): along the surface,
   * or in the plane of the view. See vtkInteractorStyleHaptic::SetTipFollowsSurface.
   */
  void MoveInPlane(const std::array<int, 2>& from, const std::array<int, 2>& to);
  /** Returns the pointer's position (pixels). */
  std::array<int, 2> FindPointer() const;
  /** Records a motion of the pointer, even if another part of the window uses it. */
  void RecordMotion();
  /** Returns the start (pixels) of the motion that ended at the pointer's present position. */
  std::array<int, 2> TakeMotion();
  /**
   * Zooms with a function, and then pans the camera so that the hand stays in place in the window.
   */
  void KeepInWindow(const std::function<void()>& zoom);

  /** Makes the next motion start from the hand's position, even if the view has changed. */
  void ForgetView() { this->InView.fill(std::numeric_limits<double>::quiet_NaN()); }
  /** Returns whether the hand is outside the renderer's viewport. */
  bool IsOutOfView() const;
  /** Returns the factor on mouse motions, which is smaller with Shift. */
  double GetFineness() const;
  /** Presses the device's button, until the mouse's button is released or the mode ends. */
  void PressButton();
  /** Releases the device's button. Returns false if it was not pressed. */
  bool ReleaseButton();

  /** Called before the mode begins, to set TouchedScene::Hidden; may be null. */
  std::function<void()> BeforeBegin;
  /**
   * Called before the tip lands on the first surface along the line of sight through a position;
   * may be null.
   */
  std::function<void(vtkRenderer* renderer, const Vector3& through)> BeforeLanding;

private:
  /**
   * Begins the mode at a position, or, if `at` is null, in front of the first surface under the
   * pointer.
   */
  void Begin(const Vector3* at);
  double GetDepthStep() const;
  /**
   * Returns the position from which the next motion starts: the target, or, if the window shows the
   * same view in another place since the last motion, the position that is now where the target
   * was.
   */
  Vector3 FindStart(vtkRenderer* renderer) const;
  /** Returns whether the felt method has surfaces that the tip can follow. */
  bool HasSurfaces() const;
  /**
   * Returns the position on the surface that the tip should move to, for a target in the plane of
   * the view.
   */
  Vector3 ProjectOnSurface(vtkRenderer* renderer, const Vector3& target) const;

  TouchedScene& Scene;
  HapticWindowWatch& Window;
  const WorkspaceControl& Workspace;
  bool IsTouching = false;
  bool IsPressed = false;           ///< whether PressButton() is in effect
  bool IsBeginning = false;         ///< whether Begin() is running and was not cancelled
  Vector3 Lead;                     ///< target of the tip (world)
  std::array<double, 2> InWindow{}; ///< target in the window (pixels) after the last motion
  std::array<double, 2> InView{};   ///< target in the camera's view after the last motion
  std::array<int, 2> From{};        ///< start of the last pointer motion (pixels)
  std::array<int, 2> To{};          ///< end of that motion
  bool IsNew = false;               ///< whether the style has received no motion since the mode
                                    ///< began
};

} // namespace VolumeHaptics

#endif
