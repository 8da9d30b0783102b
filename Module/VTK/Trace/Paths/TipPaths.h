// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the paths in a polydata. TipReader then reads each path tick by tick.
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

/** The points of several paths, one path after another. */
struct DividedPoints
{
  std::vector<vtkIdType> Points; ///< numbers of the points; empty if they are 0, 1, 2 ...
  /** begin of each path in Points, and at the end, the end of the last path */
  std::vector<vtkIdType> Begins;
  vtkIdType Count = 0; ///< number of all points

  void Append(const vtkIdType* ids, vtkIdType count);
  /** Returns the point that was appended last. */
  vtkIdType GetLast() const { return this->Points.empty() ? this->Count - 1 : this->Points.back(); }
};

/**
 * Divides a polydata into paths. The points must be finite. A polydata with at most one line cell
 * is one path, through all its points in the order in which they are stored. Segments (cells of two
 * points) are also one path if they can be drawn with one stroke of a pen. Otherwise each line cell
 * is a path through its own points, but segments that continue one another form one path.
 */
class TipPathLines
{
public:
  explicit TipPathLines(vtkPolyData* path)
    : Path(path)
  {
  }

  /** Returns whether the polydata is one path; also true without points. */
  bool IsOne() const;

  /**
   * Returns the first leap of the path, as the points before and after it; -1, -1 if there is none.
   * A leap lies between consecutive points of the line cells, in the order in which they are
   * stored, that no cell joins. Points at the same position need no cell.
   */
  std::pair<long long, long long> FindLeap() const;

  /**
   * Divides the polydata into several paths, in the order of the cells. An empty cell is a path
   * without points. Returns false and writes an error if a cell has a point that does not exist.
   */
  bool Divide(DividedPoints& divided, std::string& error) const;

private:
  bool IsOfSegments() const;
  /**
   * Returns the number of strokes of a pen that can draw the line cells: 1 for segments that
   * continue one another, in any order and direction; 0 without line cells.
   */
  std::size_t CountStrokes() const;

  vtkPolyData* const Path;
};

/**
 * The paths of a polydata, as divided by TipPathLines, and their ticks. Without a point array
 * `Time`, every point is a tick. With it, a path is resampled linearly to one tick every `period`
 * seconds, beginning at its first time. If points have the same time, the last of them counts. A
 * point at the time of a tick is used unchanged, to the bit. A recording of vtkHapticDevice is one
 * path, and is used tick by tick in device space.
 */
class TipPaths
{
public:
  /**
   * Reads the data that all paths share. Returns false and writes an error if numbers are not
   * finite, if time runs backwards, if a recording is incomplete, if a line does not follow the
   * order of the points, or if the ticks do not fit into memory.
   */
  bool Read(vtkPolyData* path, double period, std::string& error);
  /**
   * Reads the point arrays Orientation and Spinning, which only tools need. Does nothing if they do
   * not exist, or if the path is a recording. Returns false and writes an error if an array has the
   * wrong form.
   */
  bool ReadHand(vtkPolyData* path, std::string& error);

  std::size_t GetNumberOfPaths() const { return this->FirstTicks.size() - 1; }
  /** Returns the number of ticks of all paths. */
  vtkIdType GetNumberOfTicks() const { return this->FirstTicks.back(); }
  /** Returns the number of ticks of all paths before this one. */
  vtkIdType GetFirstTick(std::size_t path) const { return this->FirstTicks[path]; }
  vtkIdType GetNumberOfTicks(std::size_t path) const
  {
    return this->FirstTicks[path + 1] - this->FirstTicks[path];
  }
  /** Returns the time of the last tick of all paths (s). */
  double ComputeLastTime() const;
  /** Returns whether there are several paths, each of which gets a line, whatever its length. */
  bool AreSeveral() const { return !this->Divided.Begins.empty(); }
  /** Returns the recording, which is the only path; null if there is no recording. */
  const RecordedPath* GetRecording() const { return this->Recording ? &*this->Recording : nullptr; }

  /** The points of a path in the polydata: At(0) to At(GetSize() - 1). */
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
  /** Returns whether the points have times; otherwise each point is a tick. */
  bool HaveTimes() const { return !this->Times.empty(); }
  /** Returns the time of a point (s). */
  double GetTime(vtkIdType point) const { return this->Times[point]; }
  double GetPeriod() const { return this->Period; }
  /** Returns whether points have orientations of the stylus (world). */
  bool HaveOrientations() const { return !this->Orientations.empty(); }
  /** Returns the orientation at a point; NoOrientation if there is none. */
  const Quaternion& GetOrientation(vtkIdType point) const { return this->Orientations[point]; }
  /**
   * Returns whether a burr spins between a point and the next one. It does unless the path says
   * otherwise.
   */
  bool IsSpinning(vtkIdType point) const { return this->Spinning.empty() || this->Spinning[point]; }

  /** A point and a tick coincide if their times differ by less than this fraction of a tick. */
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
  const double* Doubles = nullptr;      ///< the points if they are doubles, otherwise null
  const float* Floats = nullptr;        ///< the points if they are floats, otherwise null
  std::vector<double> Times;            ///< time of each point (s); empty if each is a tick
  std::vector<Quaternion> Orientations; ///< one for each point; empty if there are none
  std::vector<bool> Spinning;           ///< one for each point; empty if a burr always spins
  double Period = 0.0;                  ///< tick period (s)
  DividedPoints Divided; ///< points of several paths; empty if all points are one path, in order
  /** First tick of each path, and at the end, the number of all ticks. */
  std::vector<vtkIdType> FirstTicks = { 0 };
  std::optional<RecordedPath> Recording;
};

/**
 * Returns the error for more ticks than fit into memory together with their trace. `ticks`
 * is their number.
 */
std::string DescribeLackOfMemory(double ticks);

} // namespace VolumeHaptics

#endif
