// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticTensorFollowMode
 * @brief   follow the fibres of a tensor field
 *
 * With l_1 >= l_2 >= l_3 the eigenvalues of the tensor, negative ones taken as 0:
 *
 *   c_l = (l_1 - l_2)/l_1    how much there is one direction (diffusion along fibres)
 *   c_p = (l_2 - l_3)/l_1    how much there is one plane (sheets)
 *
 * The hand moves freely along the first eigenvector, and is held across it with the Strength (N), a
 * function of c_l, from 0 to 1. Where c_l is 0, so should the strength be: the default of 2 N holds
 * there, too, in an arbitrary direction. Of tensors with 9 components (row by row), the symmetric
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
