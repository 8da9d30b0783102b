// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The touch mode: it begins in front of the first surface, and the mouse leads the virtual tip.
 */
#ifndef TouchMode_h
#define TouchMode_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include <functional>

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
  /** Ends the mode without calling the old device, for a new device. */
  void Reset() { this->IsTouching = this->IsPressed = false; }
  /**
   * Keeps a touch mode that is beginning from arming the device; call this if something disarmed
   * it.
   */
  void StopBeginning() { this->IsBeginning = false; }

  /** Whether the mouse leads the tip now. The next functions need this. */
  bool LeadsTip() const;
  /** Leads the tip to a position in the world. */
  void LeadTo(const Vector3& world);
  /** Returns the target of the tip (world). */
  const Vector3& GetLead() const { return this->Lead; }
  /** Returns the time (s) that the hand takes from the last seen tip to the target. */
  double GetTravelTime() const;
  /** Moves along the line of sight, away from the viewer; a step is one of the wheel. */
  void MoveInDepth(double steps);
  /**
   * Moves from one position of the pointer to the next (pixels): along the surface, or in the plane
   * of the view. See vtkInteractorStyleHaptic::SetTipFollowsSurface.
   */
  void MoveInPlane(const int from[2], const int to[2]);
  /** Returns the fraction of a motion that is made, which is smaller with Shift. */
  double GetFineness() const;
  /** Makes the mouse's button the device's button, until it is released or the mode ends. */
  void PressButton();
  /** Releases the button. False if it was not pressed. */
  bool ReleaseButton();

  /** Called before the mode begins, unless null, to set TouchedScene::Hidden. */
  std::function<void()> BeforeBegin;
  /**
   * Called, unless null, before a tip lands on the first surface along the line of sight through a
   * position.
   */
  std::function<void(vtkRenderer* renderer, const Vector3& through)> BeforeLanding;

private:
  /** Begins at `at`; if that is null, in front of the first surface under the pointer. */
  void Begin(const Vector3* at);
  double GetDepthStep() const;
  /** Whether the felt method has surfaces that the tip can follow. */
  bool HasSurfaces() const;
  /** Returns the tip's target on the surface, instead of a position in the plane of the view. */
  Vector3 ProjectOnSurface(vtkRenderer* renderer, const Vector3& target) const;

  TouchedScene& Scene;
  HapticWindowWatch& Window;
  const WorkspaceControl& Workspace;
  bool IsTouching = false;
  bool IsPressed = false;   ///< whether PressButton has pressed the button
  bool IsBeginning = false; ///< whether Begin runs, and nothing has cancelled it yet
  Vector3 Lead;             ///< world; target of the tip
};

} // namespace VolumeHaptics

#endif
