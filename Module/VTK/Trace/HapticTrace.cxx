// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/HapticTrace.h"

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/TickRecord.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkLongLongArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace VolumeHaptics
{
namespace
{

vtkSmartPointer<vtkDataArray> NewArray(const TraceColumn& column)
{
  vtkSmartPointer<vtkDataArray> array;
  if (column.Type == ColumnType::UInt8)
  {
    array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  }
  else
  {
    array = vtkSmartPointer<vtkDoubleArray>::New();
  }
  array->SetName(column.Name);
  array->SetNumberOfComponents(column.Components);
  return array;
}

} // namespace

HapticTrace::HapticTrace()
{
  this->Proxies->SetDataTypeToDouble();
  for (const TraceColumn& column : GetTraceColumns())
  {
    this->Arrays.push_back(NewArray(column));
  }
}

HapticTrace::~HapticTrace() = default;

void HapticTrace::Reserve(vtkIdType ticks)
{
  this->Proxies->Allocate(ticks);
  for (vtkDataArray* const array : this->Arrays)
  {
    array->Allocate(ticks * array->GetNumberOfComponents());
  }
}

void HapticTrace::Append(const HapticModel& model, double time, const TickRecord& record)
{
  const TraceRow row = MakeTraceRow(model, time, record, this->Work);
  this->Proxies->InsertNextPoint(row.Proxy);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(&row);
  const std::vector<TraceColumn>& columns = GetTraceColumns();
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const unsigned char* const tuple = bytes + columns[i].Offset;
    vtkDataArray* const array = this->Arrays[i];
    if (columns[i].Type == ColumnType::UInt8)
    {
      static_cast<vtkUnsignedCharArray*>(array)->InsertNextTypedTuple(tuple);
    }
    else
    {
      static_cast<vtkDoubleArray*>(array)->InsertNextTypedTuple(
        reinterpret_cast<const double*>(tuple));
    }
  }
  if (model.Baked->Labels)
  {
    if (!this->Labels)
    {
      this->Labels = vtkSmartPointer<vtkLongLongArray>::New();
      this->Labels->SetName("Label");
    }
    this->Labels->InsertNextValue(GetTraceLabel(model, record));
  }
}

void HapticTrace::WriteTo(vtkPolyData* output)
{
  const vtkIdType ticks = this->Proxies->GetNumberOfPoints();
  output->SetPoints(this->Proxies);
  if (ticks > 1)
  {
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(ticks));
    for (vtkIdType i = 0; i < ticks; ++i)
    {
      lines->InsertCellPoint(i);
    }
    output->SetLines(lines);
  }
  for (vtkDataArray* const array : this->Arrays)
  {
    output->GetPointData()->AddArray(array);
  }
  if (this->Labels)
  {
    output->GetPointData()->AddArray(this->Labels);
  }
}

} // namespace VolumeHaptics
