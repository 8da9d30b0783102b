// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The table behind a force chart: a column Time (s), and one column per curve (N). The first four
 * curves always exist; named modes add further curves.
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
  static constexpr int Curves = 4; ///< curves without modes: normal, friction, drag, whole
  static constexpr int MostCurves = Curves + static_cast<int>(ModeColorCount);

  HapticForceTable();
  ~HapticForceTable();

  vtkTable* Get() { return this->Table; }
  vtkFloatArray* GetTime() { return this->Columns[0]; }
  vtkFloatArray* GetForce(int curve) { return this->Columns[1 + curve]; }
  /** Returns the number of curves, including those of modes. */
  int GetCurves() const { return this->Count; }
  /**
   * Sets the names of the modes, whose curves follow the first four. Returns whether the names have
   * changed; all rows are then removed.
   */
  bool SetModes(const std::vector<std::string>& names);
  /** Removes all rows. Call Get()->Modified() after adding new rows. */
  void Clear();

  /**
   * Replaces the rows with the ticks of a trace that has the arrays of vtkVolumeHapticsFilter's
   * output.
   */
  void Read(vtkPolyData* trace);

  /**
   * Clamps a force to the range that a chart can draw; returns 0 for a force that is not finite.
   */
  static double MakeDrawable(double force);

private:
  vtkNew<vtkTable> Table;
  vtkNew<vtkFloatArray> Columns[1 + MostCurves];
  int Count = Curves;
};

/** Forces of the last seconds, reduced to few points for a plot. */
class HapticForceHistory
{
public:
  static constexpr int Curves = HapticForceTable::MostCurves;
  /** Number of intervals in the time span; each curve has two points per interval. */
  static constexpr int Intervals = 240;

  struct State
  {
    double Time;                       ///< s
    std::array<double, Curves> Forces; ///< N; 0 for modes with an empty name
  };

  HapticForceHistory();
  ~HapticForceHistory();

  /**
   * Adds a state with a finite time, and removes states that are older than the span (s). If the
   * state is not later than the last one, starts a new history. Forces that are not finite count as
   * 0; finite forces are limited to the largest number that a chart can show.
   */
  void Add(const State& state, double span);
  void Clear();
  /** Sets the names of the modes in the table: see HapticForceTable::SetModes. */
  void SetModes(const std::vector<std::string>& names);
  std::size_t GetSize() const { return this->States.size(); }

  /** Updates and returns the table. Its times are relative to the last state. */
  vtkTable* Plot(double span);
  /** Returns an upper end (N) for the force axis that includes all forces in the span. */
  double GetRange() const;

private:
  std::deque<State> States;
  HapticForceTable Table;
  bool IsPlotted = false;
};

} // namespace VolumeHaptics

#endif
