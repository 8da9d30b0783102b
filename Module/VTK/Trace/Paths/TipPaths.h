// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The paths in a polydata. TipReader reads each, tick by tick, when it is felt.
 */
#ifndef TipPaths_h
#define TipPaths_h

#include "Core/Math/Quaternion.h"
#include "VTK/Trace/Paths/RecordedPath.h"
#include "VTK/Trace/Paths/TipPathLines.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkPoints;
class vtkPolyData;

namespace VolumeHaptics
{

/**
 * TipPathLines.h says which lines are paths. Without a point array `Time` every point is a tick.
 * With it, a path is resampled linearly to one tick every `period` seconds, starting at its first
 * time. If points have the same time, the last counts; a point whose time is a tick's is taken
 * unchanged, to the bit. A recording of vtkHapticDevice is one path, taken tick by tick, in device
 * space.
 */
class TipPaths
{
public:
  /**
   * Reads what all paths have in common. False, with an error, for numbers that are not finite,
   * time that runs backwards, incomplete recordings, a line that does not follow the order of the
   * points, or more ticks than fit into memory.
   */
  bool Read(vtkPolyData* path, double period, std::string& error);
  /**
   * Reads what only tools need, if there is any and the path is no recording: the point arrays
   * Orientation and Spinning. False, with an error, for an array that has none.
   */
  bool ReadHand(vtkPolyData* path, std::string& error);

  std::size_t GetNumberOfPaths() const { return this->FirstTicks.size() - 1; }
  /** Of all paths. */
  vtkIdType GetNumberOfTicks() const { return this->FirstTicks.back(); }
  /** The number of ticks of the paths before this one. */
  vtkIdType GetFirstTick(std::size_t path) const { return this->FirstTicks[path]; }
  vtkIdType GetNumberOfTicks(std::size_t path) const
  {
    return this->FirstTicks[path + 1] - this->FirstTicks[path];
  }
  /** Of the last tick of all paths (s). */
  double FindLastTime() const;
  /** Whether each path has a line of its own, whatever its length. */
  bool AreSeveral() const { return !this->Divided.Begins.empty(); }
  /** Null if the paths are no recording; otherwise it is the only path. */
  const RecordedPath* GetRecording() const { return this->Recording ? &*this->Recording : nullptr; }

  /** The points of a path are At(0) to At(GetSize() - 1) in the polydata. */
  class Members
  {
  public:
    Members(const TipPaths& paths, std::size_t path);
    vtkIdType GetSize() const { return this->Size; }
    vtkIdType At(vtkIdType i) const { return this->Ids ? this->Ids[i] : this->First + i; }

  private:
    const vtkIdType* Ids = nullptr; ///< null if they follow one another
    vtkIdType First = 0;
    vtkIdType Size;
  };

  Vector3 GetPoint(vtkIdType point) const
  {
    if (!this->Doubles)
    {
      return this->ConvertPoint(point);
    }
    const double* const x = this->Doubles + 3 * point;
    return { x[0], x[1], x[2] };
  }
  /** Whether the points have times; otherwise each is a tick. */
  bool HaveTimes() const { return !this->Times.empty(); }
  /** The time of a point (s). */
  double GetTime(vtkIdType point) const { return this->Times[point]; }
  double GetPeriod() const { return this->Period; }
  /** Whether points have orientations, of the stylus in the world. */
  bool HaveOrientations() const { return !this->Orientations.empty(); }
  /** That of a point; NoOrientation if it has none. */
  const Quaternion& GetOrientation(vtkIdType point) const { return this->Orientations[point]; }
  /** Whether a burr spins from a point to the next one; it does where nothing else is said. */
  bool IsSpinning(vtkIdType point) const { return this->Spinning.empty() || this->Spinning[point]; }

  /** If the times of point and tick differ by less than this share of a tick, they are one. */
  static constexpr double SnapShare = 1e-6;

private:
  bool ReadOrientations(vtkPolyData* path, std::string& error);
  bool ReadSpinning(vtkPolyData* path, std::string& error);
  bool CheckPoints(std::string& error) const;
  bool DivideLines(vtkPolyData* path, std::string& error);
  bool ReadTimes(vtkPolyData* path, std::string& error);
  bool CheckTimes(std::size_t path, std::string& error) const;
  bool CountTicks(std::string& error);
  Vector3 ConvertPoint(vtkIdType point) const;

  vtkSmartPointer<vtkPoints> Points;
  const double* Doubles = nullptr;           ///< of the points, if they are such
  const float* Floats = nullptr;             ///< of the points, if they are such
  std::vector<double> Times;                 ///< s, of each point; empty if each is a tick
  std::vector<Quaternion> Orientations;      ///< of each point; empty if there are none
  std::vector<bool> Spinning;                ///< of each point; empty if there are none
  double Period = 0.0;                       ///< s
  DividedPoints Divided;                     ///< empty if all points are one path, in order
  std::vector<vtkIdType> FirstTicks = { 0 }; ///< of each path; then the number of all
  std::optional<RecordedPath> Recording;
};

/** The error for so many ticks that they and their trace do not fit into memory. */
std::string DescribeLackOfMemory(double ticks);

} // namespace VolumeHaptics

#endif
