// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticSurfaceMode
 * @brief   the surfaces of the scalars, beside other modes
 *
 * Makes the surfaces of the scalars felt, with the law of the method PROXY: the material functions
 * of vtkHapticProperty, or the label table, give surface strength, friction and drag, while the
 * stiffness is the CouplingStiffness. A material without stiffness is not felt.
 *
 * As with the solver PAPER, surfaces begin where their distinctness begins, and materials are read
 * a kernel radius to either side. Other settings of the method PROXY don't count, nor do ArrayName,
 * Strength and Axes.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticSurfaceMode_h
#define vtkHapticSurfaceMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticSurfaceMode : public vtkHapticMode
{
public:
  static vtkHapticSurfaceMode* New();
  vtkTypeMacro(vtkHapticSurfaceMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHapticSurfaceMode();
  ~vtkHapticSurfaceMode() override;

private:
  vtkHapticSurfaceMode(const vtkHapticSurfaceMode&) = delete;
  void operator=(const vtkHapticSurfaceMode&) = delete;
};

#endif
