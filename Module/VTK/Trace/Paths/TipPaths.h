// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the paths from a polydata. TipReader then reads each path tick by tick.
 */
#ifndef TipPaths_h
#define TipPaths_h

#include "Core/Math/Quaternion.h"
#include "VTK/Trace/Paths/RecordedPath.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkPoints;
class vtkPolyData;

namespace VolumeHaptics
{

/** Points of several paths, path after path. */
struct DividedPoints
{
  std::vector<vtkIdType> Points; ///< ids of the points; empty if they are 0, 1, 2, ...
  /** Index in Points where each path starts, followed by the end of the last path. */
  std::vector<vtkIdType> Begins;
  vtkIdType Count = 0; ///< total number of points

  void Append(const vtkIdType* ids, vtkIdType count);
  /** Returns the id of the last appended point. */
  vtkIdType GetLast() const { return this->Points.empty() ? this->Count - 1 : this->Points.back(); }
};

/**
 * Divides a polydata into paths. The points must be finite. A polydata with at most one line cell
 * is one path through all its points, in the order in which they are stored. Segments (cells of two
 * points) are also one path if a single stroke can draw them. Otherwise each line cell is a path
 * through its own points, except that segments that continue one another form one path.
 */
class TipPathLines
{
public:
  explicit TipPathLines(vtkPolyData* path)
    : Path(path)
  {
  }

  /** Returns whether the polydata is a single path, which may have no points. */
  bool IsOne() const;

  /**
   * Returns the first leap of the path, as the points before and after it; -1, -1 if there is none.
   * A leap is between two points of line cells that are stored consecutively, but not joined by a
   * cell. Points at the same position need no cell.
   */
  std::pair<long long, long long> FindLeap() const;

  /**
   * Divides the polydata into several paths, in the order of the cells. An empty cell is a path
   * without points. Returns false, with an error, if a cell refers to a point that does not exist.
   */
  bool Divide(DividedPoints& divided, std::string& error) const;

private:
  bool IsOfSegments() const;
  /**
   * Returns the number of strokes needed to draw the line cells: 1 for segments that continue one
   * another, in any order and direction; 0 without line cells.
   */
  std::size_t CountStrokes() const;

  vtkPolyData* const Path;
};

/**
 * The paths of a polydata, as divided by TipPathLines, and their ticks. Without a point array
 * `Time`, every point is a tick. With it, a path is resampled linearly to one tick every `period`
 * seconds, beginning at its first time. If several points have the same time, the last one counts.
 * A point at the time of a tick is used exactly. A recording of vtkHapticDevice is one path, and is
 * used tick by tick in device space.
 */
class TipPaths
{
public:
  /**
   * Reads the data that all paths share. Returns false, with an error, if numbers are not finite,
   * if time runs backwards, if a recording is incomplete, if a line does not follow the order of
   * the points, or if the ticks do not fit into memory.
   */
  bool Read(vtkPolyData* path, double period, std::string& error);
  /**
   * Reads the point arrays Orientation and Spinning, which only tools use. Does nothing if they are
   * missing or if the path is a recording. Returns false, with an error, if an array has the wrong
   * form.
   */
  bool ReadHand(vtkPolyData* path, std::string& error);

  std::size_t GetNumberOfPaths() const { return this->FirstTicks.size() - 1; }
  /** Returns the total number of ticks of all paths. */
  vtkIdType GetNumberOfTicks() const { return this->FirstTicks.back(); }
  /** Returns the total number of ticks of the paths before this one. */
  vtkIdType GetFirstTick(std::size_t path) const { return this->FirstTicks[path]; }
  vtkIdType GetNumberOfTicks(std::size_t path) const
  {
    return this->FirstTicks[path + 1] - this->FirstTicks[path];
  }
  /** Returns the time (s) of the last tick among all paths. */
  double ComputeLastTime() const;
  /** Returns whether there are several paths, so that each gets a line even if it is short. */
  bool AreSeveral() const { return !this->Divided.Begins.empty(); }
  /** Returns the recording, which is then the only path; null if there is none. */
  const RecordedPath* GetRecording() const { return this->Recording ? &*this->Recording : nullptr; }

  /** The points of a path in the polydata, At(0) to At(GetSize() - 1). */
  class Members
  {
  public:
    Members(const TipPaths& paths, std::size_t path);
    vtkIdType GetSize() const { return this->Size; }
    vtkIdType At(vtkIdType i) const { return this->Ids ? this->Ids[i] : this->First + i; }

  private:
    const vtkIdType* Ids = nullptr; ///< null if the points are consecutive
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
  /** Returns whether the points have times; if not, each point is a tick. */
  bool HaveTimes() const { return !this->Times.empty(); }
  /** Returns the time of a point (s). */
  double GetTime(vtkIdType point) const { return this->Times[point]; }
  double GetPeriod() const { return this->Period; }
  /** Returns whether the points have orientations of the stylus (world). */
  bool HaveOrientations() const { return !this->Orientations.empty(); }
  /** Returns the orientation at a point; NoOrientation if there is none. */
  const Quaternion& GetOrientation(vtkIdType point) const { return this->Orientations[point]; }
  /**
   * Returns whether a burr spins between a point and the next one: always, unless the path has the
   * array Spinning.
   */
  bool IsSpinning(vtkIdType point) const { return this->Spinning.empty() || this->Spinning[point]; }

  /**
   * Largest difference of the times of a point and a tick that coincide, as a fraction of the tick
   * period.
   */
  static constexpr double SnapFraction = 1e-6;

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
  const double* Doubles = nullptr;      ///< the points, if they are doubles; otherwise null
  const float* Floats = nullptr;        ///< the points, if they are floats; otherwise null
  std::vector<double> Times;            ///< time of each point (s); empty if each point is a tick
  std::vector<Quaternion> Orientations; ///< one per point; empty if there are none
  std::vector<bool> Spinning;           ///< one per point; empty if a burr always spins
  double Period = 0.0;                  ///< tick period (s)
  DividedPoints Divided; ///< points of several paths; empty if all points are one path, in order
  /** First tick of each path, followed by the total number of ticks. */
  std::vector<vtkIdType> FirstTicks = { 0 };
  std::optional<RecordedPath> Recording;
};

/** Returns the error for `ticks` ticks that do not fit into memory together with their trace. */
std::string DescribeLackOfMemory(double ticks);

} // namespace VolumeHaptics

#endif
