// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticVortexMode
 * @brief   a tube around the axis of a vortex
 *
 * Holds the hand in a vortex. The curl omega of the vectors is the axis of their rotation. The hand
 * moves freely towards the axis, along it and around it; if it moves away from the axis, it is held
 * back with the Strength (N), a function of the magnitude of omega (per world unit). Within a tenth
 * of a voxel of the core line, on which the flow does not turn, the hand rests on the line itself.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticVortexMode_h
#define vtkHapticVortexMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticVortexMode : public vtkHapticMode
{
public:
  static vtkHapticVortexMode* New();
  vtkTypeMacro(vtkHapticVortexMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The force with which the hand is held on lines along the axis (N), against the magnitude of the
   * vorticity. A function without points is 0 everywhere, the default: the hand moves freely around
   * the axis.
   */
  void SetAxisStrength(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetAxisStrength();
  ///@}

protected:
  vtkHapticVortexMode();
  ~vtkHapticVortexMode() override;

private:
  vtkHapticVortexMode(const vtkHapticVortexMode&) = delete;
  void operator=(const vtkHapticVortexMode&) = delete;
};

#endif
