// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/ModeChoice.h"

#include "Applications/Explorer/Exploration/GuideFile.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"

#include "vtkDataArray.h"
#include "vtkHapticGuideMode.h"
#include "vtkHapticMode.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cctype>

namespace
{
using Explore::InputError;
using ModePointer = vtkSmartPointer<vtkHapticMode>;

/// Returns the names of the kinds in the order of their numbers, such as "vector-follow". The name
/// of a guide is empty.
std::vector<std::string> NameKinds()
{
  std::vector<std::string> names;
  vtkStringArray* const kinds = vtkHapticMode::GetKindNames();
  for (vtkIdType kind = 0; kind < kinds->GetNumberOfValues(); ++kind)
  {
    const std::string capitals = kinds->GetValue(kind);
    std::string name;
    for (const char c : kind == vtkHapticMode::GUIDE ? std::string() : capitals)
    {
      const bool isCapital = std::isupper(static_cast<unsigned char>(c));
      name += isCapital && !name.empty() ? "-" : "";
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    names.push_back(name);
  }
  return names;
}

/// Makes a mode by its name, such as "vector-follow". Returns null for an unknown name, and for a
/// guide, which has its own option.
ModePointer MakeMode(const std::string& name)
{
  auto mode = ModePointer::New();
  if (name == "two-sided-front")
  {
    mode->SetKindToVectorFront();
    mode->TwoSidedOn();
    return mode;
  }
  if (name == "dark-ridge")
  {
    mode->SetKindToRidge();
    mode->SetPolarityToDark();
    return mode;
  }
  const std::vector<std::string> names = NameKinds();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end() || name.empty())
  {
    return nullptr;
  }
  mode->SetKind(static_cast<int>(found - names.begin()));
  return mode;
}

/// Return the name of the first array with vectors, or with tensors; empty if there is none.
std::string FindVectors(vtkImageData* image)
{
  return ModePointer::New()->FindArrayName(image);
}

std::string FindTensors(vtkImageData* image)
{
  return MakeMode("tensor-follow")->FindArrayName(image);
}

bool IsPreset(const std::string& name)
{
  return vtkVolumeHapticsFilter::GetModePresetNames()->LookupValue(name) >= 0;
}

void AddPreset(const std::string& name, vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  const auto preset = vtkSmartPointer<vtkVolumeHapticsFilter>::New();
  const Explore::MessageCapture capture;
  if (!preset->ApplyModePreset(name.c_str(), image))
  {
    throw InputError("--mode '" + name + "'", capture.FirstError(), "use another mode");
  }
  for (int i = 0; i < preset->GetNumberOfModes(); ++i)
  {
    filter->AddMode(preset->GetMode(i));
  }
}

void AddMode(const std::string& name, vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  if (IsPreset(name))
  {
    AddPreset(name, image, filter);
    return;
  }
  const std::size_t colon = name.find(':');
  const ModePointer mode = MakeMode(name.substr(0, colon));
  const std::string wanted = colon == std::string::npos ? "" : name.substr(colon + 1);
  if (!mode->GetArrayText().empty())
  {
    const std::string array = wanted.empty() ? mode->FindArrayName(image) : wanted;
    if (array.empty())
    {
      throw InputError("--mode " + name, "the volume has no " + mode->GetArrayText(),
        "give a .vti file that has them, or use another mode");
    }
    mode->SetArrayName(array.c_str());
  }
  const Explore::MessageCapture capture;
  if (!mode->ProposeFromImage(image))
  {
    throw InputError("--mode " + name, capture.FirstError(), "use another mode or array");
  }
  filter->AddMode(mode);
}

/// Adds the modes that an image's fields permit and that the filter does not have yet. They stay
/// inactive until the user turns them on in the window. Modes of vectors use the array of the last
/// mode, if that mode uses vectors.
void OfferModes(vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  const std::string known = filter->GetMode(filter->GetNumberOfModes() - 1)->GetArrayName();
  vtkDataArray* const array = image->GetPointData()->GetArray(known.c_str());
  const bool isOfVectors = array && array->GetNumberOfComponents() == 3;
  const std::string vectors = isOfVectors ? known : FindVectors(image);
  const auto isThere = [filter](const ModePointer& mode)
  {
    bool found = false;
    for (int i = 0; i < filter->GetNumberOfModes(); ++i)
    {
      found = found || filter->GetMode(i)->GetKind() == mode->GetKind();
    }
    return found;
  };
  for (const char* const name :
    { "vector-follow", "two-sided-front", "vortex", "shear", "tensor-follow" })
  {
    const ModePointer mode = MakeMode(name);
    const bool isFlow = mode->GetKind() != vtkHapticMode::TENSOR_FOLLOW;
    const std::string field = isFlow ? vectors : mode->FindArrayName(image);
    mode->SetArrayName(field.c_str());
    // Don't offer a mode without effect, such as one for vortices in a flow without rotation.
    const Explore::MessageCapture capture;
    if (!field.empty() && !isThere(mode) && mode->ProposeFromImage(image))
    {
      mode->ActiveOff();
      filter->AddMode(mode);
    }
  }
}
} // namespace

namespace Explore
{
std::string ListModes()
{
  std::string list = "two-sided-front, dark-ridge";
  for (const std::string& name : NameKinds())
  {
    list += (name.empty() ? "" : ", ") + name;
  }
  return list;
}

std::string ListModePresets()
{
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetModePresetNames();
  std::string list;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    list += (i == 0 ? "\"" : ", \"") + std::string(names->GetValue(i)) + "\"";
  }
  return list;
}

void CheckMode(const std::string& mode)
{
  if (IsPreset(mode))
  {
    return;
  }
  const std::size_t colon = mode.find(':');
  const ModePointer known = MakeMode(mode.substr(0, colon));
  if (!known || (colon != std::string::npos && colon + 1 == mode.size()))
  {
    throw InputError("--mode '" + mode + "'", "is not known",
      "use one of: " + ListModes() +
        "; the name of an array may follow after a colon. Or one of: " + ListModePresets());
  }
  if (colon != std::string::npos && known->GetArrayText().empty())
  {
    throw InputError(
      "--mode '" + mode + "'", "uses the scalars, not an array", "leave out the array's name");
  }
}

std::vector<std::string> NameModes(vtkVolumeHapticsFilter* filter)
{
  std::vector<std::string> names;
  const bool isFelt = filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES;
  for (int i = 0; isFelt && i < filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = filter->GetMode(i);
    names.push_back(mode->GetActive() ? std::to_string(i + 1) + " " + mode->GetText() : "");
  }
  return names;
}

void AddModes(const std::vector<std::string>& modes, const std::string& wantedFlow,
  const std::string& guide, vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  if (!guide.empty())
  {
    filter->AddMode(ReadGuideFile(guide, image));
  }
  for (const std::string& mode : modes)
  {
    AddMode(mode, image, filter);
  }
  if (modes.empty())
  {
    const std::string flow = wantedFlow.empty() ? FindVectors(image) : wantedFlow;
    const bool hasVectors = !flow.empty();
    const bool hasTensors = !FindTensors(image).empty();
    const std::string first = hasVectors ? "vector-follow:" + flow
      : hasTensors                       ? "tensor-follow"
                                         : "surface";
    AddMode(first, image, filter);
    filter->GetMode(filter->GetNumberOfModes() - 1)->SetActive(guide.empty());
    OfferModes(image, filter);
  }
}
} // namespace Explore
