// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Detects when a handle is at rest. */
#ifndef RestWatch_h
#define RestWatch_h

/**
 * A handle is at rest if its position (m) and the force on it (N) have each stayed within a range
 * for `time` (s).
 */
class RestWatch
{
public:
  RestWatch(double placeRange, double forceRange, double time)
    : PlaceRange(placeRange)
    , ForceRange(forceRange)
    , RestTime(time)
  {
  }
  void Reset() { this->Time = -1.0; }
  /// Adds a position (m) and a force (N) that were measured `elapsed` (s) after the last call.
  /// Returns whether the handle is at rest.
  bool Step(double place, double force, double elapsed)
  {
    const bool isFirst = this->Time < 0.0;
    this->Time = isFirst ? 0.0 : this->Time + elapsed;
    this->Place.Add(place, isFirst);
    this->Force.Add(force, isFirst);
    if (this->Place.GetSize() > this->PlaceRange || this->Force.GetSize() > this->ForceRange)
    {
      this->Reset();
      return false;
    }
    return this->Time >= this->RestTime;
  }

private:
  struct Range
  {
    double Least = 0.0;
    double Most = 0.0;
    void Add(double value, bool isFirst)
    {
      this->Least = isFirst || value < this->Least ? value : this->Least;
      this->Most = isFirst || value > this->Most ? value : this->Most;
    }
    double GetSize() const { return this->Most - this->Least; }
  };

  const double PlaceRange;
  const double ForceRange;
  const double RestTime;
  double Time = -1.0; ///< s at rest; negative before the first sample
  Range Place;
  Range Force;
};

#endif
