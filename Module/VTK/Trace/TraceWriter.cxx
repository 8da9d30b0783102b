// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TraceWriter.h"

#include "Core/Platform/FileReplacement.h"
#include "VTK/Base/XmlFiles.h"
#include "VTK/Trace/HapticTraceColumns.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <iomanip>
#include <limits>
#include <locale>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

TraceTable::TraceTable()
{
  this->Line.imbue(std::locale::classic());
  this->Line << std::setprecision(std::numeric_limits<double>::max_digits10);
}

void TraceTable::AddTitle(const std::string& array, int components)
{
  static const char* const axes[] = { " w", " x", " y", " z" };
  // The first of four components is w; a vector starts with x.
  const bool hasAxes = components == 3 || components == 4;
  for (int c = 0; c < components; ++c)
  {
    this->Line << this->Separator << array << (hasAxes ? axes[c + 4 - components] : "")
               << GetTraceUnit(array);
    this->Separator = ",";
  }
}

void TraceTable::AddNumber(double number)
{
  this->Line << this->Separator << number;
  this->Separator = ",";
}

std::string TraceTable::EndLine()
{
  std::string line = this->Line.str() + "\n";
  this->Line.str({});
  this->Separator = "";
  return line;
}

bool WriteTracePolyData(vtkPolyData* trace, const std::string& file, std::string& error)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  return WriteXmlFile(writer, trace, file, error);
}

bool WriteTraceTable(vtkPolyData* trace, const std::string& file, std::string& error)
{
  // Put time and position first, for people who read the table.
  std::vector<std::pair<std::string, vtkDataArray*>> columns;
  vtkPointData* const arrays = trace->GetPointData();
  if (vtkDataArray* const time = arrays->GetArray("Time"))
  {
    columns.emplace_back("Time", time);
  }
  if (trace->GetPoints())
  {
    columns.emplace_back("Proxy", trace->GetPoints()->GetData());
  }
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = arrays->GetArray(i);
    if (array && array->GetName() && std::string(array->GetName()) != "Time")
    {
      columns.emplace_back(array->GetName(), array);
    }
  }

  FileReplacement replacement;
  if (!replacement.Open(file, error))
  {
    return false;
  }
  TraceTable table;
  for (const auto& [name, values] : columns)
  {
    table.AddTitle(name, values->GetNumberOfComponents());
  }
  replacement.Write(table.EndLine());
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    for (const auto& [name, values] : columns)
    {
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        table.AddNumber(values->GetComponent(i, c));
      }
    }
    replacement.Write(table.EndLine());
  }
  return replacement.Commit(error);
}

} // namespace VolumeHaptics
