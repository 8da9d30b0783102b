// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The workspace of a device in the scene, fixed to the camera.
 */
#ifndef HapticWorkspace_h
#define HapticWorkspace_h

#include "Core/Math/Vector3.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

class vtkCamera;
class vtkRenderer;

namespace VolumeHaptics
{

/** The camera's right, up and backward (towards the user) directions, as rows. */
Matrix3 CameraAxes(vtkCamera* camera);

/**
 * Turns the volume about the focal point, as seen by the user: the camera moves the other way. The
 * rate (rad/s) is along the camera's axes. If the timer paused, only the first 0.1 s of the time
 * (s) count, so that the view does not jump. False if nothing turns.
 */
bool TurnView(vtkRenderer* renderer, const Vector3& rate, double seconds, bool resetsClippingRange);

/**
 * Device x, y and z are right, up and towards the user on the screen. The device's origin lies at
 * the camera's focal point plus an offset in the camera's axes, so that the clutch's shift turns
 * with the view.
 */
class HapticWorkspace
{
public:
  /** The map from the device (m) to the world, at a scale (world units per metre). */
  vtkMatrix4x4* Place(vtkCamera* camera, double scale);

  /** Call after the clutch: the hand has moved from one world position to another. */
  void Shift(vtkCamera* camera, const Vector3& from, const Vector3& to);
  void Recenter() { this->Offset = {}; }

private:
  Vector3 Offset; // world units, along the camera's axes
  vtkNew<vtkMatrix4x4> DeviceToWorld;
};

} // namespace VolumeHaptics

#endif
