// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticVectorFrontMode
 * @brief   surfaces across a field
 *
 * Holds the hand, wherever it is, on a surface across the vectors of the array, such as a wave
 * front or an equipotential, with the Strength (N), a function of the magnitude of the vector. The
 * hand slides along this surface. If it pushes with more than the strength, it moves on to the next
 * surface, at that force.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticVectorFrontMode_h
#define vtkHapticVectorFrontMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticVectorFrontMode : public vtkHapticMode
{
public:
  static vtkHapticVectorFrontMode* New();
  vtkTypeMacro(vtkHapticVectorFrontMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the hand is held in both directions along the vectors, so that it snaps on a front.
   * Off (default): it is held only against them, and free the way they point.
   */
  vtkSetMacro(TwoSided, bool);
  vtkGetMacro(TwoSided, bool);
  vtkBooleanMacro(TwoSided, bool);
  ///@}

protected:
  vtkHapticVectorFrontMode();
  ~vtkHapticVectorFrontMode() override;

  bool TwoSided = false;

private:
  vtkHapticVectorFrontMode(const vtkHapticVectorFrontMode&) = delete;
  void operator=(const vtkHapticVectorFrontMode&) = delete;
};

#endif
