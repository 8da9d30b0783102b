// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticCalibration
 * @brief   the placement of a device in the world, from points that its stylus touched
 *
 * Calibrates co-location: the hand then feels an object where the eye sees it. Touch three or more
 * points whose world positions are known, such as marks on the display:
 *
 *   calibration->AddPoint(tip, mark);            // tip: in the device's space, m; three or more
 *   if (calibration->Compute())
 *   {
 *     device->SetDeviceToWorld(calibration->GetDeviceToWorld());
 *     device->Publish();
 *   }
 *
 * The computed matrix maps the touched positions to the known ones: a rotation and a translation by
 * least squares, and one uniform scale, the ratio of the spreads of the points. It is never a
 * mirror (vtkLandmarkTransform).
 *
 * GetResidual says how well the points fit; if the largest residual is far above it, one point was
 * touched badly. The points have to span a triangle whose height is at least 1 % of its longest
 * side; a wider one is better. More than three points, at different depths, average out the hand's
 * tremor.
 *
 * While you touch points, let the device's space be the world (an identity matrix in
 * SetDeviceToWorld, so that a world unit is a metre): vtkHapticState::GetTipPosition then gives the
 * device's position of each pair.
 *
 * @sa vtkHapticDevice, vtkHapticSetup
 */
#ifndef vtkHapticCalibration_h
#define vtkHapticCalibration_h

#include "vtkNew.h" // for ivars
#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkMatrix4x4;
class vtkPoints;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticCalibration : public vtkObject
{
public:
  static vtkHapticCalibration* New();
  vtkTypeMacro(vtkHapticCalibration, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Adds a touched point: its position in the device's space (m), and in the world. */
  void AddPoint(const double device[3], const double world[3]) VTK_SIZEHINT(device, 3)
    VTK_SIZEHINT(world, 3);
  void RemoveAllPoints();
  int GetNumberOfPoints();

  ///@{
  /**
   * World units per metre of the device, 0 or more. 0 (default): computed from the points. Set it
   * if the display's size is known: only a rigid motion is then computed.
   */
  vtkSetClampMacro(FixedScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FixedScale, double);
  ///@}

  /**
   * Compute the matrix. Reports an error, returns false and keeps the last matrix if there are
   * fewer than three points, if all points are at one position or on one line, or if a number is
   * not finite.
   */
  bool Compute();

  /** Get the result of the last successful Compute; the identity before. */
  vtkMatrix4x4* GetDeviceToWorld();

  ///@{
  /**
   * Get the residuals of the last successful Compute (world units), 0 before it. Residual is the
   * root mean square of the distances between the world's points and the transformed points,
   * LargestResidual the largest of these distances.
   */
  vtkGetMacro(Residual, double);
  vtkGetMacro(LargestResidual, double);
  ///@}

protected:
  vtkHapticCalibration();
  ~vtkHapticCalibration() override;

  vtkNew<vtkPoints> DevicePoints;
  vtkNew<vtkPoints> WorldPoints;
  vtkNew<vtkMatrix4x4> DeviceToWorld;
  double FixedScale = 0.0;
  double Residual = 0.0;
  double LargestResidual = 0.0;

private:
  vtkHapticCalibration(const vtkHapticCalibration&) = delete;
  void operator=(const vtkHapticCalibration&) = delete;
};

#endif
