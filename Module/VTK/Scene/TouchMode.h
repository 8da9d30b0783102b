// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The touch mode: it begins in front of the first surface, and the mouse leads the virtual tip.
 */
#ifndef TouchMode_h
#define TouchMode_h

#include "VTK/Scene/TouchedScene.h"

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
  bool IsOn() const { return this->IsTouching; }
  /** For another device: off, without a word to the one that is gone. */
  void Reset() { this->IsTouching = false; }
  /** Something disarmed the device: a touch mode that is beginning does not arm it. */
  void StopBeginning() { this->IsBeginning = false; }

  /** Whether the mouse leads the tip now; the other two need that. */
  bool LeadsTip() const;
  /** Along the line of sight, away from the viewer; a step of the wheel is one. */
  void MoveInDepth(double steps);
  /** In the plane of the view, from one position of the pointer to another one (pixels). */
  void MoveInPlane(const int from[2], const int to[2]);

private:
  void Begin();
  double GetDepthStep() const;
  double GetFineness() const;
  void LeadTo(const Vector3& world);

  TouchedScene& Scene;
  HapticWindowWatch& Window;
  const WorkspaceControl& Workspace;
  bool IsTouching = false;
  bool IsBeginning = false; ///< Begin is under way, and nothing has ended it since
  Vector3 Lead;             ///< world; to which the mouse leads the tip
};

} // namespace VolumeHaptics

#endif
