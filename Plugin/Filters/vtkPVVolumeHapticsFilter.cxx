// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVVolumeHapticsFilter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVHapticLargeFile.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

vtkStandardNewMacro(vtkPVVolumeHapticsFilter);

//------------------------------------------------------------------------------
vtkPVVolumeHapticsFilter::vtkPVVolumeHapticsFilter()
{
  this->Stiffness.Scale = 1000.0;
  this->SurfaceStrength.Scale = 4.0;
}

//------------------------------------------------------------------------------
vtkPVVolumeHapticsFilter::~vtkPVVolumeHapticsFilter() = default;

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::Curve::CopyTo(vtkPiecewiseFunction* function) const
{
  // Copy the nodes one by one, because vtkPiecewiseFunction's DeepCopy() drops one of two nodes at
  // the same position.
  function->SetAllowDuplicateScalars(1);
  function->RemoveAllPoints();
  for (int i = 0; this->Shape && i < this->Shape->GetSize(); ++i)
  {
    double node[4]; // position, value, midpoint, sharpness
    this->Shape->GetNodeValue(i, node);
    function->AddPoint(node[0], this->Scale * node[1], node[2], node[3]);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void vtkPVVolumeHapticsFilter::Choose(T& setting, const T& value)
{
  if (!(setting == value))
  {
    setting = value;
    this->Chosen.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetPreset(const char* preset)
{
  this->Choose(this->Preset, std::string(preset && *preset ? preset : "Custom"));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetStiffnessFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Stiffness.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetFrictionFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Friction.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetViscosityFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Viscosity.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSurfaceStrengthFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->SurfaceStrength.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetDistinctnessFunction(vtkPiecewiseFunction* function)
{
  this->Choose(this->Distinctness.Shape, vtkSmartPointer<vtkPiecewiseFunction>(function));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetStiffnessScale(double scale)
{
  this->Choose(this->Stiffness.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetFrictionScale(double scale)
{
  this->Choose(this->Friction.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetViscosityScale(double scale)
{
  this->Choose(this->Viscosity.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSurfaceStrengthScale(double scale)
{
  this->Choose(this->SurfaceStrength.Scale, scale);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetDistinctnessFromNoise(bool fromNoise)
{
  this->Choose(this->DistinctnessFromNoise, fromNoise);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetDistinctnessPerMillimeter(bool perMillimeter)
{
  this->Choose(this->DistinctnessPerMillimeter, perMillimeter);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetScalarsAreLabels(bool areLabels)
{
  this->Choose(this->ScalarsAreLabels, areLabels);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSolidFromImage(bool fromImage)
{
  this->Choose(this->SolidFromImage, fromImage);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetShiftFromImage(bool fromImage)
{
  this->Choose(this->ShiftFromImage, fromImage);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetSurfaceSide(int side)
{
  this->Choose(this->SurfaceSide, side);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetComponent(int component)
{
  this->GetProperty()->SetComponent(component);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetScalarShift(double shift)
{
  this->GetProperty()->SetScalarShift(shift);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetScalarScale(double scale)
{
  this->GetProperty()->SetScalarScale(scale);
}

//------------------------------------------------------------------------------
double* vtkPVVolumeHapticsFilter::GetNoiseRamp()
{
  return this->GetProperty()->GetNoiseRamp();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetInputConnection(int port, vtkAlgorithmOutput* input)
{
  vtkPVHapticLargeFile* const file = port == 0 ? vtkPVHapticLargeFile::Find(input) : nullptr;
  this->Superclass::SetInputConnection(port, file ? file->GetRegions()->GetOutputPort() : input);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetInputArrayToProcess(
  int index, int port, int connection, int association, const char* name)
{
  if (name && *name)
  {
    this->Superclass::SetInputArrayToProcess(index, port, connection, association, name);
    return;
  }
  this->SetInputArrayToProcess(index, port, connection, vtkDataObject::FIELD_ASSOCIATION_POINTS,
    vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVVolumeHapticsFilter::GetMaterialTime() const
{
  vtkMTimeType time = this->Chosen;
  for (const Curve* curve : { &this->Stiffness, &this->Friction, &this->Viscosity,
         &this->SurfaceStrength, &this->Distinctness })
  {
    time = std::max(time, curve->Shape ? curve->Shape->GetMTime() : 0);
  }
  return time;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkPVVolumeHapticsFilter::FindGreyLevels()
{
  vtkImageData* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (this->Preset != "MRI" || !image)
  {
    return nullptr;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const scalars = this->GetInputArrayToProcess(0, image, association);
  if (!scalars || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return nullptr;
  }
  auto levels = vtkSmartPointer<vtkImageData>::New();
  levels->ShallowCopy(image);
  levels->GetPointData()->SetScalars(scalars);
  return levels;
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::FillProperty(vtkImageData* levels)
{
  vtkHapticProperty* const property = this->GetProperty();
  if (this->Preset != "Custom")
  {
    const char* const preset = this->Preset.c_str();
    this->IsPresetKnown =
      levels ? property->ApplyPreset(preset, levels) : property->ApplyPreset(preset);
    return;
  }
  this->IsPresetKnown = true;
  this->Stiffness.CopyTo(property->GetStiffness());
  this->Friction.CopyTo(property->GetFriction());
  this->Viscosity.CopyTo(property->GetViscosity());
  this->SurfaceStrength.CopyTo(property->GetSurfaceStrength());
  this->Distinctness.CopyTo(property->GetDistinctness());
  if (this->DistinctnessFromNoise)
  {
    property->GetDistinctness()->RemoveAllPoints();
  }
  property->SetDistinctnessFromNoise(this->DistinctnessFromNoise);
  property->SetDistinctnessPerMillimeter(this->DistinctnessPerMillimeter);
  property->SetScalarsAreLabels(this->ScalarsAreLabels);
  property->SetSolidFromImage(this->SolidFromImage);
  property->SetShiftFromImage(this->ShiftFromImage);
  property->SetSurfaceSide(this->SurfaceSide);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::UpdateProperty()
{
  const vtkSmartPointer<vtkImageData> levels = this->FindGreyLevels();
  GreyLevels felt{};
  if (levels)
  {
    vtkDataArray* const scalars = levels->GetPointData()->GetScalars();
    vtkHapticProperty* const property = this->GetProperty();
    felt = { this->GetInputDataObject(0, 0)->GetMTime(), scalars, scalars->GetMTime(),
      property->GetComponent(), property->GetScalarShift(), property->GetScalarScale() };
  }
  if (felt != this->Fitted || this->GetMaterialTime() > this->Filled)
  {
    this->Fitted = felt;
    this->FillProperty(levels);
    this->Filled.Modified();
  }
}

//------------------------------------------------------------------------------
double* vtkPVVolumeHapticsFilter::GetPresetScale()
{
  const auto last = [](vtkPiecewiseFunction* function)
  {
    double node[4] = { 0.0 };
    if (function->GetSize() > 0)
    {
      function->GetNodeValue(function->GetSize() - 1, node);
    }
    return node[0];
  };
  this->UpdateProperty();
  this->PresetScale = { 1.0, 0.0 };
  vtkHapticProperty* const property = this->GetProperty();
  vtkNew<vtkHapticProperty> table;
  if (this->Preset == "MRI" && table->ApplyPreset(this->Preset.c_str()) &&
    !property->GetDistinctnessPerMillimeter())
  {
    this->PresetScale = { last(property->GetStiffness()) / last(table->GetStiffness()),
      last(property->GetDistinctness()) / last(table->GetDistinctness()) };
  }
  return this->PresetScale.data();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::AddLabelFile(const char* file)
{
  if (file && *file)
  {
    this->LabelFiles.emplace_back(file);
    this->IsTableDirty = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::RemoveAllLabelFiles()
{
  if (!this->LabelFiles.empty())
  {
    this->LabelFiles.clear();
    this->IsTableDirty = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::AddLabelMaterial(
  double label, double stiffness, double friction, double viscosity, double surfaceStrength)
{
  this->LabelMaterials.push_back({ label, stiffness, friction, viscosity, surfaceStrength });
  this->IsTableDirty = true;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::RemoveAllLabelMaterials()
{
  if (!this->LabelMaterials.empty())
  {
    this->LabelMaterials.clear();
    this->IsTableDirty = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetStandOff(double distance)
{
  if (this->StandOff != distance)
  {
    this->StandOff = distance;
    this->IsTableDirty = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::FillTable()
{
  using Table = vtkHapticLabelTable;
  vtkNew<Table> table;
  this->IsTableGood = true;
  for (const std::string& file : this->LabelFiles)
  {
    this->IsTableGood = table->ReadFile(file.c_str()) && this->IsTableGood;
  }
  constexpr void (Table::*setters[])(int, double) = { &Table::SetStiffness, &Table::SetFriction,
    &Table::SetViscosity, &Table::SetSurfaceStrength };
  for (const std::array<double, 5>& row : this->LabelMaterials)
  {
    const bool isLabel =
      row[0] == std::floor(row[0]) && row[0] >= VTK_INT_MIN && row[0] <= VTK_INT_MAX;
    const bool isMaterial = std::all_of(row.begin() + 1, row.end(),
      [](double value) { return (value >= 0.0 && std::isfinite(value)) || value == -1.0; });
    if (!isLabel || !isMaterial)
    {
      vtkErrorMacro(<< "Label Materials has the row " << row[0] << ", " << row[1] << ", " << row[2]
                    << ", " << row[3] << ", " << row[4]
                    << ". Give a whole number, and four numbers, 0 or more, or -1 to use "
                       "the functions.");
      this->IsTableGood = false;
      continue;
    }
    for (std::size_t i = 0; i < std::size(setters); ++i)
    {
      if (row[i + 1] >= 0.0)
      {
        (table->*setters[i])(static_cast<int>(row[0]), row[i + 1]);
      }
    }
  }
  table->SetStandOff(this->StandOff);
  this->SetLabelTable(table->GetNumberOfLabels() > 0 ? table.Get() : nullptr);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::AddModeRow(
  const char* kind, const char* array, const char* strength, const char* secondStrength)
{
  const auto text = [](const char* given) { return std::string(given ? given : ""); };
  this->Modes.Add({ text(kind), text(array), text(strength), text(secondStrength) });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::RemoveAllModeRows()
{
  if (this->Modes.Clear())
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetModePreset(const char* preset)
{
  if (this->Modes.SetPreset(preset && *preset ? preset : "None"))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::FillModes()
{
  const std::string error = this->Modes.Fill(this);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
}

//------------------------------------------------------------------------------
template <typename T>
void vtkPVVolumeHapticsFilter::ChooseTool(T& setting, const T& value)
{
  if (!(setting == value))
  {
    setting = value;
    this->Tools.Record();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetToolKind(const char* kind)
{
  this->ChooseTool(this->Tools.Kind, std::string(kind && *kind ? kind : "None"));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetToolNumber(const char* setting, double value)
{
  this->ChooseTool(this->Tools.Numbers[setting], value);
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::SetToolFunction(const char* setting, const char* text)
{
  this->ChooseTool(this->Tools.Functions[setting], std::string(text ? text : ""));
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::UndoRemoval()
{
  this->GetRemoval()->Undo();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::RedoRemoval()
{
  this->GetRemoval()->Redo();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::RestoreTissue()
{
  this->GetRemoval()->Reset();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::FillTool()
{
  const std::string error = this->Tools.Fill(this);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPVVolumeHapticsFilter::GetMTime()
{
  this->FillModes();
  this->FillTool();
  if (this->IsTableDirty)
  {
    // reset this first, because the calls below re-enter this function
    this->IsTableDirty = false;
    this->FillTable();
  }
  this->UpdateProperty();
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
int vtkPVVolumeHapticsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  const int isKnown = this->Superclass::FillInputPortInformation(port, info);
  if (port == 2)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  }
  return isKnown;
}

//------------------------------------------------------------------------------
int vtkPVVolumeHapticsFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->FillModes(); // after the input has arrived, because the guides may be polygons or lines
  this->FillTool();
  // after the input has arrived, because a preset may be fitted to the image
  this->UpdateProperty();
  // Fail silently, because the errors were already reported: an unknown preset by FillProperty(),
  // and unreadable texts by the label table, the modes and the tool.
  return this->IsPresetKnown && this->IsTableGood && this->Modes.IsGood() && this->Tools.IsGood()
    ? this->Superclass::RequestData(request, inputs, outputs)
    : 0;
}

//------------------------------------------------------------------------------
void vtkPVVolumeHapticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  os << indent << "StiffnessScale: " << this->Stiffness.Scale << " N/m\n";
  os << indent << "FrictionScale: " << this->Friction.Scale << "\n";
  os << indent << "ViscosityScale: " << this->Viscosity.Scale << " N\n";
  os << indent << "SurfaceStrengthScale: " << this->SurfaceStrength.Scale << " N\n";
  os << indent << "DistinctnessFromNoise: " << (this->DistinctnessFromNoise ? "On" : "Off") << "\n";
  os << indent << "DistinctnessPerMillimeter: " << (this->DistinctnessPerMillimeter ? "On" : "Off")
     << "\n";
  os << indent << "ScalarsAreLabels: " << (this->ScalarsAreLabels ? "On" : "Off") << "\n";
  os << indent << "SolidFromImage: " << (this->SolidFromImage ? "On" : "Off") << "\n";
  os << indent << "ShiftFromImage: " << (this->ShiftFromImage ? "On" : "Off") << "\n";
  os << indent << "SurfaceSide: " << this->SurfaceSide << "\n";
  for (const std::string& file : this->LabelFiles)
  {
    os << indent << "LabelFile: " << file << "\n";
  }
  os << indent << "LabelMaterials: " << this->LabelMaterials.size() << "\n";
  os << indent << "StandOff: " << this->StandOff << "\n";
  os << indent << "ModePreset: " << this->Modes.GetPreset() << "\n";
  os << indent << "ModeRows: " << this->Modes.GetNumberOfRows() << "\n";
  this->Tools.Print(os, indent);
}
