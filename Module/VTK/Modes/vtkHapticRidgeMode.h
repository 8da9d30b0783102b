// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRidgeMode
 * @brief   the middle of vessels
 *
 * Draws the hand to the middle of a vessel or nerve: a ridge, where the touched scalars fall to all
 * sides but along one direction. The hand is held there with the Strength (N), and moves freely
 * along the ridge.
 *
 * The strength is a function of how tubular the scalars are: with |h_1| <= |h_2| <= |h_3| the
 * eigenvalues of their Hessian, of |h_2| - |h_1|, in scalar units per square world unit. Noise has
 * small ridges everywhere: let the strength be 0 there. The gradient estimator of the filter
 * smooths the scalars; a KernelRadius of about the radius of the vessels suits best.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticRidgeMode_h
#define vtkHapticRidgeMode_h

#include "vtkHapticMode.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRidgeMode : public vtkHapticMode
{
public:
  static vtkHapticRidgeMode* New();
  vtkTypeMacro(vtkHapticRidgeMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PolarityType
  {
    BRIGHT = 0,
    DARK = 1
  };

  ///@{
  /** Whether vessels are BRIGHT (default), brighter than what is around them, or DARK. */
  vtkSetClampMacro(Polarity, int, BRIGHT, DARK);
  vtkGetMacro(Polarity, int);
  void SetPolarityToBright() { this->SetPolarity(BRIGHT); }
  void SetPolarityToDark() { this->SetPolarity(DARK); }
  ///@}

  ///@{
  /**
   * How far from the ridge the hand is drawn to it with all of the strength (voxels), 0.1 to 16. At
   * twice this distance it is free. Default 3.
   */
  vtkSetClampMacro(SnapDistance, double, 0.1, 16.0);
  vtkGetMacro(SnapDistance, double);
  ///@}

protected:
  vtkHapticRidgeMode();
  ~vtkHapticRidgeMode() override;

  int Polarity = BRIGHT;
  double SnapDistance = 3.0;

private:
  vtkHapticRidgeMode(const vtkHapticRidgeMode&) = delete;
  void operator=(const vtkHapticRidgeMode&) = delete;
};

#endif
