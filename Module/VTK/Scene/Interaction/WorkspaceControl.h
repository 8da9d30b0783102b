// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Places a real device's workspace in the scene, where it follows the camera and is shifted with
 * the clutch.
 */
#ifndef WorkspaceControl_h
#define WorkspaceControl_h

#include "Core/Math/Vector3.h"
#include "VTK/Scene/Interaction/TouchedScene.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <functional>

class vtkCamera;
class vtkRenderer;

namespace VolumeHaptics
{

/** Returns a matrix whose rows are the camera's axes: right, up and backward (towards the user). */
Matrix3 CameraAxes(vtkCamera* camera);

/**
 * Turns the volume about the focal point, from the user's view, by moving the camera the opposite
 * way. The rate (rad/s) refers to the camera's axes. Limits the time step to 0.1 s, so that the
 * view does not jump after a pause of the timer. Returns false if nothing turns.
 */
bool TurnView(vtkRenderer* renderer, const Vector3& rate, double seconds, bool resetsClippingRange);

/**
 * Maps the workspace of a device into the scene, fixed to the camera.
 *
 * The device's axes x, y and z point to the right, up and towards the user on the screen. The
 * device's origin is at the camera's focal point plus an offset along the camera's axes, so that
 * the clutch's shift turns with the view.
 */
class HapticWorkspace
{
public:
  /**
   * Returns the map from the device's positions (m) to the world. `scale` is in world units per
   * metre.
   */
  vtkMatrix4x4* Place(vtkCamera* camera, double scale);

  /**
   * Shifts the workspace by a motion of the hand from one world position to another. Call this when
   * the clutch is released.
   */
  void Shift(vtkCamera* camera, const Vector3& from, const Vector3& to);
  void Recenter() { this->Offset = {}; }

private:
  Vector3 Offset; // offset of the workspace (world units, along the camera's axes)
  vtkNew<vtkMatrix4x4> DeviceToWorld;
};

class WorkspaceControl
{
public:
  /** `armsAfterClutch` returns whether the force may come back when the clutch is released. */
  WorkspaceControl(TouchedScene& scene, std::function<bool()> armsAfterClutch);

  /** Releases the clutch of the device and leaves the device disarmed. */
  void LeaveDevice();
  /** Makes the next Update() place the workspace, for a new device. */
  void Reset() { this->IsPlaced = false; }

  /**
   * Places the workspace if it follows the camera, and if the camera or a setting has changed.
   * Returns whether it was placed; the device must then be published.
   */
  bool Update(vtkRenderer* renderer);

  /** Returns the scale of the device in world units per metre. Requires a device. */
  double GetScale() const;
  void Recenter();

  /** Switches the clutch: see vtkInteractorStyleHaptic::SetClutch. */
  void SetClutch(bool on);
  bool IsClutched() const { return this->IsOn; }
  /** Turns this style's clutch on again if another style with the same device has released it. */
  void KeepClutch();

private:
  TouchedScene& Scene;
  const std::function<bool()> ArmsAfterClutch;
  HapticWorkspace Workspace;
  /** Change time of camera and settings when the workspace was last placed. */
  vtkMTimeType Placed = 0;
  bool IsPlaced = false;
  bool IsOn = false;   ///< whether the clutch is on
  Vector3 ClutchedTip; ///< tip (world) when the clutch was engaged
};

} // namespace VolumeHaptics

#endif
