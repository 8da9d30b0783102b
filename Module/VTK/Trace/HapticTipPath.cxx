// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/HapticTipPath.h"

#include "VTK/Trace/RecordedPathReader.h"
#include "VTK/Trace/RecordingNames.h"
#include "VTK/Trace/TipPathLines.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <new>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** A day at 1 kHz: more means a wrong unit of time, and would not fit into memory. */
constexpr double MostTicks = 1e8;
/** If a point's time differs from a tick's by less than this share of a tick, it is the tick's. */
constexpr double SnapShare = 1e-6;

Vector3 ReadPoint(vtkPolyData* path, vtkIdType i)
{
  double x[3];
  path->GetPoint(i, x);
  return { x[0], x[1], x[2] };
}

bool ReadTimes(
  vtkPolyData* path, vtkDataArray* array, std::vector<double>& times, std::string& error)
{
  const vtkIdType n = path->GetNumberOfPoints();
  std::ostringstream message;
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != n)
  {
    message << "The point array \"Time\" of the tip path has " << array->GetNumberOfTuples()
            << " tuples of " << array->GetNumberOfComponents() << " component(s) for " << n
            << " points. Give it one number of seconds a point, or remove the array.";
    error = message.str();
    return false;
  }
  times.resize(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    times[i] = array->GetComponent(i, 0);
    if (!std::isfinite(times[i]))
    {
      message << "The point array \"Time\" of the tip path is not finite at point " << i
              << ". Replace or remove that point.";
      error = message.str();
      return false;
    }
    if (i > 0 && times[i] < times[i - 1])
    {
      message << "The point array \"Time\" of the tip path decreases from " << times[i - 1]
              << " s to " << times[i] << " s at point " << i
              << ". Sort the points by time, or remove the array to take one point a tick.";
      error = message.str();
      return false;
    }
  }
  return true;
}

void Resample(vtkPolyData* path, const std::vector<double>& times, double period, TipPath& result)
{
  const double start = times.front();
  const auto ticks =
    static_cast<vtkIdType>(std::floor((times.back() - start) / period + SnapShare)) + 1;
  const auto last = static_cast<vtkIdType>(times.size()) - 1;
  result.StartTime = start;
  result.Tips.reserve(ticks);
  vtkIdType before = 0;
  for (vtkIdType tick = 0; tick < ticks; ++tick)
  {
    const double time = start + tick * period;
    const double snap = SnapShare * period;
    while (before < last && times[before + 1] <= time + snap)
    {
      ++before;
    }
    const Vector3 a = ReadPoint(path, before);
    if (before == last || std::abs(time - times[before]) <= snap)
    {
      result.Tips.push_back(a);
      continue;
    }
    const double share = (time - times[before]) / (times[before + 1] - times[before]);
    result.Tips.push_back(a + share * (ReadPoint(path, before + 1) - a));
  }
}

} // namespace

std::string DescribeLackOfMemory(double ticks)
{
  // A Vector3 of the path; 25 numbers, 3 flags and an index of the trace: see HapticTrace.
  constexpr double bytes = 24.0 + 25.0 * 8.0 + 3.0 + 8.0;
  std::ostringstream message;
  message << "There is not enough memory for the " << std::setprecision(10) << ticks
          << " ticks of the tip path on input port 1: with the trace they take "
          << std::setprecision(3) << 1e-9 * bytes * ticks << " GB (" << bytes
          << " bytes a tick). Give the path in pieces, or lower ServoRate.";
  return message.str();
}

bool ReadTipPath(vtkPolyData* path, double period, TipPath& result, std::string& error)
{
  const vtkIdType n = path->GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i)
  {
    if (!IsFinite(ReadPoint(path, i)))
    {
      error = "The tip path has a coordinate that is NaN or infinite at point " +
        std::to_string(i) + ". Replace or remove that point.";
      return false;
    }
  }
  vtkDataArray* const array = path->GetPointData()->GetArray("Time");
  if (n == 0)
  {
    return true;
  }
  if (const std::size_t lines = TipPathLines(path).Count(); lines > 1)
  {
    error = "The tip path, on input port 1, is of " + std::to_string(lines) +
      " lines, which do not continue one another: the stylus would leap from each to the next. "
      "Feel one line at a time, for example with a path for each. Or remove the line cells, if "
      "the leaps are wanted: the points are then felt one after the other.";
    return false;
  }
  if (const auto [from, to] = TipPathLines(path).FindLeap(); to >= 0)
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
  if (path->GetPointData()->HasArray(RecordingNames::DeviceTip))
  {
    result = {};
    const std::string flaw = RecordedPathReader(path, result).Read();
    if (!flaw.empty())
    {
      result = {};
      error = "The tip path is a recording, as it has the point array \"DeviceTip\", but " + flaw +
        ". Record again, or remove DeviceTip to use the points as a path.";
      return false;
    }
    return true;
  }
  if (!array)
  {
    result.Tips.reserve(n);
    for (vtkIdType i = 0; i < n; ++i)
    {
      result.Tips.push_back(ReadPoint(path, i));
    }
    return true;
  }
  std::vector<double> times;
  if (!ReadTimes(path, array, times, error))
  {
    return false;
  }
  const double ticks = (times.back() - times.front()) / period;
  if (!(ticks < MostTicks))
  {
    std::ostringstream message;
    message << "The tip path would take " << ticks << " ticks: its point array \"Time\" spans "
            << times.back() - times.front()
            << " s. Time is in seconds; convert it if it is in other units.";
    error = message.str();
    return false;
  }
  try
  {
    Resample(path, times, period, result);
  }
  catch (const std::bad_alloc&)
  {
    error = DescribeLackOfMemory(std::floor(ticks) + 1.0);
    return false;
  }
  return true;
}

} // namespace VolumeHaptics
