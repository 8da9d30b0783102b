// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticCalibration
 * @brief   where a device stands in the world, from points that its stylus touched
 *
 * For co-location: what the hand touches is where the eye sees it. Touch three or more points whose
 * place in the world is known, such as marks on the display, and this class finds the matrix for
 * vtkHapticDevice::SetDeviceToWorld that takes the one to the other: a rotation and a translation
 * by least squares and one uniform scale, the ratio of the spreads of the points, never a mirror
 * (vtkLandmarkTransform).
 *
 *   calibration->AddPoint(tip, mark);            // tip: in the device's space, m; three or more
 *   if (calibration->Compute())
 *   {
 *     device->SetDeviceToWorld(calibration->GetDeviceToWorld());
 *     device->Publish();
 *   }
 *
 * GetResidual says how well the points fit; a largest residual far above it points at one that was
 * touched badly. The points have to span a triangle, whose height is 1 % of its longest side or
 * more: the wider, the better. More than three, at different depths, average out the hand's tremor.
 *
 * While points are touched, let the device's space be the world (metres for world units: an
 * identity matrix in SetDeviceToWorld), so that vtkHapticDevice::GetTipPosition gives the first of
 * each pair.
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

  /** One touched point: where the device was (m, its own space), and where that is in the world. */
  void AddPoint(const double device[3], const double world[3]) VTK_SIZEHINT(device, 3)
    VTK_SIZEHINT(world, 3);
  void RemoveAllPoints();
  int GetNumberOfPoints();

  ///@{
  /**
   * World units per metre of the device, 0 or more. 0 (default): found from the points. Fix it
   * if the display's size is known: a rigid motion remains to be found.
   */
  vtkSetClampMacro(FixedScale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(FixedScale, double);
  ///@}

  /**
   * Find the matrix. False, with an error and no change, for fewer than three points, points that
   * are all in one place or on one line, and numbers that are not finite.
   */
  bool Compute();

  /** The result of the last successful Compute; the identity before. */
  vtkMatrix4x4* GetDeviceToWorld();

  ///@{
  /**
   * Of the last successful Compute, in world units: the root of the mean square of the distances
   * between the world's points and the transformed ones, and the largest of them. 0 before.
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
