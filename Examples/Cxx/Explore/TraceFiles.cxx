// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TraceFiles.h"

#include "InputError.h"

#include "vtkDelimitedTextWriter.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkTable.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLPolyDataWriter.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <map>

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

/// The unit of an array of the trace, in brackets, or nothing for a pure number.
std::string Unit(const std::string& array)
{
  static const std::map<std::string, std::string> units = { { "Time", " (s)" },
    { "Tip", " (world)" }, { "Proxy", " (world)" }, { "Force", " (N)" }, { "NormalForce", " (N)" },
    { "FrictionForce", " (N)" }, { "DragForce", " (N)" }, { "Stiffness", " (N/m)" },
    { "Viscosity", " (N)" }, { "SurfaceStrength", " (N)" }, { "Value", " (scalar)" },
    { "SurfaceValue", " (scalar)" }, { "MediumValue", " (scalar)" },
    { "GradientMagnitude", " (scalar/world)" } };
  const auto unit = units.find(array);
  return unit == units.end() ? std::string() : unit->second;
}

void AddColumns(vtkTable* table, const std::string& name, vtkDataArray* values)
{
  static const char* const axes[] = { " x", " y", " z" };
  const int components = values->GetNumberOfComponents();
  for (int c = 0; c < components; ++c)
  {
    const std::string part = components == 3 ? axes[c]
      : components > 1                       ? " " + std::to_string(c)
                                             : std::string();
    // A copy of the array's own type: the contact state stays a whole number.
    auto column = vtk::TakeSmartPointer(values->NewInstance());
    column->SetName((name + part + Unit(name)).c_str());
    column->SetNumberOfTuples(values->GetNumberOfTuples());
    column->CopyComponent(0, values, c);
    table->AddColumn(column);
  }
}
}

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
  Check(writer->Write() != 0, file);
}

void WriteTable(vtkPolyData* trace, const std::string& file)
{
  vtkNew<vtkTable> table;
  vtkPointData* arrays = trace->GetPointData();
  AddColumns(table, "Time", arrays->GetArray("Time"));
  AddColumns(table, "Proxy", trace->GetPoints()->GetData());
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetName() && std::string(array->GetName()) != "Time")
    {
      AddColumns(table, array->GetName(), array);
    }
  }
  vtkNew<vtkDelimitedTextWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(table);
  Check(writer->Write() != 0 && vtksys::SystemTools::FileLength(file) > 0, file);
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
}
