// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticTraceFiles.h"

#include "HapticTipPath.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtk_jsoncpp.h"
#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <iomanip>
#include <locale>

namespace VolumeHaptics
{
namespace
{

const char* const Axes[] = { " x", " y", " z" };

std::string Unit(const std::string& array)
{
  static const std::pair<const char*, const char*> units[] = { { "Time", " (s)" },
    { "Proxy", " (world)" }, { "Tip", " (world)" }, { RecordingNames::DeviceTip, " (m)" },
    { "Force", " (N)" }, { "Command", " (N)" }, { "NormalForce", " (N)" },
    { "FrictionForce", " (N)" }, { "DragForce", " (N)" }, { "Viscosity", " (N)" },
    { "SurfaceStrength", " (N)" }, { "Stiffness", " (N/m)" }, { "Value", " (scalar)" },
    { "SurfaceValue", " (scalar)" }, { "MediumValue", " (scalar)" },
    { "GradientMagnitude", " (scalar/world)" }, { "Energy", " (J)" } };
  for (const auto& [name, unit] : units)
  {
    if (array == name)
    {
      return unit;
    }
  }
  return {};
}

bool WriteTable(vtkPolyData* trace, const std::string& file)
{
  struct Column
  {
    std::string Title;
    vtkDataArray* Array;
    int Component;
  };
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, vtkDataArray* array)
  {
    const int components = array->GetNumberOfComponents();
    for (int c = 0; c < components; ++c)
    {
      columns.push_back({ name + (components == 3 ? Axes[c] : "") + Unit(name), array, c });
    }
  };
  vtkPointData* const data = trace->GetPointData();
  add("Time", data->GetArray("Time"));
  add("Proxy", trace->GetPoints()->GetData());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const std::string name = data->GetArrayName(i);
    if (name != "Time")
    {
      add(name, data->GetArray(i));
    }
  }
  // Not vtkDelimitedTextWriter, which writes six digits: a trace has to come back to the bit.
  vtksys::ofstream stream(file.c_str());
  // An application's locale must not turn points into commas.
  stream.imbue(std::locale::classic());
  stream << std::setprecision(17);
  for (const Column& column : columns)
  {
    stream << (&column == columns.data() ? "" : ",") << column.Title;
  }
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    for (const Column& column : columns)
    {
      stream << (&column == columns.data() ? '\n' : ',')
             << column.Array->GetComponent(i, column.Component);
    }
  }
  stream << '\n';
  stream.close();
  return stream.good();
}

/** The field arrays, which a table has no place for: texts, and lists of tuples of numbers. */
bool WriteFields(vtkFieldData* fields, const std::string& file)
{
  Json::Value root(Json::objectValue);
  for (int a = 0; a < fields->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* const array = fields->GetAbstractArray(a);
    Json::Value& entry = root[array->GetName()];
    if (auto* text = vtkStringArray::SafeDownCast(array))
    {
      entry = text->GetNumberOfValues() > 0 ? text->GetValue(0) : std::string();
    }
    else if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      entry = Json::Value(Json::arrayValue);
      for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
      {
        Json::Value tuple(Json::arrayValue);
        for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
        {
          tuple.append(numbers->GetComponent(i, c));
        }
        entry.append(tuple);
      }
    }
  }
  vtksys::ofstream stream(file.c_str());
  stream << root;
  stream.close();
  return stream.good();
}

} // namespace

std::string GetTraceEnding(const std::string& file)
{
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
  return ending == ".vtp" || ending == ".csv" ? ending : std::string();
}

bool WriteTraceFile(vtkPolyData* trace, const std::string& file, std::string& error)
{
  const std::string ending = GetTraceEnding(file);
  bool written = false;
  if (ending == ".csv")
  {
    written = WriteTable(trace, file) && WriteFields(trace->GetFieldData(), file + ".json");
  }
  else if (ending == ".vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(trace);
    writer->SetDataModeToBinary(); // newer expats leave ParaView 5.11 unable to read data that are appended
    written = writer->Write() != 0;
  }
  if (!written)
  {
    error = "The recording " + file +
      (ending.empty() ? " has an unknown ending: name it .vtp or .csv."
                      : " can't be written: check that its folder exists, is yours, and has room.");
  }
  return written;
}

} // namespace VolumeHaptics
