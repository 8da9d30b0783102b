// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The table that a force chart draws: Time (s), and a column for each of its curves (N).
 */
#ifndef HapticForceTable_h
#define HapticForceTable_h

#include "vtkNew.h"

class vtkFloatArray;
class vtkPolyData;
class vtkTable;

namespace VolumeHaptics
{

class HapticForceTable
{
public:
  static constexpr int Curves = 4; ///< normal, friction, drag, whole

  HapticForceTable();
  ~HapticForceTable();

  vtkTable* Get() { return this->Table; }
  vtkFloatArray* GetTime() { return this->Columns[0]; }
  vtkFloatArray* GetForce(int curve) { return this->Columns[1 + curve]; }
  /** Removes all rows. After adding rows, call Get()->Modified(). */
  void Clear();

  /** Every tick of a trace with the arrays of vtkVolumeHapticsFilter's output. */
  void Read(vtkPolyData* trace);

  /** A force that a chart can draw: none, if it is not finite. */
  static double MakeDrawable(double force);

private:
  vtkNew<vtkTable> Table;
  vtkNew<vtkFloatArray> Columns[1 + Curves];
};

} // namespace VolumeHaptics

#endif
