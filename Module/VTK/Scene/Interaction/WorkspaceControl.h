// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Places a real device's workspace in the scene: it follows the camera, and the clutch shifts it.
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

/**
 * Returns a matrix whose rows are the camera's directions right, up and backward (towards the
 * user).
 */
Matrix3 CameraAxes(vtkCamera* camera);

/**
 * Turns the volume about the focal point, as seen by the user, by moving the camera the other way.
 * The rate (rad/s) is along the camera's axes. At most 0.1 s of the time count, so that the view
 * does not jump after a pause of the timer. Returns false if nothing turns.
 */
bool TurnView(vtkRenderer* renderer, const Vector3& rate, double seconds, bool resetsClippingRange);

/**
 * The workspace of a device in the scene, fixed to the camera.
 *
 * The device's axes x, y and z point to the right, up and towards the user on the screen. The
 * device's origin lies at the camera's focal point plus an offset along the camera's axes, so that
 * the clutch's shift turns with the view.
 */
class HapticWorkspace
{
public:
  /**
   * Returns the map from the device's positions (m) to the world, for a scale in world units per
   * metre.
   */
  vtkMatrix4x4* Place(vtkCamera* camera, double scale);

  /**
   * Moves the workspace by the motion of the hand from one world position to another. Call it when
   * the clutch is released.
   */
  void Shift(vtkCamera* camera, const Vector3& from, const Vector3& to);
  void Recenter() { this->Offset = {}; }

private:
  Vector3 Offset; // world units, along the camera's axes
  vtkNew<vtkMatrix4x4> DeviceToWorld;
};

class WorkspaceControl
{
public:
  /** `armsAfterClutch` returns whether force may come back when the clutch is released. */
  WorkspaceControl(TouchedScene& scene, std::function<bool()> armsAfterClutch);

  /** Releases the clutch of the device, and leaves the device disarmed. */
  void LeaveDevice();
  /** Places the workspace again, for a new device. */
  void Reset() { this->IsPlaced = false; }

  /**
   * Places the workspace if it follows the camera, and if the camera or a setting has changed.
   * Returns whether it was placed; if so, publish the device.
   */
  bool Update(vtkRenderer* renderer);

  /** Returns the world units per metre of the device. There must be a device. */
  double GetScale() const;
  void Recenter();

  /** See vtkInteractorStyleHaptic::SetClutch. */
  void SetClutch(bool on);
  bool IsClutched() const { return this->IsOn; }
  /**
   * Keeps the clutch of this style on, because another style with this device may have released it.
   */
  void KeepClutch();

private:
  TouchedScene& Scene;
  const std::function<bool()> ArmsAfterClutch;
  HapticWorkspace Workspace;
  /** change time of camera and settings when the workspace was placed last */
  vtkMTimeType Placed = 0;
  bool IsPlaced = false;
  bool IsOn = false;   ///< whether the clutch is on
  Vector3 ClutchedTip; ///< position of the tip when the clutch was put on (world)
};

} // namespace VolumeHaptics

#endif
