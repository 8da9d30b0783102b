// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data times of a moving volume.
 *
 * A series begins with the time step at First and ends with the time step at Last. In a loop, one
 * more interval blends the last time step into the first one:
 *
 *   First ... Last ... First + GetPeriod(), which is First again.
 *
 * A model may contain only some consecutive time steps of the series, the *time span*. If the time
 * span crosses the end of a loop, it ends at an earlier data time than it begins. A time span with
 * one time step contains only the data time of that time step.
 */
#ifndef TimeStepSeries_h
#define TimeStepSeries_h

#include <limits>

namespace VolumeHaptics
{

struct TimeStepSeries
{
  double First = 0.0;
  double Last = 0.0;
  /** Data time from Last back to First in a loop; more than 0 if there are time steps. */
  double LoopInterval = 0.0;

  double GetPeriod() const noexcept { return this->Last - this->First + this->LoopInterval; }
};

/** The data times for which a model has time steps. */
struct TimeSpan
{
  TimeStepSeries Series;
  double Front = 0.0; ///< data time of the first time step
  /** Data time of the last time step. It equals Front if the time span covers the whole loop. */
  double Back = 0.0;
  bool IsInstant = false; ///< whether the time span has only one time step

  bool IsLoop() const noexcept { return this->Front == this->Back && !this->IsInstant; }
  bool Has(double time) const noexcept
  {
    return this->Front < this->Back || this->IsInstant ? this->Front <= time && time <= this->Back
                                                       : time >= this->Front || time <= this->Back;
  }
  ///@{
  /**
   * Return the data time from `time` to the end of the time span (GetAhead), or from its beginning
   * to `time` (GetBehind).
   */
  double GetAhead(double time) const noexcept { return this->Measure(this->Back - time); }
  double GetBehind(double time) const noexcept { return this->Measure(time - this->Front); }
  ///@}

private:
  double Measure(double length) const noexcept
  {
    return this->IsLoop() ? std::numeric_limits<double>::infinity()
      : length < 0.0      ? length + this->Series.GetPeriod()
                          : length;
  }
};

} // namespace VolumeHaptics

#endif
