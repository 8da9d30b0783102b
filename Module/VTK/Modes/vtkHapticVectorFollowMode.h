// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticVectorFollowMode
 * @brief   follow a flow
 *
 * Lets the hand move freely along the vectors of the array, as if on a rail, and holds it across
 * them with the Strength (N), a function of the magnitude of the vector. The proxy follows the
 * field line, however it turns, without drift. Let the strength be 0 where the magnitude is 0,
 * since a zero vector has no direction.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticVectorFollowMode_h
#define vtkHapticVectorFollowMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticVectorFollowMode : public vtkHapticMode
{
public:
  static vtkHapticVectorFollowMode* New();
  vtkTypeMacro(vtkHapticVectorFollowMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The force that pushes the hand along the vectors (N), against their magnitude. It does work,
   * which the holds of modes never do. A function without points is 0 everywhere, the default.
   */
  void SetPush(vtkPiecewiseFunction* strength);
  vtkPiecewiseFunction* GetPush();
  ///@}

protected:
  vtkHapticVectorFollowMode();
  ~vtkHapticVectorFollowMode() override;

private:
  vtkHapticVectorFollowMode(const vtkHapticVectorFollowMode&) = delete;
  void operator=(const vtkHapticVectorFollowMode&) = delete;
};

#endif
