// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticToolChoice.h"

#include "HapticFunctionText.h"

#include "vtkDataObject.h"
#include "vtkHapticPointShell.h"
#include "vtkHapticTool.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cctype>
#include <ostream>

namespace
{

constexpr const char* ShellKind = "Point shell";
constexpr const char* BurrKind = "Burr";
constexpr const char* NoKind = "None";
constexpr double RadiusInVoxels = 3.0; // default radius of a burr's head

/** Returns the name of a kind's class, such as "PointShell" for "Point shell". */
std::string ClassOf(const std::string& kind)
{
  std::string name;
  for (std::size_t i = 0; i < kind.size(); ++i)
  {
    const bool begins = i == 0 || kind[i - 1] == ' ';
    if (kind[i] != ' ')
    {
      const auto letter = static_cast<unsigned char>(kind[i]);
      name += begins ? static_cast<char>(std::toupper(letter)) : kind[i];
    }
  }
  return name;
}

/**
 * Returns a setting's label in ParaView, such as "Burr Specific Energy" for "Burr.SpecificEnergy".
 */
std::string LabelOf(const std::string& setting)
{
  std::string label;
  for (const char c : setting)
  {
    if (c == '.')
    {
      continue;
    }
    label += !label.empty() && std::isupper(static_cast<unsigned char>(c)) ? " " : "";
    label += c;
  }
  return label;
}

/** Returns a setting's name without the prefix of its kind; empty for a setting of another kind. */
std::string NameIn(const std::string& setting, const std::string& kind)
{
  const bool isOfKind = setting.compare(0, kind.size() + 1, kind + ".") == 0;
  return isOfKind ? setting.substr(kind.size() + 1) : std::string();
}

} // namespace

//------------------------------------------------------------------------------
std::string HapticToolChoice::Fill(vtkVolumeHapticsFilter* filter)
{
  vtkDataObject* const shape = this->Kind == ShellKind && filter->GetNumberOfInputConnections(2) > 0
    ? filter->GetInputDataObject(2, 0)
    : nullptr;
  auto* const image = filter->GetNumberOfInputConnections(0) > 0
    ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0))
    : nullptr;
  const double* const spacing = this->Kind == BurrKind && image ? image->GetSpacing() : nullptr;
  const double voxel = spacing ? *std::max_element(spacing, spacing + 3) : 0.0;
  if (!this->IsDirty && shape == this->Shape && voxel == this->Voxel)
  {
    return {};
  }
  this->Voxel = voxel;
  this->IsDirty = false; // reset this first, because the calls below re-enter this function
  this->Shape = shape;
  const std::string error = this->Make(filter);
  this->IsMade = error.empty();
  return error;
}

//------------------------------------------------------------------------------
std::string HapticToolChoice::Make(vtkVolumeHapticsFilter* filter) const
{
  const std::string kind = ClassOf(this->Kind);
  const auto tool = vtkSmartPointer<vtkHapticTool>::Take(vtkHapticTool::Make(kind.c_str()));
  if (!tool)
  {
    filter->SetTool(nullptr);
    return this->Kind == NoKind ? std::string()
                                : "There is no tool \"" + this->Kind +
        "\". Choose one of the list Tool, such as \"Needle\", \"Point shell\" or \"Burr\", or \"" +
        NoKind + "\".";
  }
  std::string error;
  if (auto* const shell = vtkHapticPointShell::SafeDownCast(tool))
  {
    auto* const mesh = vtkPolyData::SafeDownCast(this->Shape);
    if (!mesh)
    {
      error = "The tool Point shell has no shape. Choose closed polygons as Surface, such as those "
              "of an STL file.";
    }
    shell->SetMesh(mesh);
  }
  for (const auto& [setting, value] : this->Numbers)
  {
    const std::string name = NameIn(setting, kind);
    const bool isByVoxel = name == "Radius" && value == 0.0;
    if (isByVoxel && this->Voxel > 0.0)
    {
      tool->SetNumber("Radius", RadiusInVoxels * this->Voxel);
    }
    else if (!isByVoxel && !name.empty() && !tool->SetNumber(name.c_str(), value))
    {
      error += setting + " is not a number of a tool. ";
    }
  }
  for (const auto& [setting, text] : this->Functions)
  {
    const std::string name = NameIn(setting, kind);
    vtkPiecewiseFunction* const function = name.empty() ? nullptr : tool->GetFunction(name.c_str());
    if (!name.empty() && !function)
    {
      error += setting + " is not a function of a tool. ";
    }
    else if (function && !ReadFunctionText(text, function))
    {
      error += LabelOf(setting) + " is \"" + text +
        "\". Give a number, or pairs of a scalar and a number, such as \"-100 0, 300 50\". ";
    }
  }
  filter->SetTool(tool);
  return error;
}

//------------------------------------------------------------------------------
void HapticToolChoice::Print(std::ostream& os, vtkIndent indent) const
{
  os << indent << "ToolKind: " << this->Kind << "\n";
  for (const auto& [setting, value] : this->Numbers)
  {
    os << indent << setting << ": " << value << "\n";
  }
  for (const auto& [setting, text] : this->Functions)
  {
    os << indent << setting << ": " << text << "\n";
  }
}
