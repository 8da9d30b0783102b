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
  /** For another device: ends the mode without calling the old device. */
  void Reset() { this->IsTouching = this->IsPressed = false; }
  /**
   * Call it if something disarmed the device: a touch mode that is beginning does not arm it then.
   */
  void StopBeginning() { this->IsBeginning = false; }

  /** Whether the mouse leads the tip now; the next functions need that. */
  bool LeadsTip() const;
  /** Leads the tip to a position in the world. */
  void LeadTo(const Vector3& world);
  /** Where the tip is led to (world). */
  const Vector3& GetLead() const { return this->Lead; }
  /** How long the hand takes from the tip that was last seen to there, s. */
  double GetTravelTime() const;
  /** Moves along the line of sight, away from the viewer; one step is one of the wheel. */
  void MoveInDepth(double steps);
  /**
   * Moves from one position of the pointer to another one (pixels): along the surface, or in the
   * plane of the view. See vtkInteractorStyleHaptic::SetTipFollowsSurface.
   */
  void MoveInPlane(const int from[2], const int to[2]);
  /** The share of a motion that is made: less with Shift. */
  double GetFineness() const;
  /** The mouse's button is that of the device, until it is released or the mode ends. */
  void PressButton();
  /** False if it was not pressed. */
  bool ReleaseButton();

  /** Called, if there is one, before the mode begins: it sets TouchedScene::Hidden. */
  std::function<void()> BeforeBegin;
  /** Called, if there is one, before a tip lands on what is along the line of sight there. */
  std::function<void(vtkRenderer* renderer, const Vector3& through)> BeforeLanding;

private:
  /** Where `at` tells; or if it is null, in front of the first surface under the pointer. */
  void Begin(const Vector3* at);
  double GetDepthStep() const;
  /** Whether the touched method has surfaces that the tip can follow. */
  bool HasSurfaces() const;
  /** Where the tip goes instead of to a position in the plane of the view. */
  Vector3 FollowSurface(vtkRenderer* renderer, const Vector3& target) const;

  TouchedScene& Scene;
  HapticWindowWatch& Window;
  const WorkspaceControl& Workspace;
  bool IsTouching = false;
  bool IsPressed = false;   ///< the button, by PressButton
  bool IsBeginning = false; ///< Begin runs, and nothing has ended it yet
  Vector3 Lead;             ///< world; the target of the tip
};

} // namespace VolumeHaptics

#endif
