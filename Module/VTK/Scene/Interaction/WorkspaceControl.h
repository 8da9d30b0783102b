// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps a real device's workspace in the scene: it follows the camera, and the clutch shifts it.
 */
#ifndef WorkspaceControl_h
#define WorkspaceControl_h

#include "VTK/Scene/Base/HapticWorkspace.h"
#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkType.h"

#include <functional>

namespace VolumeHaptics
{

class WorkspaceControl
{
public:
  /** `armsAfterClutch` tells whether force may come back when the clutch is released. */
  WorkspaceControl(TouchedScene& scene, std::function<bool()> armsAfterClutch);

  /** Releases the clutch of the device, which then stays without force. */
  void LeaveDevice();
  /** For another device: places the workspace again. */
  void Reset() { this->IsPlaced = false; }

  /**
   * Places the workspace if it follows the camera, and the camera or a setting has changed. Returns
   * true if it did; the device then has to be published.
   */
  bool Follow(vtkRenderer* renderer);

  /** World units per metre of the device. There must be a device. */
  double GetScale() const;
  void Recenter();

  /** See vtkInteractorStyleHaptic::SetClutch. */
  void SetClutch(bool on);
  bool IsClutched() const { return this->IsOn; }
  /** Another style with this device may have released its clutch: this one's goes on. */
  void KeepClutch();

private:
  TouchedScene& Scene;
  const std::function<bool()> ArmsAfterClutch;
  HapticWorkspace Workspace;
  vtkMTimeType Placed = 0; ///< change time of camera and settings at the last placement
  bool IsPlaced = false;
  bool IsOn = false;   ///< the clutch
  Vector3 ClutchedTip; ///< world
};

} // namespace VolumeHaptics

#endif
