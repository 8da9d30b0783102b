// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticBurr
 * @brief   a burr, which removes the tissue that it is pressed into while it spins
 *
 * Removes the tissue that its head, a ball, is pressed into while it spins. Pressing harder drills
 * faster, and dense bone is drilled more slowly:
 *
 *   vtkNew<vtkHapticBurr> burr;
 *   burr->SetRadius(2.0); // world units
 *   filter->SetTool(burr);
 *
 * Solid tissue holds the head as it holds a vtkHapticPointShell. It is removed at the rate (mm^3/s)
 * that follows from the force on the hand, Friction, Speed and Radius, and from the SpecificEnergy
 * of the tissue or of its label: see Documentation/method.md, "The burr". The remaining surface has
 * the shape of the ball, to a small fraction of a voxel. Every tool feels it, and so does the point
 * without a tool, with the method PROXY, FORCE_FIELD or LOCAL_SURFACE. The samples themselves do
 * not change: vtkVolumeHapticsFilter::GetRemoval() keeps the fraction of tissue that remains at
 * each sample, and undoes, saves and loads it.
 *
 * Live, it spins while the device is armed and its SpinButton is pressed, or
 * vtkHapticVirtualHand::SetSpinning() is on. Offline it always spins, unless the path has the point
 * array Spinning, which is 1 where it spins and 0 where it does not. Each path then removes tissue
 * by itself, from the tissue that the hand has left: the trace has the field arrays of
 * vtkHapticRemoval::ReadTrace(), and an array that only this tool has:
 *
 *   RemovedVolume  mm^3 of the hand's space; in this tick
 *
 * It needs the method PROXY, and a volume that does not move. Burrs with a radius of four voxels or
 * more leave surfaces within 0.05 voxel; a radius of less than a voxel can't be used. Lengths and
 * volumes are measured in the hand's space (see MetersPerWorldUnit), except the Radius and the
 * ContactArea.
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
   * The radius of the head (world units), more than 0 and at least a voxel. Default 2.
   *
   * Removal takes a bounded part of each tick, whatever the radius: about a fifth of a millisecond,
   * and with the contacts of the head 0.3 ms, on a processor of 2.5 GHz. Up to a radius of some 20
   * voxels, a step is removed within the tick that provides its energy. A larger burr removes the
   * step in as many ticks as it needs, and the energy of these ticks is kept, so that the rate
   * stays the same; Documentation/method.md says where so much energy comes that removal falls
   * behind, and catches up at rest. The head has the same number of points at any radius.
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
   * function without points (default) is 10. Created on the first Get; nullptr restores the
   * default. Labels may have their own: vtkHapticLabelTable::SetSpecificEnergy().
   */
  void SetSpecificEnergy(vtkPiecewiseFunction* energy);
  vtkPiecewiseFunction* GetSpecificEnergy();
  ///@}

  ///@{
  /**
   * The fraction of the force that vibrates while the burr spins in tissue, 0 to 1. Default 0. It
   * vibrates at the frequency of the rotation or, where that is too fast to be felt, at a half,
   * quarter ... of it.
   */
  vtkSetClampMacro(Vibration, double, 0.0, 1.0);
  vtkGetMacro(Vibration, double);
  ///@}

  ///@{
  /**
   * The button of the device that makes the burr spin while it is pressed, 0 to 31; -1: none.
   * Default 0, the first.
   */
  vtkSetClampMacro(SpinButton, int, -1, 31);
  vtkGetMacro(SpinButton, int);
  ///@}

  /** Returns the latest modification time of this tool and its function. */
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
