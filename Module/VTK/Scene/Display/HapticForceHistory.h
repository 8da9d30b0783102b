// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The forces of the last seconds, reduced to few points for a plot.
 */
#ifndef HapticForceHistory_h
#define HapticForceHistory_h

#include "VTK/Scene/Display/HapticForceTable.h"

#include <array>
#include <deque>

namespace VolumeHaptics
{

class HapticForceHistory
{
public:
  static constexpr int Curves = HapticForceTable::MostCurves;
  /** Number of intervals in the time span; each gives two points a curve. */
  static constexpr int Intervals = 240;

  struct State
  {
    double Time;                       ///< s
    std::array<double, Curves> Forces; ///< N; 0 for modes without a name
  };

  HapticForceHistory();
  ~HapticForceHistory();

  /**
   * Adds a state. If it is not later than the last one, the history starts again. Forgets states
   * that are older than the span (s). The time has to be finite. Forces that are not finite count
   * as 0; finite forces are limited to the largest one that a chart can show.
   */
  void Add(const State& state, double span);
  void Clear();
  /** See HapticForceTable. */
  void SetModes(const std::vector<std::string>& names);
  std::size_t GetSize() const { return this->States.size(); }

  /** Updates the table: time relative to the last state, then the curves. */
  vtkTable* Plot(double span);
  /** The upper end of an axis for all forces in the span (N). */
  double GetRange() const;

private:
  std::deque<State> States;
  HapticForceTable Table;
  bool IsPlotted = false;
};

} // namespace VolumeHaptics

#endif
