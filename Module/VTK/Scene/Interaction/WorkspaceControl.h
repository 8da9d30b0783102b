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
  /** `armsAfterClutch` returns whether force may come back when the clutch is released. */
  WorkspaceControl(TouchedScene& scene, std::function<bool()> armsAfterClutch);

  /** Releases the clutch of the device, and leaves the device without force. */
  void LeaveDevice();
  /** Places the workspace again, for a new device. */
  void Reset() { this->IsPlaced = false; }

  /**
   * Places the workspace if it follows the camera, and the camera or a setting has changed. Returns
   * whether it did; if so, publish the device.
   */
  bool Follow(vtkRenderer* renderer);

  /** World units per metre of the device. There must be a device. */
  double GetScale() const;
  void Recenter();

  /** See vtkInteractorStyleHaptic::SetClutch. */
  void SetClutch(bool on);
  bool IsClutched() const { return this->IsOn; }
  /** Keeps this style's clutch, which another style with this device may have released. */
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
