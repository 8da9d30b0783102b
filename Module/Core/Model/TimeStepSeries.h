// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data times of a volume that moves.
 *
 * A series begins with the time step at First and ends with the one at Last. If it is played in a
 * loop, the last time step is blended into the first one in a further interval:
 *
 *   First ... Last ... First + GetPeriod(), which is First again.
 *
 * A model may hold a part of the series only, the *time span*: some of the time steps, in this
 * order. A time span that crosses the end of a loop ends at an earlier time than it begins. A time
 * span of one time step has only the time of that time step.
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
  double LoopInterval = 0.0; ///< more than 0, if there are time steps

  double GetPeriod() const noexcept { return this->Last - this->First + this->LoopInterval; }
};

/** The span of data time for which a model has the time steps. */
struct TimeSpan
{
  TimeStepSeries Series;
  double Front = 0.0; ///< the first time step's time
  /** The last time step's time; equals Front if the time span has the whole loop. */
  double Back = 0.0;
  bool IsInstant = false; ///< the time span has one time step only

  bool IsLoop() const noexcept { return this->Front == this->Back && !this->IsInstant; }
  bool Has(double time) const noexcept
  {
    return this->Front < this->Back || this->IsInstant ? this->Front <= time && time <= this->Back
                                                       : time >= this->Front || time <= this->Back;
  }
  ///@{
  /** Returns how much data time the time span contains after `time` and before it. */
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
