// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticShearMode
 * @brief   the direction in which a flow stretches
 *
 * Lets the hand move freely in the direction in which the flow of the vectors stretches most: along
 * the first eigenvector of (J + J^T)/2, with J the Jacobian. Across this direction, the hand is
 * held with the Strength (N), a function of the rate of stretching (the eigenvalue, per world
 * unit).
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticShearMode_h
#define vtkHapticShearMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticShearMode : public vtkHapticMode
{
public:
  static vtkHapticShearMode* New();
  vtkTypeMacro(vtkHapticShearMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHapticShearMode();
  ~vtkHapticShearMode() override;

private:
  vtkHapticShearMode(const vtkHapticShearMode&) = delete;
  void operator=(const vtkHapticShearMode&) = delete;
};

#endif
