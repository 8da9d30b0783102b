// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticBurr
 * @brief   a burr, which removes the tissue that it is pressed into while it spins
 *
 * Removes the tissue that its head is pressed into while it spins:
 *
 *   vtkNew<vtkHapticBurr> burr;
 *   burr->SetRadius(2.0); // world units
 *   filter->SetTool(burr);
 *
 * The head is a ball, and solid tissue holds it as it holds a vtkHapticPointShell. With the force F
 * on the hand, the Friction mu, and the speed v of its rim, the rotation has the power mu F v, and
 * removes tissue of specific energy U (J/mm^3) at the rate
 *
 *   Q = mu F v/U.
 *
 * U comes from the label of each sample (vtkHapticLabelTable::SetSpecificEnergy()), or, if the
 * label has none, from the SpecificEnergy of the burr. So dense bone, with a large U, is drilled
 * more slowly, and pressing harder drills faster. The surface that is left has the shape of the
 * ball to a small part of a voxel. Every tool feels it, and so does the point without a tool, with
 * the method PROXY, FORCE_FIELD or LOCAL_SURFACE. The samples themselves do not change:
 * vtkVolumeHapticsFilter::GetRemoval() keeps the share of tissue that remains at each sample, and
 * undoes, saves and loads it.
 *
 * Live, it spins while the device is armed and its SpinButton is pressed, or
 * vtkHapticVirtualHand::SetSpinning() says so. Offline it always spins, or as the point array
 * Spinning of the path says (0 or 1), and each path removes tissue by itself, from the tissue that
 * the hand has left: the trace has the array RemovedVolume, the mm^3 of each tick, and the field
 * arrays of vtkHapticRemoval::ReadTrace().
 *
 * A part of the force may vibrate, at the frequency of the rotation or, where that is too fast to
 * be felt, at a half, quarter ... of it. Lengths and volumes are measured in the hand's space (see
 * MetersPerWorldUnit), except the Radius and the ContactArea.
 *
 * It needs the method PROXY, and a volume that does not move. Burrs with a radius of four voxels or
 * more leave surfaces within 0.05 voxel; a radius of less than a voxel can't be used.
 *
 * Removal takes a bounded part of each tick, whatever the Radius: about a fifth of a millisecond,
 * and with the contacts of the head 0.3 ms, on a processor of 2.5 GHz. Up to a radius of some 20
 * voxels, a step is removed within the tick that provides its energy. A larger burr removes the
 * step brick by brick in as many ticks as it needs, and the energy of these ticks is kept, so that
 * Q is unchanged; Documentation/method.md says where so much energy comes that removal falls
 * behind, and catches up at rest. The head has the same number of points at any radius.
 *
 * @sa vtkHapticShapedTool vtkHapticRemoval
 */
#ifndef vtkHapticBurr_h
#define vtkHapticBurr_h

#include "vtkHapticShapedTool.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkPiecewiseFunction;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticBurr : public vtkHapticShapedTool
{
public:
  static vtkHapticBurr* New();
  vtkTypeMacro(vtkHapticBurr, vtkHapticShapedTool);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The radius of the head (world units), more than 0. Default 2. It has to be a voxel at least;
   * see above for what a large one takes.
   */
  vtkSetClampMacro(Radius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /** The speed of the rotation (1/min), 0 or more. Default 60000. */
  vtkSetClampMacro(Speed, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Speed, double);
  ///@}

  ///@{
  /**
   * The friction between the head and the tissue, 0 or more, which sets the power of the rotation.
   * It does not pull the hand aside. Default 0.3.
   */
  vtkSetClampMacro(Friction, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Friction, double);
  ///@}

  ///@{
  /**
   * The energy U that it takes to remove tissue (J/mm^3) against the scalar value, 0 or more. A
   * function without points (default) is 10. Created on first Get; nullptr restores the default.
   * Labels may have their own: vtkHapticLabelTable::SetSpecificEnergy().
   */
  void SetSpecificEnergy(vtkPiecewiseFunction* energy);
  vtkPiecewiseFunction* GetSpecificEnergy();
  ///@}

  ///@{
  /** The share of the force that vibrates while it spins in tissue, 0 to 1. Default 0. */
  vtkSetClampMacro(Vibration, double, 0.0, 1.0);
  vtkGetMacro(Vibration, double);
  ///@}

  ///@{
  /**
   * The button of the device that makes it spin while it is pressed, 0 to 31; -1: none. Default 0,
   * the first.
   */
  vtkSetClampMacro(SpinButton, int, -1, 31);
  vtkGetMacro(SpinButton, int);
  ///@}

  /** Includes the change time of the function. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticBurr();
  ~vtkHapticBurr() override;

  vtkSmartPointer<vtkPiecewiseFunction> SpecificEnergy;
  double Radius = 2.0;
  double Speed = 60000.0;
  double Friction = 0.3;
  double Vibration = 0.0;
  int SpinButton = 0;

private:
  vtkHapticBurr(const vtkHapticBurr&) = delete;
  void operator=(const vtkHapticBurr&) = delete;
};

#endif
