// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a path tick by tick.
 */
#ifndef TipReader_h
#define TipReader_h

#include "VTK/Trace/Paths/TipPaths.h"

#include "vtkType.h"

namespace VolumeHaptics
{

/** Reads one of the paths, which must outlive the reader. A path may have several readers. */
class TipReader
{
public:
  TipReader(const TipPaths& paths, std::size_t path);

  /** Returns the tip at the next tick (world). Call it as often as TipPaths has ticks. */
  Vector3 Next()
  {
    ++this->Tick;
    return this->Paths.HaveTimes() ? this->FindPoint() : this->PointAt(this->Tick);
  }
  /**
   * Returns the orientation of the stylus (world) at the last tick; NoOrientation if there is none.
   */
  Quaternion GetOrientation() const
  {
    return this->Paths.HaveOrientations() ? this->FindOrientation() : NoOrientation;
  }
  /** Whether a burr spins at the last tick. */
  bool IsSpinning() const
  {
    const vtkIdType point = this->Paths.HaveTimes() ? this->Before : this->Tick;
    return this->Paths.IsSpinning(this->Members.At(point));
  }
  /** Returns the time of the last tick (s). */
  double GetTime() const
  {
    return this->Start + static_cast<double>(this->Tick) * this->Paths.GetPeriod();
  }

private:
  /** Computes the position at the time of the tick. */
  Vector3 FindPoint();
  /** Returns how far the tick is on the way from the point before it to the next one, 0 to 1. */
  double FindShare() const;
  /** Interpolates the orientations before and after the tick. */
  Quaternion FindOrientation() const;
  double TimeAt(vtkIdType i) const { return this->Paths.GetTime(this->Members.At(i)); }
  Vector3 PointAt(vtkIdType i) const { return this->Paths.GetPoint(this->Members.At(i)); }

  const TipPaths& Paths;
  const TipPaths::Members Members;
  double Start = 0.0;   ///< s
  vtkIdType Tick = -1;  ///< number of the last tick
  vtkIdType Before = 0; ///< number of the last point before the tick, or at it
};

} // namespace VolumeHaptics

#endif
