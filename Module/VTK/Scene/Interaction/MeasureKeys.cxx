// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/MeasureKeys.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Measure/MeasurementPolyData.h"
#include "VTK/Scene/Interaction/SceneFrames.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Smallest force (N) that counts as a touch. */
constexpr double LeastMeasuredForce = 0.005;
/** Radius of the brush, and smallest distance between two of its positions (voxels). */
constexpr double BrushVoxels = 4.0;
constexpr double BrushStepVoxels = 0.25;
/**
 * Largest fraction of the program's time that may be spent on cutting a growing area out of the
 * surface.
 */
constexpr double CutFraction = 0.1;

bool IsTouching(vtkHapticDevice* device)
{
  return device && device->IsRunning() &&
    (device->GetState()->GetContact() != 0 ||
      Norm(FromArray(device->GetState()->GetComputedForce())) >= LeastMeasuredForce);
}

/** Returns the value at a position, interpolated linearly between the eight samples around it. */
double ValueAt(vtkImageData* image, vtkDataArray* array, int component, const Vector3& world)
{
  const double at[3] = { world.X, world.Y, world.Z };
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(at, index);
  const int* const extent = image->GetExtent();
  int low[3];
  double fraction[3];
  for (int a = 0; a < 3; ++a)
  {
    const double inside = std::clamp<double>(index[a], extent[2 * a], extent[2 * a + 1]);
    low[a] = std::min(static_cast<int>(std::floor(inside)), extent[2 * a + 1] - 1);
    fraction[a] = inside - low[a];
  }
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    int place[3];
    double weight = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      const bool isHigh = (corner >> a & 1) != 0;
      place[a] = low[a] + (isHigh ? 1 : 0);
      weight *= isHigh ? fraction[a] : 1.0 - fraction[a];
    }
    value += weight * array->GetComponent(image->ComputePointId(place), component);
  }
  return value;
}

/** Reads a number from a column of a table of states. */
double Read(vtkTable* states, const char* column, vtkIdType row, int component = 0)
{
  return vtkDataArray::SafeDownCast(states->GetColumnByName(column))->GetComponent(row, component);
}

Vector3 ReadPosition(vtkTable* states, const char* column, vtkIdType row)
{
  return { Read(states, column, row, 0), Read(states, column, row, 1),
    Read(states, column, row, 2) };
}

} // namespace

//------------------------------------------------------------------------------
bool MeasureKeys::Press(const std::string& key)
{
  // Keep a reference to the list, because observers of its changes may remove it.
  const vtkSmartPointer<vtkHapticMeasurements> list = this->Scene.Measurements;
  if (!list)
  {
    return false;
  }
  if (key == "1" || key == "2" || key == "3")
  {
    this->SetPoint(key == "1" ? MeasuredKind::Point
        : key == "2"          ? MeasuredKind::Distance
                              : MeasuredKind::Angle);
  }
  else if (key == "4" || key == "5")
  {
    this->BeginOrEnd(key == "4" ? MeasuredKind::Path : MeasuredKind::Area);
  }
  else if (key == "Ctrl+z")
  {
    this->Undo();
  }
  else if (key == "Ctrl+y")
  {
    list->Redo();
  }
  else if (key == "Delete" && list->GetNumberOfMeasurements() > 0)
  {
    list->Remove(list->GetNumberOfMeasurements() - 1);
  }
  else if (key == "i" && this->Scene.Display)
  {
    this->Scene.Display->SetMeasurementsVisibility(
      !this->Scene.Display->GetMeasurementsVisibility());
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void MeasureKeys::SetPoint(MeasuredKind kind)
{
  vtkHapticDevice* const device = this->Scene.Device;
  if (!IsTouching(device))
  {
    this->Report(
      "Nothing is touched: touch the volume where you want to measure, then press the key");
    return;
  }
  this->Report({});
  if (this->IsFollowing)
  {
    this->Finish();
  }
  if (this->Begun.Kind != kind)
  {
    this->Begun = {};
    this->Begun.Kind = kind;
  }
  MeasuredSample sample;
  sample.Time = device->GetState()->GetTime();
  sample.Force = FromArray(device->GetState()->GetComputedForce());
  sample.SurfaceValue = device->GetState()->GetSurfaceValue();
  this->Begun.Points.push_back(this->Scene.GetProxy());
  this->Begun.Samples.push_back(sample);
  if (static_cast<int>(this->Begun.Points.size()) == CountPoints(kind))
  {
    this->Finish();
  }
  else
  {
    this->Show();
  }
}

//------------------------------------------------------------------------------
void MeasureKeys::Undo()
{
  if (this->Begun.Points.empty() || this->IsFollowing)
  {
    this->Scene.Measurements->Undo();
    return;
  }
  this->Begun.Points.pop_back();
  this->Begun.Samples.pop_back();
  this->Show();
}

//------------------------------------------------------------------------------
void MeasureKeys::BeginOrEnd(MeasuredKind kind)
{
  const bool ends = this->IsFollowing && this->Begun.Kind == kind;
  this->End();
  this->Report({});
  if (!ends)
  {
    this->IsFollowing = true;
    this->Begun.Kind = kind;
    this->NextCut = {};
    if (!IsTouching(this->Scene.Device))
    {
      this->Report(kind == MeasuredKind::Path ? "The path begins where you touch"
                                              : "The area begins where you touch");
    }
  }
}

//------------------------------------------------------------------------------
void MeasureKeys::End()
{
  if (this->IsFollowing)
  {
    this->Finish();
  }
  this->Begun = {};
  this->Show();
}

//------------------------------------------------------------------------------
void MeasureKeys::Finish()
{
  const Measurement done = std::exchange(this->Begun, {});
  const std::unique_ptr<PaintedPatch> brush = std::move(this->Brush);
  this->IsFollowing = false;
  this->Show();
  vtkSmartPointer<vtkPolyData> shape = brush ? brush->Cut() : vtkSmartPointer<vtkPolyData>::New();
  if (done.Kind != MeasuredKind::Area)
  {
    CopyShape(done, shape);
  }
  if (this->Scene.Measurements && shape->GetNumberOfPoints() > 0)
  {
    this->Scene.Measurements->AddMeasurement(static_cast<int>(done.Kind), shape);
  }
  else if (done.Kind == MeasuredKind::Area && brush)
  {
    this->Report("Nothing was painted: the values of the image have no edge where you touched. "
                 "Paint where tissues differ, or with the method SURFACE_PROXY");
  }
}

//------------------------------------------------------------------------------
std::unique_ptr<PaintedPatch> MeasureKeys::MakeBrush(const Vector3& proxy, double surfaceValue)
{
  vtkVolumeHapticsFilter* const filter = this->Scene.Device->GetVolumeHaptics();
  vtkImageData* const image = this->Scene.GetImage();
  vtkDataArray* const array = image ? filter->GetBaker().GetReading().GetArray(image) : nullptr;
  if (!array || array->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    image->GetDataDimension() != 3)
  {
    return nullptr;
  }
  const int component =
    std::min(filter->GetProperty()->GetComponent(), array->GetNumberOfComponents() - 1);
  const bool isIso = filter->GetMethod() == vtkVolumeHapticsFilter::SURFACE_PROXY;
  const double value =
    isIso ? filter->GetIsoValue() : 0.5 * (ValueAt(image, array, component, proxy) + surfaceValue);
  const double voxel = SmallestSpacing(image);
  const double wanted = this->Scene.Measurements->GetBrushRadius();
  this->BrushStep = BrushStepVoxels * voxel;
  return std::make_unique<PaintedPatch>(
    image, array, component, value, wanted > 0.0 ? wanted : BrushVoxels * voxel);
}

//------------------------------------------------------------------------------
void MeasureKeys::PaintTo(const Vector3& proxy, double surfaceValue)
{
  if (!this->Brush)
  {
    this->Brush = this->MakeBrush(proxy, surfaceValue);
  }
  else if (Norm(proxy - this->Painted) < this->BrushStep)
  {
    return;
  }
  this->Painted = proxy;
  if (this->Brush)
  {
    this->Brush->LeadTo(proxy);
  }
}

//------------------------------------------------------------------------------
void MeasureKeys::Update(vtkTable* states)
{
  if (!this->IsFollowing || !this->Scene.Measurements || !this->Scene.Device)
  {
    return;
  }
  if (this->Brush && !this->Brush->IsOf(this->Scene.GetImage()))
  {
    this->Finish();
    this->Report("The area ends here, because other data were read. Begin a new one");
    return;
  }
  const double spacing = this->Scene.Measurements->GetPathSpacing();
  bool isNew = false;
  for (vtkIdType row = 0; row < states->GetNumberOfRows(); ++row)
  {
    if (Read(states, "Contact", row) == 0.0)
    {
      if (this->Brush)
      {
        this->Brush->Lift();
      }
      continue;
    }
    isNew = true;
    const Vector3 proxy = ReadPosition(states, "Proxy", row);
    const double value = Read(states, "SurfaceValue", row);
    if (this->Begun.Kind == MeasuredKind::Area)
    {
      this->PaintTo(proxy, value);
    }
    else if (this->Begun.Points.empty() || Norm(proxy - this->Begun.Points.back()) >= spacing)
    {
      this->Begun.Points.push_back(proxy);
      this->Begun.Samples.push_back(
        { Read(states, "Time", row), ReadPosition(states, "Force", row), value });
    }
  }
  if (isNew)
  {
    const bool isPaintable = this->Begun.Kind != MeasuredKind::Area || this->Brush;
    this->Report(
      isPaintable ? "" : "An area can't be painted here: the touched data are no 3D image");
    this->Show();
  }
}

//------------------------------------------------------------------------------
void MeasureKeys::Show()
{
  vtkHapticMeasurements* const list = this->Scene.Measurements;
  if (!list)
  {
    return;
  }
  vtkSmartPointer<vtkPolyData> shape;
  if (this->Brush)
  {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point before = Clock::now();
    if (before < this->NextCut)
    {
      return;
    }
    shape = this->Brush->Cut();
    const Clock::time_point after = Clock::now();
    this->NextCut =
      after + std::chrono::duration_cast<Clock::duration>((after - before) / CutFraction);
  }
  else if (!this->Begun.Points.empty())
  {
    shape = vtkSmartPointer<vtkPolyData>::New();
    CopyShape(this->Begun, shape);
  }
  const bool isThere = shape && shape->GetNumberOfPoints() > 0;
  list->SetUnfinished(static_cast<int>(this->Begun.Kind), isThere ? shape.Get() : nullptr);
}

//------------------------------------------------------------------------------
void MeasureKeys::Report(const std::string& notice)
{
  // Leave notices that other parts have set.
  if (!notice.empty() || !this->Told.empty())
  {
    this->Told = notice;
    this->Frames.Notify(notice);
  }
}

} // namespace VolumeHaptics
