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

/** Reads one of the paths, which have to live longer. A path may have one reader or several. */
class TipReader
{
public:
  TipReader(const TipPaths& paths, std::size_t path);

  /** The tip at the next tick (world). There are as many as TipPaths says. */
  Vector3 Next()
  {
    ++this->Tick;
    return this->Paths.HaveTimes() ? this->FindPoint() : this->PointAt(this->Tick);
  }
  /** The orientation of the stylus (world) at the last tick; NoOrientation if there is none. */
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
  /** Time of the last tick (s). */
  double GetTime() const
  {
    return this->Start + static_cast<double>(this->Tick) * this->Paths.GetPeriod();
  }

private:
  /** The point at the time of the tick. */
  Vector3 FindPoint();
  /** The share of the way from the point before the tick to the next one; 0 at the point before. */
  double FindShare() const;
  /** Between the points before and after the tick. */
  Quaternion FindOrientation() const;
  double TimeAt(vtkIdType i) const { return this->Paths.GetTime(this->Members.At(i)); }
  Vector3 PointAt(vtkIdType i) const { return this->Paths.GetPoint(this->Members.At(i)); }

  const TipPaths& Paths;
  const TipPaths::Members Members;
  double Start = 0.0;   ///< s
  vtkIdType Tick = -1;  ///< the last one
  vtkIdType Before = 0; ///< of points with times: the last one before the tick, or at it
};

} // namespace VolumeHaptics

#endif
