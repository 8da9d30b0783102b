// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Tools/NeedleTrace.h"

#include "Core/Model/HapticModel.h"
#include "Core/State/NeedleState.h"
#include "VTK/Base/HapticTuples.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double DegreesPerRadian = 57.295779513082320876798;
/** Largest angle (degrees) at which a normal counts as equal to the axis. */
constexpr double LeastAngle = 1e-4;

/**
 * Returns the angle (degrees) between an axis and the normal at the entry, both unit vectors; -1
 * without a normal.
 */
double ComputeAngle(const Vector3& axis, const Vector3& normal)
{
  return Dot(normal, normal) > 0.0
    ? DegreesPerRadian * std::acos(std::clamp(Dot(axis, normal), -1.0, 1.0))
    : -1.0;
}

/** Collects the positions along a track, and the tissue between them. */
class TrackWriter
{
public:
  TrackWriter()
  {
    this->Points->SetDataTypeToDouble();
    this->Depths->SetName("Depth");
    this->Labels->SetName("Label");
    this->Lengths->SetName("Length");
  }

  /** Adds the position where a stretch of tissue begins or where the track ends. */
  void Begin(const Vector3& place, double depth, std::int64_t label)
  {
    const vtkIdType point = this->Points->InsertNextPoint(place.X, place.Y, place.Z);
    this->Depths->InsertNextValue(depth);
    if (point > 0)
    {
      const vtkIdType line[] = { point - 1, point };
      this->Lines->InsertNextCell(2, line);
      this->Labels->InsertNextValue(this->Label == NoLabel ? 0 : this->Label);
      this->Lengths->InsertNextValue(depth - this->Depths->GetValue(point - 1));
    }
    this->Label = label;
  }

  static void AddNumber(vtkPolyData* track, const char* name, double value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    track->GetFieldData()->AddArray(array);
  }

  void WriteTo(vtkPolyData* track) const
  {
    track->Initialize();
    track->SetPoints(this->Points);
    track->SetLines(this->Lines);
    track->GetPointData()->AddArray(this->Depths);
    track->GetCellData()->AddArray(this->Labels);
    track->GetCellData()->AddArray(this->Lengths);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Depths;
  vtkNew<vtkDoubleArray> Lengths;
  vtkNew<vtkLongLongArray> Labels;
  std::int64_t Label = NoLabel;
};

/** Arrays of the trace from which a track is made. */
struct NeedleTicks
{
  vtkPolyData* Trace;
  vtkDataArray* Depths;
  vtkDataArray* Normals;
  vtkDataArray* Labels;    ///< may be null
  vtkDataArray* Strengths; ///< NormalForce; may be null
  vtkDataArray* Touches;   ///< may be null

  double DepthAt(vtkIdType i) const { return this->Depths->GetComponent(i, 0); }
  std::int64_t LabelAt(vtkIdType i) const
  {
    return this->Labels ? static_cast<std::int64_t>(this->Labels->GetComponent(i, 0)) : 0;
  }
  Vector3 PlaceAt(vtkIdType i) const
  {
    double x[3];
    this->Trace->GetPoint(i, x);
    return { x[0], x[1], x[2] };
  }
};

/** Writes the track of the insertion between two ticks. */
void WriteInsertion(const NeedleTicks& ticks, vtkIdType first, vtkIdType last, vtkPolyData* track)
{
  TrackWriter writer;
  const Vector3 axis = ReadVector(ticks.Normals, first);
  writer.Begin(ticks.PlaceAt(first) - ticks.DepthAt(first) * axis, 0.0, ticks.LabelAt(first));
  std::int64_t label = ticks.LabelAt(first);
  vtkIdType deepest = first;
  for (vtkIdType i = first + 1; i <= last; ++i)
  {
    if (ticks.DepthAt(i) > ticks.DepthAt(deepest))
    {
      if (ticks.LabelAt(i) != label)
      {
        // The boundary held the point until this tick. From here, the point jumps ahead if the
        // tissue behind the boundary resists less.
        label = ticks.LabelAt(i);
        writer.Begin(ticks.PlaceAt(deepest), ticks.DepthAt(deepest), label);
      }
      deepest = i;
    }
  }
  writer.Begin(ticks.PlaceAt(deepest), ticks.DepthAt(deepest), label);
  writer.WriteTo(track);
  // After the insertion, the recorded normals are the needle's axis. Search backwards through the
  // preceding ticks of contact for the last normal that is still the surface's. If every normal is
  // the axis, the needle met the surface at a right angle.
  const auto isHeld = [&ticks](vtkIdType tick)
  { return tick >= 0 && ticks.Strengths && ticks.Strengths->GetComponent(tick, 0) > 0.0; };
  vtkIdType before = first - 1;
  while (isHeld(before - 1) && ComputeAngle(axis, ReadVector(ticks.Normals, before)) < LeastAngle)
  {
    --before;
  }
  const Vector3 normal = isHeld(before) ? ReadVector(ticks.Normals, before) : Vector3{};
  TrackWriter::AddNumber(track, "Depth", ticks.DepthAt(deepest));
  TrackWriter::AddNumber(track, "Angle", ComputeAngle(axis, normal));
  if (ticks.Touches)
  {
    TrackWriter::AddNumber(track, "ForbiddenTouches", ticks.Touches->GetComponent(last, 0));
  }
}

} // namespace

std::string MakeNeedleTrack(vtkPolyData* trace, vtkPolyData* track)
{
  if (!trace)
  {
    track->Initialize();
    return "MakeTrack() needs the trace of a needle, but got a null pointer.";
  }
  if (trace == track)
  {
    return "MakeTrack() got one polydata for both trace and track. Give it another one for the "
           "track.";
  }
  vtkPointData* const data = trace->GetPointData();
  const NeedleTicks ticks{ trace, data->GetArray("Depth"), data->GetArray("Normal"),
    data->GetArray("Label"), data->GetArray("NormalForce"), data->GetArray("ForbiddenTouches") };
  const vtkIdType n = trace->GetNumberOfPoints();
  const auto fits = [n](vtkDataArray* array, int components)
  {
    return array && array->GetNumberOfTuples() == n && array->GetNumberOfComponents() == components;
  };
  if (!fits(ticks.Depths, 1) || !fits(ticks.Normals, 3) ||
    (ticks.Labels && !fits(ticks.Labels, 1)) || (ticks.Strengths && !fits(ticks.Strengths, 1)) ||
    (ticks.Touches && !fits(ticks.Touches, 1)))
  {
    track->Initialize();
    return "The trace has no point arrays \"Depth\" and \"Normal\" of a needle, one tuple a point. "
           "Make it with vtkVolumeHapticsFilter and SetTool(needle), and keep both arrays in "
           "SetTraceArrays().";
  }
  vtkIdType last = n - 1;
  while (last >= 0 && !(ticks.DepthAt(last) > 0.0))
  {
    --last;
  }
  vtkIdType first = last;
  while (first > 0 && ticks.DepthAt(first - 1) > 0.0)
  {
    --first;
  }
  track->Initialize();
  if (last >= 0)
  {
    WriteInsertion(ticks, first, last, track);
  }
  return {};
}

void WriteNeedleTrack(
  const HapticModel& model, const NeedleState& needle, const Vector3& proxy, vtkPolyData* track)
{
  TrackWriter writer;
  const auto place = [&](double depth)
  { return model.DeviceToWorld(proxy - (needle.Depth - depth) * needle.Axis); };
  const NeedleTrack& stretches = needle.Track;
  for (int i = 0; needle.IsInserted && i < stretches.GetSize(); ++i)
  {
    const double begin = stretches[i].Begin;
    // Merge adjacent stretches of the same label, which differ only in their friction.
    if (i == 0 || stretches[i].Label != stretches[i - 1].Label)
    {
      writer.Begin(place(begin), model.WorldUnitsPerMeter * begin, stretches[i].Label);
    }
  }
  if (needle.IsInserted)
  {
    writer.Begin(place(needle.Depth), model.WorldUnitsPerMeter * needle.Depth, NoLabel);
  }
  writer.WriteTo(track);
  TrackWriter::AddNumber(
    track, "Depth", needle.IsInserted ? model.WorldUnitsPerMeter * needle.Depth : 0.0);
  TrackWriter::AddNumber(track, "Deepest", model.WorldUnitsPerMeter * needle.Deepest);
  TrackWriter::AddNumber(
    track, "Angle", needle.IsInserted ? ComputeAngle(needle.Axis, needle.Normal) : -1.0);
  TrackWriter::AddNumber(track, "ShaftForce", stretches.Sum(needle.Depth));
  TrackWriter::AddNumber(track, "ForbiddenTouches", needle.Touches);
}

} // namespace VolumeHaptics
