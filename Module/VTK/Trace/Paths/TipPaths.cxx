// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/TipPaths.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Trace/Paths/RecordedPath.h"
#include "VTK/Trace/RecordingNames.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/**
 * Groups the ends of cells into junctions: ends at the same position belong to the same junction.
 */
class Junctions
{
public:
  explicit Junctions(std::size_t ends)
    : Root(ends)
  {
    std::iota(this->Root.begin(), this->Root.end(), std::size_t(0));
  }
  std::size_t Find(std::size_t end)
  {
    while (this->Root[end] != end)
    {
      end = this->Root[end] = this->Root[this->Root[end]];
    }
    return end;
  }
  void Join(std::size_t a, std::size_t b) { this->Root[this->Find(a)] = this->Find(b); }

private:
  std::vector<std::size_t> Root;
};

/** Computes the tolerance for considering the coordinates of two points equal. */
double ComputeRounding(vtkPolyData* path)
{
  double bounds[6];
  path->GetPoints()->GetBounds(bounds);
  constexpr double rounding = 1e-6;
  return rounding *
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

/** Calls take(size, ids) for each line cell, with the number and the ids of its points. */
template <typename F>
void ForEachLine(vtkPolyData* path, F&& take)
{
  const auto cells = vtkSmartPointer<vtkCellArrayIterator>::Take(path->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    take(size, ids);
  }
}

/** Calls take(a, b) for each edge of the line cells, with the ids of its ends. */
template <typename F>
void ForEachEdge(vtkPolyData* path, F&& take)
{
  const vtkIdType points = path->GetNumberOfPoints();
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 1; i < size; ++i)
      {
        if (std::min(ids[i - 1], ids[i]) >= 0 && std::max(ids[i - 1], ids[i]) < points)
        {
          take(ids[i - 1], ids[i]);
        }
      }
    });
}

bool AreNear(vtkPolyData* path, vtkIdType a, vtkIdType b, double near)
{
  double first[3];
  double second[3];
  path->GetPoint(a, first);
  path->GetPoint(b, second);
  return std::equal(
    first, first + 3, second, [near](double x, double y) { return std::abs(x - y) <= near; });
}

/**
 * Returns whether the only line cell passes through all points in the order in which they are
 * stored.
 */
bool IsInOrder(vtkPolyData* path)
{
  bool isInOrder = path->GetNumberOfLines() == 1;
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      isInOrder = isInOrder && size == path->GetNumberOfPoints();
      for (vtkIdType i = 0; isInOrder && i < size; ++i)
      {
        isInOrder = ids[i] == i;
      }
    });
  return isInOrder;
}

/**
 * Largest number of ticks: a day at 1 kHz. More ticks would come from a wrong unit of time, and
 * would not fit into memory.
 */
constexpr double MostTicks = 1e8;

/** Checks several numbers at once, so that the compiler can use SIMD instructions. */
bool AreFinite(const double* numbers, vtkIdType count)
{
  constexpr int lanes = 8;
  double sums[lanes] = {}; // sums of 0 * number: NaN if any number is not finite, otherwise 0
  vtkIdType i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    for (int lane = 0; lane < lanes; ++lane)
    {
      sums[lane] += 0.0 * numbers[i + lane];
    }
  }
  for (; i < count; ++i)
  {
    sums[0] += 0.0 * numbers[i];
  }
  return std::all_of(sums, sums + lanes, [](double sum) { return sum == 0.0; });
}

} // namespace

void DividedPoints::Append(const vtkIdType* ids, vtkIdType count)
{
  if (this->Points.empty())
  {
    vtkIdType same = 0;
    while (same < count && ids[same] == this->Count + same)
    {
      ++same;
    }
    if (same == count)
    {
      this->Count += count; // no list of points is needed while they are in order, as in most
                            // polydata
      return;
    }
    this->Points.resize(static_cast<std::size_t>(this->Count));
    std::iota(this->Points.begin(), this->Points.end(), vtkIdType(0));
  }
  this->Points.insert(this->Points.end(), ids, ids + count);
  this->Count += count;
}

bool TipPathLines::IsOfSegments() const
{
  vtkIdType longest = 0;
  ForEachLine(
    this->Path, [&](vtkIdType size, const vtkIdType*) { longest = std::max(longest, size); });
  return longest == 2;
}

bool TipPathLines::IsOne() const
{
  return this->Path->GetNumberOfLines() <= 1 || (this->IsOfSegments() && this->CountStrokes() <= 1);
}

bool TipPathLines::Divide(DividedPoints& divided, std::string& error) const
{
  vtkPolyData* const path = this->Path;
  const bool isOfSegments = this->IsOfSegments();
  const double near = isOfSegments && path->GetNumberOfPoints() > 0 ? ComputeRounding(path) : 0.0;
  divided = {};
  vtkIdType line = 0;
  bool isAfterSegment = false;
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        if ((ids[i] < 0 || ids[i] >= path->GetNumberOfPoints()) && error.empty())
        {
          error = "Line " + std::to_string(line) + " of the tip path, on input port 1, has point " +
            std::to_string(ids[i]) + ", and there are " +
            std::to_string(path->GetNumberOfPoints()) +
            " points. Make the line of points that exist.";
        }
      }
      ++line;
      if (!error.empty())
      {
        return;
      }
      const bool isSegment = isOfSegments && size == 2;
      const bool goesOn =
        isSegment && isAfterSegment && AreNear(path, divided.GetLast(), ids[0], near);
      if (!goesOn)
      {
        divided.Begins.push_back(divided.Count);
      }
      // Two consecutive segments share a point, which is only one tick.
      const vtkIdType known = goesOn && divided.GetLast() == ids[0] ? 1 : 0;
      divided.Append(ids + known, size - known);
      isAfterSegment = isSegment;
    });
  divided.Begins.push_back(divided.Count);
  return error.empty();
}

std::pair<long long, long long> TipPathLines::FindLeap() const
{
  vtkPolyData* const path = this->Path;
  if (IsInOrder(path))
  {
    return { -1, -1 };
  }
  // Number the points of cells from 1 in the order in which they are stored; 0 marks all other
  // points.
  std::vector<vtkIdType> number(static_cast<std::size_t>(path->GetNumberOfPoints()), 0);
  ForEachEdge(path, [&number](vtkIdType a, vtkIdType b) { number[a] = number[b] = 1; });
  vtkIdType count = 0;
  for (vtkIdType& one : number)
  {
    one = one != 0 ? ++count : 0;
  }
  // Whether a cell joins the point to the next point.
  std::vector<bool> isJoined(static_cast<std::size_t>(count) + 1, false);
  ForEachEdge(path,
    [&](vtkIdType a, vtkIdType b)
    {
      if (std::abs(number[a] - number[b]) == 1)
      {
        isJoined[std::min(number[a], number[b])] = true;
      }
    });
  const double near = count > 0 ? ComputeRounding(path) : 0.0;
  vtkIdType last = -1;
  for (vtkIdType point = 0; point < path->GetNumberOfPoints(); ++point)
  {
    if (number[point] == 0)
    {
      continue;
    }
    if (last >= 0 && !isJoined[number[last]])
    {
      if (!AreNear(path, last, point, near))
      {
        return { last, point };
      }
    }
    last = point;
  }
  return { -1, -1 };
}

std::size_t TipPathLines::CountStrokes() const
{
  vtkPolyData* const path = this->Path;
  // Line i starts at ends[2 i] and ends at ends[2 i + 1].
  std::vector<std::array<double, 3>> ends;
  ForEachLine(path,
    [&](vtkIdType size, const vtkIdType* points)
    {
      const bool isLine = size > 1 && std::min(points[0], points[size - 1]) >= 0 &&
        std::max(points[0], points[size - 1]) < path->GetNumberOfPoints();
      for (vtkIdType i = 0; isLine && i < 2; ++i)
      {
        ends.emplace_back();
        path->GetPoint(points[i * (size - 1)], ends.back().data());
      }
    });
  if (ends.size() <= 2)
  {
    return ends.size() / 2;
  }

  // Ends with equal positions meet. Between a cell and the next one, allow for rounding.
  const double near = ComputeRounding(path);
  Junctions junctions(ends.size());
  std::map<std::array<double, 3>, std::size_t> places;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    junctions.Join(i, places.emplace(ends[i], i).first->second);
    if (i > 0 && i % 2 == 0 &&
      std::equal(ends[i].begin(), ends[i].end(), ends[i - 1].begin(),
        [near](double a, double b) { return std::abs(a - b) <= near; }))
    {
      junctions.Join(i, i - 1);
    }
  }

  // By Euler's theorem, connected cells can be drawn with one stroke if at most two of their
  // junctions have an odd number of ends. Otherwise, every two of these junctions need one stroke.
  std::map<std::size_t, std::size_t> endsAt;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    ++endsAt[junctions.Find(i)];
  }
  Junctions pieces = junctions;
  for (std::size_t i = 0; i < ends.size(); i += 2)
  {
    pieces.Join(i, i + 1);
  }
  std::map<std::size_t, std::size_t> oddIn;
  for (const auto& [junction, count] : endsAt)
  {
    oddIn[pieces.Find(junction)] += count % 2;
  }
  return std::accumulate(oddIn.begin(), oddIn.end(), std::size_t(0),
    [](std::size_t sum, const auto& piece)
    { return sum + std::max<std::size_t>(1, piece.second / 2); });
}

std::string DescribeLackOfMemory(double ticks)
{
  // Bytes per tick: a Vector3 of the path; 25 numbers, 3 flags and an index in the trace
  // (HapticTrace).
  constexpr double bytes = 24.0 + 25.0 * 8.0 + 3.0 + 8.0;
  std::ostringstream message;
  message << "There is not enough memory for the " << std::setprecision(10) << ticks
          << " ticks of the tip path on input port 1: with the trace they take "
          << std::setprecision(3) << 1e-9 * bytes * ticks << " GB (" << bytes
          << " bytes a tick). Give the path in pieces, or lower ServoRate.";
  return message.str();
}

double TipPaths::ComputeLastTime() const
{
  double last = 0.0;
  for (std::size_t path = 0; path < this->GetNumberOfPaths(); ++path)
  {
    if (const vtkIdType ticks = this->GetNumberOfTicks(path); ticks > 0)
    {
      const double start = this->HaveTimes() ? this->GetTime(Members(*this, path).At(0)) : 0.0;
      last = std::max(last, start + static_cast<double>(ticks - 1) * this->Period);
    }
  }
  return last;
}

TipPaths::Members::Members(const TipPaths& paths, std::size_t path)
  : Size(paths.Points->GetNumberOfPoints())
{
  if (paths.AreSeveral())
  {
    const vtkIdType begin = paths.Divided.Begins[path];
    this->First = begin;
    this->Ids = paths.Divided.Points.empty() ? nullptr : paths.Divided.Points.data() + begin;
    this->Size = paths.Divided.Begins[path + 1] - begin;
  }
}

bool TipPaths::Read(vtkPolyData* path, double period, std::string& error)
{
  *this = {};
  this->Period = period;
  this->Points = path->GetPoints();
  const vtkIdType n = path->GetNumberOfPoints();
  if (n == 0)
  {
    return true;
  }
  vtkDataArray* const positions = this->Points->GetData();
  if (auto* const doubles = vtkDoubleArray::FastDownCast(positions))
  {
    this->Doubles = doubles->GetPointer(0);
  }
  else if (auto* const floats = vtkFloatArray::FastDownCast(positions))
  {
    this->Floats = floats->GetPointer(0);
  }
  const bool isRecording = path->GetPointData()->HasArray(RecordingNames::DeviceTip) != 0;
  if (!this->CheckPoints(error) || !this->DivideLines(path, error))
  {
    return false;
  }
  if (isRecording && this->AreSeveral())
  {
    error = "The tip path, on input port 1, is a recording, as it has the point array "
            "\"DeviceTip\", but of " +
      std::to_string(this->Divided.Begins.size() - 1) +
      " lines. Replay one recording at a time, or remove DeviceTip to use the lines as paths.";
    return false;
  }
  if (isRecording)
  {
    const std::string flaw = RecordedPathReader(path, this->Recording.emplace()).Read();
    if (!flaw.empty())
    {
      this->Recording.reset();
      error = "The tip path is a recording, as it has the point array \"DeviceTip\", but " + flaw +
        ". Record again, or remove DeviceTip to use the points as a path.";
      return false;
    }
    this->FirstTicks.push_back(static_cast<vtkIdType>(this->Recording->Tips.size()));
    return true;
  }
  return this->ReadTimes(path, error) && this->CountTicks(error);
}

Vector3 TipPaths::ConvertPoint(vtkIdType point) const
{
  if (this->Floats)
  {
    const float* const x = this->Floats + 3 * point;
    return { x[0], x[1], x[2] };
  }
  double x[3];
  this->Points->GetPoint(point, x);
  return { x[0], x[1], x[2] };
}

bool TipPaths::CheckPoints(std::string& error) const
{
  if (this->Doubles && AreFinite(this->Doubles, 3 * this->Points->GetNumberOfPoints()))
  {
    return true;
  }
  for (vtkIdType i = 0; i < this->Points->GetNumberOfPoints(); ++i)
  {
    if (!IsFinite(this->GetPoint(i)))
    {
      error = "The tip path has a coordinate that is NaN or infinite at point " +
        std::to_string(i) + ". Replace or remove that point.";
      return false;
    }
  }
  return true;
}

bool TipPaths::DivideLines(vtkPolyData* path, std::string& error)
{
  const TipPathLines lines(path);
  if (!lines.IsOne())
  {
    return lines.Divide(this->Divided, error);
  }
  if (const auto [from, to] = lines.FindLeap(); to >= 0)
  {
    error = "The points of the tip path, on input port 1, are stored in another order than its "
            "lines join them: the stylus would leap from point " +
      std::to_string(from) + " to point " + std::to_string(to) +
      ", which no line joins. Store the points in the order of the line: for example, join the "
      "lines with vtkStripper, with JoinContiguousSegmentsOn(), and use the Points of the one "
      "cell that this gives. Or, if the leaps are wanted, remove the line cells: the points are "
      "then felt one after the other.";
    return false;
  }
  return true;
}

bool TipPaths::ReadTimes(vtkPolyData* path, std::string& error)
{
  vtkDataArray* const array = path->GetPointData()->GetArray("Time");
  if (!array)
  {
    return true;
  }
  const vtkIdType n = path->GetNumberOfPoints();
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != n)
  {
    std::ostringstream message;
    message << "The point array \"Time\" of the tip path has " << array->GetNumberOfTuples()
            << " tuples of " << array->GetNumberOfComponents() << " component(s) for " << n
            << " points. Give it one number of seconds a point, or remove the array.";
    error = message.str();
    return false;
  }
  this->Times.resize(static_cast<std::size_t>(n));
  for (vtkIdType i = 0; i < n; ++i)
  {
    this->Times[i] = array->GetComponent(i, 0);
  }
  return true;
}

bool TipPaths::ReadHand(vtkPolyData* path, std::string& error)
{
  return this->Recording ||
    (this->ReadOrientations(path, error) && this->ReadSpinning(path, error));
}

bool TipPaths::ReadSpinning(vtkPolyData* path, std::string& error)
{
  vtkDataArray* const array = path->GetPointData()->GetArray(RecordingNames::Spinning);
  const vtkIdType n = path->GetNumberOfPoints();
  bool isGood = !array || array->GetNumberOfTuples() == n;
  for (vtkIdType i = 0; array && isGood && i < n; ++i)
  {
    const double spins = array->GetComponent(i, 0);
    isGood = array->GetNumberOfComponents() == 1 && (spins == 0.0 || spins == 1.0);
    this->Spinning.push_back(spins != 0.0);
  }
  if (!isGood)
  {
    error = "The point array \"Spinning\" of the tip path, on input port 1, does not say of each "
            "point whether a burr spins there. Give it a 1 or a 0 a point, or remove it: then it "
            "always spins.";
  }
  return isGood;
}

bool TipPaths::ReadOrientations(vtkPolyData* path, std::string& error)
{
  vtkDataArray* const array = path->GetPointData()->GetArray(RecordingNames::Orientation);
  if (!array)
  {
    return true;
  }
  const vtkIdType n = path->GetNumberOfPoints();
  std::ostringstream message;
  message << "The point array \"Orientation\" of the tip path, on input port 1, ";
  constexpr const char* cure = " Give it the four numbers w, x, y, z of a unit quaternion a point, "
                               "or four zeros for none, or remove the array.";
  if (array->GetNumberOfComponents() != 4 || array->GetNumberOfTuples() != n)
  {
    message << "has " << array->GetNumberOfTuples() << " tuples of "
            << array->GetNumberOfComponents() << " component(s) for " << n << " points." << cure;
    error = message.str();
    return false;
  }
  this->Orientations.resize(static_cast<std::size_t>(n));
  for (vtkIdType i = 0; i < n; ++i)
  {
    Quaternion& q = this->Orientations[i];
    q = ReadQuaternion(array, i);
    if (!IsIdentical(q, NoOrientation) && !MakeUnit(q))
    {
      message << "is (" << q.W << ", " << q.X << ", " << q.Y << ", " << q.Z << ") at point " << i
              << ", which is no unit quaternion." << cure;
      error = message.str();
      return false;
    }
  }
  return true;
}

bool TipPaths::CheckTimes(std::size_t path, std::string& error) const
{
  const Members members(*this, path);
  for (vtkIdType i = 0; i < members.GetSize(); ++i)
  {
    std::ostringstream message;
    const vtkIdType point = members.At(i);
    const double time = this->Times[point];
    if (!std::isfinite(time))
    {
      message << "The point array \"Time\" of the tip path is not finite at point " << point
              << ". Replace or remove that point.";
      error = message.str();
      return false;
    }
    if (i > 0 && time < this->Times[members.At(i - 1)])
    {
      message << "The point array \"Time\" of the tip path decreases from "
              << this->Times[members.At(i - 1)] << " s to " << time << " s at point " << point
              << ". Sort the points by time, or remove the array to take one point a tick.";
      error = message.str();
      return false;
    }
  }
  return true;
}

bool TipPaths::CountTicks(std::string& error)
{
  const std::size_t paths = this->AreSeveral() ? this->Divided.Begins.size() - 1 : 1;
  double longest = 0.0; // duration (s) of the longest path
  double most = 0.0;
  for (std::size_t path = 0; path < paths; ++path)
  {
    const Members members(*this, path);
    vtkIdType ticks = members.GetSize();
    if (!this->Times.empty() && ticks > 0)
    {
      if (!this->CheckTimes(path, error))
      {
        return false;
      }
      const double span = this->Times[members.At(ticks - 1)] - this->Times[members.At(0)];
      longest = std::max(longest, span);
      most += span / this->Period;
      if (!(most < MostTicks))
      {
        std::ostringstream message;
        message << "The tip path would take " << most << " ticks: its point array \"Time\" spans "
                << longest << " s. Time is in seconds; convert it if it is in other units.";
        error = message.str();
        return false;
      }
      ticks = static_cast<vtkIdType>(std::floor(span / this->Period + SnapFraction)) + 1;
    }
    this->FirstTicks.push_back(this->FirstTicks.back() + ticks);
  }
  return true;
}

} // namespace VolumeHaptics
