// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The touch mode, in which the mouse leads the virtual tip. It begins in front of the first
 * surface.
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

  /** See vtkInteractorStyleHaptic::SetTouchMode. */
  void Set(bool on);
  /** Begins the mode with a virtual tip at a position in the world. */
  void BeginAt(const Vector3& world) { this->Begin(&world); }
  bool IsOn() const { return this->IsTouching; }
  /** Ends the mode for a new device, without calling the old device. */
  void Reset() { this->IsTouching = this->IsPressed = false; }
  /**
   * If the touch mode is beginning, prevents it from arming the device. Call this if something has
   * disarmed the device.
   */
  void StopBeginning() { this->IsBeginning = false; }

  /** Returns whether the mouse leads the tip now. The functions below require it. */
  bool LeadsTip() const;
  /** Moves the tip towards a position in the world. */
  void LeadTo(const Vector3& world);
  /** Returns the target of the tip (world). */
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
  /** Returns the position of the pointer (pixels). */
  std::array<int, 2> FindPointer() const;
  /** Records a motion of the pointer. Call this also if another part of the window uses it. */
  void RecordMotion();
  /** Returns where the motion begins (pixels) that has led the pointer to its present position. */
  std::array<int, 2> TakeMotion();
  /** Zooms by a function, and pans the camera so that the hand stays where it is in the window. */
  void KeepInWindow(const std::function<void()>& zoom);

  /** Makes the next motion start from the hand's position, whatever the view has done meanwhile. */
  void ForgetView() { this->InView.fill(std::numeric_limits<double>::quiet_NaN()); }
  /** Returns whether the hand is outside the renderer's part of the window. */
  bool IsOutOfView() const;
  /** Returns the factor for motions of the mouse, which is smaller with Shift. */
  double GetFineness() const;
  /** Presses the device's button for the mouse's button, until it is released or the mode ends. */
  void PressButton();
  /** Releases the device's button. Returns false if it was not pressed. */
  bool ReleaseButton();

  /** A function that is called before the mode begins, to set TouchedScene::Hidden; may be null. */
  std::function<void()> BeforeBegin;
  /**
   * A function that is called before the tip lands on the first surface along the line of sight
   * through a position; may be null.
   */
  std::function<void(vtkRenderer* renderer, const Vector3& through)> BeforeLanding;

private:
  /**
   * Begins the mode at `at`, or if that is null, in front of the first surface under the pointer.
   */
  void Begin(const Vector3* at);
  double GetDepthStep() const;
  /**
   * Returns the position from which the next motion begins: the target, or if the window shows the
   * same view elsewhere since the last motion, the position that is now where the target was.
   */
  Vector3 FindStart(vtkRenderer* renderer) const;
  /** Returns whether the felt method has surfaces that the tip can follow. */
  bool HasSurfaces() const;
  /**
   * Returns the position on the surface to which the tip should go, for a target in the plane of
   * the view.
   */
  Vector3 ProjectOnSurface(vtkRenderer* renderer, const Vector3& target) const;

  TouchedScene& Scene;
  HapticWindowWatch& Window;
  const WorkspaceControl& Workspace;
  bool IsTouching = false;
  bool IsPressed = false;           ///< whether PressButton has pressed the button
  bool IsBeginning = false;         ///< whether Begin() is running and was not cancelled
  Vector3 Lead;                     ///< target of the tip (world)
  std::array<double, 2> InWindow{}; ///< where the last motion has led the target (pixels)
  std::array<double, 2> InView{};   ///< the same for the camera's view
  std::array<int, 2> From{};        ///< where the last motion of the pointer began (pixels)
  std::array<int, 2> To{};          ///< where it ended
  bool IsNew = false;               ///< whether the style got no motion since the mode began
};

} // namespace VolumeHaptics

#endif
