// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsAlgorithm.h"

#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Filter/HapticMethods.h"
#include "VTK/Modes/ModePresets.h"
#include "VTK/Tools/ToolKind.h"
#include "VTK/Trace/TraceArrayChoice.h"

#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkVolumeHapticsAlgorithm::vtkVolumeHapticsAlgorithm()
  : TraceArrays(VolumeHaptics::AllTraceArrays)
{
}

//------------------------------------------------------------------------------
vtkVolumeHapticsAlgorithm::~vtkVolumeHapticsAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::SetProperty(vtkHapticProperty* property)
{
  if (this->Property != property)
  {
    this->Property = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticProperty* vtkVolumeHapticsAlgorithm::GetProperty()
{
  if (!this->Property)
  {
    this->Property = vtkSmartPointer<vtkHapticProperty>::New();
  }
  return this->Property;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeHapticsAlgorithm::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkHapticMode* const mode : this->Modes)
  {
    time = std::max(time, mode->GetMTime());
  }
  time = this->Tool ? std::max(time, this->Tool->GetMTime()) : time;
  return this->Property ? std::max(time, this->Property->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::AddMode(vtkHapticMode* mode)
{
  if (mode && std::find(this->Modes.begin(), this->Modes.end(), mode) == this->Modes.end())
  {
    this->Modes.emplace_back(mode);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::RemoveMode(vtkHapticMode* mode)
{
  const auto found = std::find(this->Modes.begin(), this->Modes.end(), mode);
  if (found != this->Modes.end())
  {
    this->Modes.erase(found);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::RemoveAllModes()
{
  if (!this->Modes.empty())
  {
    this->Modes.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsAlgorithm::GetNumberOfModes()
{
  return static_cast<int>(this->Modes.size());
}

//------------------------------------------------------------------------------
vtkHapticMode* vtkVolumeHapticsAlgorithm::GetMode(int mode)
{
  return mode >= 0 && mode < this->GetNumberOfModes()
    ? this->Modes[static_cast<std::size_t>(mode)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::SetTool(vtkHapticTool* tool)
{
  if (tool && !VolumeHaptics::FindToolKind(tool))
  {
    vtkErrorMacro("A " << tool->GetClassName()
                       << " can't be felt and is not set: derive it from one of the module's "
                          "tools, such as vtkHapticNeedle.");
    return;
  }
  if (this->Tool != tool)
  {
    this->Tool = tool;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticTool* vtkVolumeHapticsAlgorithm::GetTool()
{
  return this->Tool;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsAlgorithm::ApplyModePreset(const char* name, vtkImageData* image)
{
  std::string error;
  const VolumeHaptics::HapticModes modes = VolumeHaptics::MakeModePreset(name, image, error);
  if (modes.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  this->RemoveAllModes();
  for (vtkHapticMode* const mode : modes)
  {
    this->AddMode(mode);
  }
  this->SetMethodToPrimitives();
  return true;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVolumeHapticsAlgorithm::GetModePresetNames()
{
  static const vtkSmartPointer<vtkStringArray> names = VolumeHaptics::MakeModePresetNames();
  return names;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::SetDisplacementArrayName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (this->DisplacementArrayName != wanted)
  {
    this->DisplacementArrayName = wanted;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::GetDisplacementArrayName()
{
  return this->DisplacementArrayName;
}

//------------------------------------------------------------------------------
vtkStringArray* vtkVolumeHapticsAlgorithm::GetMethodNames()
{
  static const vtkSmartPointer<vtkStringArray> names = []
  {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    for (const VolumeHaptics::MethodChoice& choice : VolumeHaptics::MethodChoices())
    {
      array->InsertNextValue(choice.Name);
    }
    return array;
  }();
  return names;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::Choose(std::size_t choice)
{
  const VolumeHaptics::MethodChoice& chosen = VolumeHaptics::MethodChoices()[choice];
  this->SetMethod(chosen.Method);
  if (chosen.Solver != VolumeHaptics::MethodChoice::AnySolver)
  {
    this->SetSolver(chosen.Solver);
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsAlgorithm::SetMethodByName(const char* name)
{
  const auto& all = VolumeHaptics::MethodChoices();
  const std::string wanted = name ? name : "";
  std::string known;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (wanted == all[i].Name)
    {
      this->Choose(i);
      return true;
    }
    known += (i > 0 ? ", \"" : "\"") + std::string(all[i].Name) + "\"";
  }
  vtkErrorMacro("There is no method \"" << wanted << "\". Take one of " << known << ".");
  return false;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::GetMethodName()
{
  return VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Name;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::GetMethodText()
{
  return VolumeHaptics::GetMethodChoice(this->Method, this->Solver).Text;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::NextMethod()
{
  const auto& all = VolumeHaptics::MethodChoices();
  std::size_t next = VolumeHaptics::FindMethodChoice(this->Method, this->Solver) + 1;
  if (next < all.size() && all[next].Method == PRIMITIVES && this->Modes.empty())
  {
    ++next;
  }
  this->Choose(next % all.size());
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsAlgorithm::ChooseTraceArrays(const std::vector<std::string>& names)
{
  VolumeHaptics::TraceArrayChoice choice = 0;
  const std::string error = VolumeHaptics::ReadTraceArrays(names, choice);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return false;
  }
  if (this->TraceArrays != choice)
  {
    this->TraceArrays = choice;
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsAlgorithm::SetTraceArrays(const char* names)
{
  return this->ChooseTraceArrays(VolumeHaptics::SplitTraceArrays(names ? names : "all"));
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsAlgorithm::SetTraceArrays(vtkStringArray* names)
{
  std::vector<std::string> words;
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
  {
    words.push_back(names->GetValue(i));
  }
  return this->ChooseTraceArrays(names ? words : std::vector<std::string>{ "all" });
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::GetTraceArrays()
{
  return VolumeHaptics::DescribeTraceArrays(this->TraceArrays);
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::CheckTraceArrays(const std::string& names)
{
  VolumeHaptics::TraceArrayChoice choice = 0;
  return VolumeHaptics::ReadTraceArrays(VolumeHaptics::SplitTraceArrays(names), choice);
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsAlgorithm::GetNumberOfTraceArrays()
{
  return static_cast<int>(VolumeHaptics::GetNumberOfTraceArrays());
}

//------------------------------------------------------------------------------
const char* vtkVolumeHapticsAlgorithm::GetTraceArrayName(int array)
{
  return array >= 0 && array < this->GetNumberOfTraceArrays()
    ? VolumeHaptics::GetTraceArrayName(static_cast<std::size_t>(array))
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsAlgorithm::GetTraceArrayStatus(const char* name)
{
  const std::size_t array = VolumeHaptics::FindTraceArray(name ? name : "");
  return array < VolumeHaptics::GetNumberOfTraceArrays() &&
    VolumeHaptics::IsChosen(this->TraceArrays, array);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::SetTraceArrayStatus(const char* name, int status)
{
  const std::string changed = name ? name : "";
  const std::size_t count = VolumeHaptics::GetNumberOfTraceArrays();
  const bool isKnown = VolumeHaptics::FindTraceArray(changed) < count;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string other = VolumeHaptics::GetTraceArrayName(i);
    if (other != changed && VolumeHaptics::IsChosen(this->TraceArrays, i))
    {
      names.push_back(other);
    }
  }
  if (status != 0 || !isKnown) // for an unknown name, ChooseTraceArrays reports the error
  {
    names.push_back(changed);
  }
  this->ChooseTraceArrays(names);
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsAlgorithm::CheckSettings(double rate)
{
  for (const VolumeHaptics::FilterSetting& setting : VolumeHaptics::FilterSettings)
  {
    // The servo's rate replaces the filter's.
    const bool isRate = std::string("ServoRate") == setting.Name;
    if (!std::isfinite(isRate ? rate : setting.Get(this)))
    {
      return std::string("The setting ") + setting.Name +
        " of vtkVolumeHapticsFilter is not a finite number. Set" + setting.Name + "() to one.";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::PrintSettings(ostream& os, vtkIndent indent)
{
  os << indent << "Property: ";
  if (this->Property)
  {
    os << "\n";
    this->Property->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::FilterSettings);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::FilterTexts);
  for (vtkHapticMode* const mode : this->Modes)
  {
    os << indent << "Mode: " << mode->GetClassName() << "\n";
    mode->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "Tool: " << (this->Tool ? this->Tool->GetClassName() : "(none)") << "\n";
  if (this->Tool)
  {
    this->Tool->PrintSelf(os, indent.GetNextIndent());
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->PrintSettings(os, indent);
}
