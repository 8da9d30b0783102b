// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Report/TraceFiles.h"

#include "Applications/Explorer/Errors/InputError.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLPolyDataWriter.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <iomanip>
#include <map>
#include <vector>

namespace
{
void Check(bool written, const std::string& file)
{
  if (!written)
  {
    throw Explore::InputError(file, "cannot be written",
      "check that the disk is not full and the folder is yours; --pictures DIR names another one");
  }
}

/// The unit of an array of the trace, in brackets; empty for a pure number.
std::string Unit(const std::string& array)
{
  static const std::map<std::string, std::string> units = { { "Time", " (s)" },
    { "Tip", " (world)" }, { "Proxy", " (world)" }, { "Force", " (N)" }, { "NormalForce", " (N)" },
    { "FrictionForce", " (N)" }, { "DragForce", " (N)" }, { "Stiffness", " (N/m)" },
    { "Viscosity", " (N)" }, { "SurfaceStrength", " (N)" }, { "Value", " (scalar)" },
    { "SurfaceValue", " (scalar)" }, { "MediumValue", " (scalar)" },
    { "GradientMagnitude", " (scalar/world)" }, { "Energy", " (J)" } };
  const auto unit = units.find(array);
  return unit == units.end() ? std::string() : unit->second;
}

struct Column
{
  std::string Title;
  vtkDataArray* Values;
  int Component;
};

void AddColumns(std::vector<Column>& columns, const std::string& name, vtkDataArray* values)
{
  static const char* const axes[] = { " x", " y", " z" };
  const int components = values->GetNumberOfComponents();
  for (int c = 0; c < components; ++c)
  {
    columns.push_back({ name + (components == 3 ? axes[c] : "") + Unit(name), values, c });
  }
}
} // namespace

namespace Explore
{
void MakeFolder(const std::string& folder)
{
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    throw InputError(
      folder, "cannot be made a folder", "name one that you may write to with --pictures DIR");
  }
}

void WriteTrace(vtkPolyData* trace, const std::string& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(trace);
  writer->SetDataModeToBinary(); // for ParaView: see Data/generate.py
  Check(writer->Write() != 0, file);
}

void WriteTable(vtkPolyData* trace, const std::string& file)
{
  std::vector<Column> columns;
  vtkPointData* arrays = trace->GetPointData();
  AddColumns(columns, "Time", arrays->GetArray("Time"));
  AddColumns(columns, "Proxy", trace->GetPoints()->GetData());
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetName() && std::string(array->GetName()) != "Time")
    {
      AddColumns(columns, array->GetName(), array);
    }
  }
  // Not vtkDelimitedTextWriter: it writes six digits, and the contact state as a character.
  vtksys::ofstream stream(file.c_str());
  stream << std::setprecision(10);
  for (const Column& column : columns)
  {
    stream << (&column == columns.data() ? "" : ",") << column.Title;
  }
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    for (const Column& column : columns)
    {
      stream << (&column == columns.data() ? '\n' : ',')
             << column.Values->GetComponent(i, column.Component);
    }
  }
  stream << '\n';
  stream.close();
  Check(stream.good(), file);
}

void WritePicture(vtkRenderWindow* window, const std::string& file)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputConnection(grab->GetOutputPort());
  writer->Write();
  Check(writer->GetErrorCode() == 0, file);
}

void WriteText(const std::string& text, const std::string& file)
{
  vtksys::ofstream stream(file.c_str());
  stream << text;
  stream.close();
  Check(stream.good(), file);
}
} // namespace Explore
