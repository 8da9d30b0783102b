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

namespace VolumeHaptics
{

/** The camera's right, up and towards the user, as rows. */
Matrix3 CameraAxes(vtkCamera* camera);

/**
 * Device x, y and z are right, up and towards the user on the screen. The device's origin lies at
 * the camera's focal point plus an offset in the camera's axes, so that what the clutch has shifted
 * turns with the view.
 */
class HapticWorkspace
{
public:
  /** From a metre of the device to the world, at a scale (world units per metre). */
  vtkMatrix4x4* Place(vtkCamera* camera, double scale);

  /** Where a world position was under the hand, there another one is to be: after the clutch. */
  void Shift(vtkCamera* camera, const Vector3& from, const Vector3& to);
  void Recenter() { this->Offset = {}; }

private:
  Vector3 Offset; // world units, along the camera's axes
  vtkNew<vtkMatrix4x4> DeviceToWorld;
};

} // namespace VolumeHaptics

#endif
