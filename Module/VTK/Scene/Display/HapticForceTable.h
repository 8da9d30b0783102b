// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The table that a force chart draws: Time (s), and a column for each curve (N). The first four
 * curves always exist; curves of modes exist if the modes are named.
 */
#ifndef HapticForceTable_h
#define HapticForceTable_h

#include "VTK/Scene/Base/HapticModeColors.h"

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkFloatArray;
class vtkPolyData;
class vtkTable;

namespace VolumeHaptics
{

class HapticForceTable
{
public:
  static constexpr int Curves = 4; ///< normal, friction, drag, whole
  static constexpr int MostCurves = Curves + static_cast<int>(ModeColorCount);

  HapticForceTable();
  ~HapticForceTable();

  vtkTable* Get() { return this->Table; }
  vtkFloatArray* GetTime() { return this->Columns[0]; }
  vtkFloatArray* GetForce(int curve) { return this->Columns[1 + curve]; }
  /** The curves of the table, including those of modes. */
  int GetCurves() const { return this->Count; }
  /**
   * Names the modes whose curves follow the first four. If the names change, removes all rows and
   * returns true.
   */
  bool SetModes(const std::vector<std::string>& names);
  /** Removes all rows. After adding rows, call Get()->Modified(). */
  void Clear();

  /** Every tick of a trace with the arrays of vtkVolumeHapticsFilter's output. */
  void Read(vtkPolyData* trace);

  /** A force that a chart can draw; 0 if it is not finite. */
  static double MakeDrawable(double force);

private:
  vtkNew<vtkTable> Table;
  vtkNew<vtkFloatArray> Columns[1 + MostCurves];
  int Count = Curves;
};

} // namespace VolumeHaptics

#endif
