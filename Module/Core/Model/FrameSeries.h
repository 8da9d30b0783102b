// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data times of a volume that moves.
 *
 * A series begins with the frame at First and ends with the one at Last. If it is played in a loop,
 * the last frame is blended into the first one in a further interval:
 *
 *   First ... Last ... First + GetPeriod(), which is First again.
 *
 * A model may hold a part of the series only, the *window*: some of the frames, in this order. A
 * window that crosses the end of a loop ends at an earlier time than it begins. A window of one
 * frame has only the time of that frame.
 */
#ifndef FrameSeries_h
#define FrameSeries_h

#include <limits>

namespace VolumeHaptics
{

struct FrameSeries
{
  double First = 0.0;
  double Last = 0.0;
  double LoopInterval = 0.0; ///< more than 0, if there are frames

  double GetPeriod() const noexcept { return this->Last - this->First + this->LoopInterval; }
};

/** The times for which a model has the frames. */
struct FrameWindow
{
  FrameSeries Series;
  double Front = 0.0;     ///< the first frame's time
  double Back = 0.0;      ///< the last frame's time; equals Front if the window has the whole loop
  bool IsInstant = false; ///< it has one frame only

  bool IsLoop() const noexcept { return this->Front == this->Back && !this->IsInstant; }
  bool Has(double time) const noexcept
  {
    return this->Front < this->Back || this->IsInstant ? this->Front <= time && time <= this->Back
                                                       : time >= this->Front || time <= this->Back;
  }
  ///@{
  /** The data time that the window has beyond `time`, forward and backward. */
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
