// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticTensorFollowMode
 * @brief   follow the fibres of a tensor field
 *
 * Lets the hand move along fibres. With l_1 >= l_2 >= l_3 the eigenvalues of the tensor, negative
 * ones taken as 0:
 *
 *   c_l = (l_1 - l_2)/l_1    how clear one direction is (diffusion along fibres)
 *   c_p = (l_2 - l_3)/l_1    how clear one plane is (sheets)
 *
 * The hand moves freely along the first eigenvector, and is held across it with the Strength (N), a
 * function of c_l, from 0 to 1. Let the strength be 0 where c_l is 0: the default of 2 N holds
 * there, too, in an arbitrary direction. If tensors have 9 components (row by row), their symmetric
 * part counts.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticTensorFollowMode_h
#define vtkHapticTensorFollowMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticTensorFollowMode : public vtkHapticMode
{
public:
  static vtkHapticTensorFollowMode* New();
  vtkTypeMacro(vtkHapticTensorFollowMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The force with which the hand is held within the plane of the first two eigenvectors (N),
   * against c_p. A function without points is 0 everywhere, the default.
   */
  void SetSheetStrength(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetSheetStrength();
  ///@}

protected:
  vtkHapticTensorFollowMode();
  ~vtkHapticTensorFollowMode() override;

private:
  vtkHapticTensorFollowMode(const vtkHapticTensorFollowMode&) = delete;
  void operator=(const vtkHapticTensorFollowMode&) = delete;
};

#endif
