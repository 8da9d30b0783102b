// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/TipPaths.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Trace/Paths/RecordedPathReader.h"
#include "VTK/Trace/RecordingNames.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** A day at 1 kHz: more ticks mean a wrong unit of time, and would not fit into memory. */
constexpr double MostTicks = 1e8;

/** Checks several numbers at once, by the processor's wide instructions. */
bool AreFinite(const double* numbers, vtkIdType count)
{
  constexpr int lanes = 8;
  double sums[lanes] = {}; // sums of zeros; NaN once a number is not finite
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

std::string DescribeLackOfMemory(double ticks)
{
  // Counts a Vector3 of the path; 25 numbers, 3 flags and an index of the trace: see HapticTrace.
  constexpr double bytes = 24.0 + 25.0 * 8.0 + 3.0 + 8.0;
  std::ostringstream message;
  message << "There is not enough memory for the " << std::setprecision(10) << ticks
          << " ticks of the tip path on input port 1: with the trace they take "
          << std::setprecision(3) << 1e-9 * bytes * ticks << " GB (" << bytes
          << " bytes a tick). Give the path in pieces, or lower ServoRate.";
  return message.str();
}

double TipPaths::FindLastTime() const
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
  double longest = 0.0; // s
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
      ticks = static_cast<vtkIdType>(std::floor(span / this->Period + SnapShare)) + 1;
    }
    this->FirstTicks.push_back(this->FirstTicks.back() + ticks);
  }
  return true;
}

} // namespace VolumeHaptics
