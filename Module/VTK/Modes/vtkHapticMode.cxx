// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticMode.h"

#include "VTK/Material/HapticFunctions.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/HapticModeSettings.h"
#include "VTK/Modes/ModePresets.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cctype>
#include <iterator>

vtkStandardNewMacro(vtkHapticMode);

//------------------------------------------------------------------------------
vtkHapticMode::vtkHapticMode() = default;
vtkHapticMode::~vtkHapticMode() = default;

//------------------------------------------------------------------------------
void vtkHapticMode::SetKind(int kind)
{
  const auto kinds = std::size(VolumeHaptics::ModeSettingRows::KindNames);
  const int wanted = std::clamp(kind, 0, static_cast<int>(kinds) - 1);
  if (this->Kind != GUIDE && wanted == GUIDE)
  {
    vtkErrorMacro("A vtkHapticMode has no shape to guide along, and keeps its kind. Make a "
                  "vtkHapticGuideMode instead.");
  }
  else if (this->Kind == GUIDE && wanted != GUIDE)
  {
    vtkErrorMacro("A vtkHapticGuideMode is a guide, and stays one. Make a vtkHapticMode for "
                  "another kind.");
  }
  else if (this->Kind != wanted)
  {
    this->Kind = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkStringArray* vtkHapticMode::GetKindNames()
{
  static const auto names = []
  {
    auto made = vtkSmartPointer<vtkStringArray>::New();
    for (const VolumeHaptics::SettingChoice& kind : VolumeHaptics::ModeSettingRows::KindNames)
    {
      made->InsertNextValue(kind.Name);
    }
    return made;
  }();
  return names;
}

//------------------------------------------------------------------------------
void vtkHapticMode::SetArrayName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->ArrayName != wanted)
  {
    this->ArrayName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkHapticMode::GetArrayName()
{
  return this->ArrayName;
}

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkHapticMode, Strength, vtkPiecewiseFunction);

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticMode::GetStrength()
{
  return VolumeHaptics::ProvideFunction(this->Strength);
}

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkHapticMode, SecondStrength, vtkPiecewiseFunction);

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticMode::GetSecondStrength()
{
  return VolumeHaptics::ProvideFunction(this->SecondStrength);
}

//------------------------------------------------------------------------------
bool vtkHapticMode::ProposeFromImage(vtkImageData* image)
{
  std::string error;
  if (!image)
  {
    vtkErrorMacro("ProposeFromImage() needs an image, but got a null pointer.");
    return false;
  }
  if (!VolumeHaptics::ProposeStrength(this, image, error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticMode::HasSecondStrength()
{
  return VolumeHaptics::GetModeKind(this).Functions[1] != nullptr;
}

//------------------------------------------------------------------------------
std::string vtkHapticMode::GetText()
{
  std::string text = VolumeHaptics::ModeSettingRows::KindNames[this->Kind].Text;
  text[0] = static_cast<char>(std::tolower(text[0]));
  return text + (this->GetArrayText().empty() || this->ArrayName.empty() ? "" : ", ") +
    (this->GetArrayText().empty() ? "" : this->ArrayName);
}

//------------------------------------------------------------------------------
std::string vtkHapticMode::GetArrayText()
{
  switch (VolumeHaptics::GetInput(this))
  {
    case VolumeHaptics::ModeInput::Vectors:
      return "vectors (a point array of 3 components)";
    case VolumeHaptics::ModeInput::Tensors:
      return "tensors (a point array of 6 or 9 components)";
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
std::string vtkHapticMode::FindArrayName(vtkDataSet* data)
{
  vtkPointData* const points = data ? data->GetPointData() : nullptr;
  for (int i = 0; points && i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = points->GetArray(i);
    if (array && array->GetName() &&
      VolumeHaptics::HasComponents(VolumeHaptics::GetInput(this), array->GetNumberOfComponents()))
    {
      return array->GetName();
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHapticMode::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkPiecewiseFunction* const function : { this->Strength.Get(), this->SecondStrength.Get() })
  {
    time = function ? std::max(time, function->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkHapticMode::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::ModeTexts);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::ModeSettings);
  for (const VolumeHaptics::ModeFunction& function : VolumeHaptics::GetModeFunctions(this))
  {
    os << indent << function.Name << ":\n";
    function.Function->PrintSelf(os, indent.GetNextIndent());
  }
}
