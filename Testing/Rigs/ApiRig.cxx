// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ApiRig.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cstring>

namespace apitest
{
MessageLog::MessageLog(vtkObject* watched)
  : Watched(watched)
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long event, void* log, void* text)
    {
      auto* const self = static_cast<MessageLog*>(log);
      (event == vtkCommand::ErrorEvent ? self->Errors : self->Warnings)
        .emplace_back(static_cast<const char*>(text));
    });
  watched->AddObserver(vtkCommand::ErrorEvent, this->Command);
  watched->AddObserver(vtkCommand::WarningEvent, this->Command);
}

MessageLog::~MessageLog()
{
  if (this->Watched)
  {
    this->Watched->RemoveObserver(this->Command);
  }
}

vtkSmartPointer<vtkImageData> MakeImage(
  int n, int scalarType, const std::function<double(const Point&)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point x;
    image->GetPoint(i, x.data());
    scalars->SetComponent(i, 0, value(x));
  }
  return image;
}

vtkSmartPointer<vtkImageData> MakeRamp(int n, int scalarType)
{
  return MakeImage(n, scalarType, [](const Point& x) { return 100.0 * x[2]; });
}

vtkSmartPointer<vtkPolyData> MakePath(
  const std::vector<Point>& points, const std::vector<double>& times)
{
  auto path = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> list;
  list->SetDataTypeToDouble();
  for (const Point& x : points)
  {
    list->InsertNextPoint(x.data());
  }
  path->SetPoints(list);
  if (!times.empty())
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Time");
    for (const double time : times)
    {
      array->InsertNextValue(time);
    }
    path->GetPointData()->AddArray(array);
  }
  return path;
}

std::vector<Point> Line(const Point& a, const Point& b, int steps)
{
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i)
  {
    const double s = static_cast<double>(i) / steps;
    points.push_back(
      { a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), a[2] + s * (b[2] - a[2]) });
  }
  return points;
}

void SetConstant(vtkPiecewiseFunction* function, double value)
{
  function->RemoveAllPoints();
  function->AddPoint(0.0, value);
}

double Get(vtkPolyData* output, const char* array, vtkIdType tick, int component)
{
  vtkDataArray* const data = output->GetPointData()->GetArray(array);
  if (!data || tick >= data->GetNumberOfTuples() || component >= data->GetNumberOfComponents())
  {
    ADD_FAILURE() << "no tick " << tick << " in point array " << array;
    return 0.0;
  }
  return data->GetComponent(tick, component);
}

vtkSmartPointer<vtkPolyData> Keep(vtkVolumeHapticsFilter* filter)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutput());
  return copy;
}
} // namespace apitest
