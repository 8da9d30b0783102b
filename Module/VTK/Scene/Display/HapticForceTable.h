// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The table that a force chart draws: a column Time (s), and a column for each curve (N). The first
 * four curves always exist. Curves of modes exist if the modes are named.
 */
#ifndef HapticForceTable_h
#define HapticForceTable_h

#include "VTK/Scene/Base/HapticModeColors.h"

#include "vtkNew.h"

#include <array>
#include <deque>
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
  static constexpr int Curves = 4; ///< the curves without modes: normal, friction, drag, whole
  static constexpr int MostCurves = Curves + static_cast<int>(ModeColorCount);

  HapticForceTable();
  ~HapticForceTable();

  vtkTable* Get() { return this->Table; }
  vtkFloatArray* GetTime() { return this->Columns[0]; }
  vtkFloatArray* GetForce(int curve) { return this->Columns[1 + curve]; }
  /** Returns the number of curves, including those of modes. */
  int GetCurves() const { return this->Count; }
  /**
   * Names the modes whose curves follow the first four. Returns whether the names have changed; if
   * so, all rows are removed.
   */
  bool SetModes(const std::vector<std::string>& names);
  /** Removes all rows. After adding rows, call Get()->Modified(). */
  void Clear();

  /**
   * Replaces the rows by the ticks of a trace with the arrays of vtkVolumeHapticsFilter's output.
   */
  void Read(vtkPolyData* trace);

  /** Limits a force to numbers that a chart can draw; returns 0 if the force is not finite. */
  static double MakeDrawable(double force);

private:
  vtkNew<vtkTable> Table;
  vtkNew<vtkFloatArray> Columns[1 + MostCurves];
  int Count = Curves;
};

/** The forces of the last seconds, reduced to few points for a plot. */
class HapticForceHistory
{
public:
  static constexpr int Curves = HapticForceTable::MostCurves;
  /** Number of intervals in the time span. Each curve has two points in each interval. */
  static constexpr int Intervals = 240;

  struct State
  {
    double Time;                       ///< s
    std::array<double, Curves> Forces; ///< N; 0 for modes without a name
  };

  HapticForceHistory();
  ~HapticForceHistory();

  /**
   * Adds a state with a finite time, and removes states that are older than the span (s). If the
   * state is not later than the last one, the history starts again. Forces that are not finite
   * count as 0; finite forces are limited to the largest number that a chart can show.
   */
  void Add(const State& state, double span);
  void Clear();
  /** Names the modes of the table: see HapticForceTable::SetModes. */
  void SetModes(const std::vector<std::string>& names);
  std::size_t GetSize() const { return this->States.size(); }

  /** Updates the table and returns it. Its times are relative to the last state. */
  vtkTable* Plot(double span);
  /** Returns the upper end (N) of an axis that shows all forces in the span. */
  double GetRange() const;

private:
  std::deque<State> States;
  HapticForceTable Table;
  bool IsPlotted = false;
};

} // namespace VolumeHaptics

#endif
