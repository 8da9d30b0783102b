// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/ModeChoice.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Errors/MessageCapture.h"
#include "Applications/Explorer/Exploration/GuideFile.h"

#include "vtkDataArray.h"
#include "vtkHapticRidgeMode.h"
#include "vtkHapticShearMode.h"
#include "vtkHapticSurfaceMode.h"
#include "vtkHapticTensorFollowMode.h"
#include "vtkHapticVectorFollowMode.h"
#include "vtkHapticVectorFrontMode.h"
#include "vtkHapticVortexMode.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"

#include <functional>
#include <map>

namespace
{
using Explore::InputError;
using ModePointer = vtkSmartPointer<vtkHapticMode>;

enum class Needs
{
  Scalars,
  Vectors,
  Tensors
};

struct ModeName
{
  Needs What;
  std::function<ModePointer()> Make;
};

template <typename Mode>
ModePointer Make()
{
  return vtkSmartPointer<Mode>::New();
}

ModePointer MakeTwoSided()
{
  auto mode = vtkSmartPointer<vtkHapticVectorFrontMode>::New();
  mode->TwoSidedOn();
  return mode;
}

ModePointer MakeDarkRidge()
{
  auto mode = vtkSmartPointer<vtkHapticRidgeMode>::New();
  mode->SetPolarityToDark();
  return mode;
}

const std::map<std::string, ModeName>& Modes()
{
  static const std::map<std::string, ModeName> modes = {
    { "vector-follow", { Needs::Vectors, &Make<vtkHapticVectorFollowMode> } },
    { "vector-front", { Needs::Vectors, &Make<vtkHapticVectorFrontMode> } },
    { "two-sided-front", { Needs::Vectors, &MakeTwoSided } },
    { "vortex", { Needs::Vectors, &Make<vtkHapticVortexMode> } },
    { "shear", { Needs::Vectors, &Make<vtkHapticShearMode> } },
    { "tensor-follow", { Needs::Tensors, &Make<vtkHapticTensorFollowMode> } },
    { "ridge", { Needs::Scalars, &Make<vtkHapticRidgeMode> } },
    { "dark-ridge", { Needs::Scalars, &MakeDarkRidge } },
    { "surface", { Needs::Scalars, &Make<vtkHapticSurfaceMode> } },
  };
  return modes;
}

/// The first array with vectors or tensors; empty if there is none.
std::string FindField(vtkImageData* image, Needs what)
{
  vtkPointData* const points = image->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = points->GetArray(i);
    const int components = array && array->GetName() ? array->GetNumberOfComponents() : 0;
    if (what == Needs::Vectors ? components == 3 : components == 6 || components == 9)
    {
      return array->GetName();
    }
  }
  return {};
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
    throw InputError("--mode '" + name + "'", capture.FirstError(), "take another mode");
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
  const ModeName& known = Modes().at(name.substr(0, colon));
  const ModePointer mode = known.Make();
  const std::string wanted = colon == std::string::npos ? "" : name.substr(colon + 1);
  if (known.What != Needs::Scalars)
  {
    const std::string array = wanted.empty() ? FindField(image, known.What) : wanted;
    if (array.empty())
    {
      throw InputError("--mode " + name,
        known.What == Needs::Vectors ? "the volume has no vectors (a point array of 3 components)"
                                     : "the volume has no tensors (a point array of 6 or 9 "
                                       "components)",
        "name a .vti file that has them, or take another mode");
    }
    mode->SetArrayName(array.c_str());
  }
  const Explore::MessageCapture capture;
  if (!mode->ProposeFromImage(image))
  {
    throw InputError("--mode " + name, capture.FirstError(), "take another mode or array");
  }
  filter->AddMode(mode);
}

/// Adds the modes that the fields of an image allow in addition to a filter's, not active, so that
/// a window can turn them on. Modes of vectors use the array of the last mode, if that mode has
/// vectors.
void OfferModes(vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  const std::string known = filter->GetMode(filter->GetNumberOfModes() - 1)->GetArrayName();
  vtkDataArray* const array = image->GetPointData()->GetArray(known.c_str());
  const bool isOfVectors = array && array->GetNumberOfComponents() == 3;
  const std::string vectors = isOfVectors ? known : FindField(image, Needs::Vectors);
  const auto isThere = [filter](const ModePointer& mode)
  {
    bool found = false;
    for (int i = 0; i < filter->GetNumberOfModes(); ++i)
    {
      found = found || filter->GetMode(i)->IsA(mode->GetClassName());
    }
    return found;
  };
  for (const char* const name :
    { "vector-follow", "two-sided-front", "vortex", "shear", "tensor-follow" })
  {
    const ModeName& offer = Modes().at(name);
    const bool isFlow = offer.What == Needs::Vectors;
    const std::string field = isFlow ? vectors : FindField(image, Needs::Tensors);
    const ModePointer mode = offer.Make();
    mode->SetArrayName(field.c_str());
    // A mode with nothing to hold on, such as a flow without a rotation, is not offered.
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
  std::string list;
  for (const auto& mode : Modes())
  {
    list += (list.empty() ? "" : ", ") + mode.first;
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
  const auto known = Modes().find(mode.substr(0, colon));
  if (known == Modes().end() || (colon != std::string::npos && colon + 1 == mode.size()))
  {
    throw InputError("--mode '" + mode + "'", "is not known",
      "take one of: " + ListModes() +
        "; the name of an array may follow after a colon. Or one of: " + ListModePresets());
  }
  if (colon != std::string::npos && known->second.What == Needs::Scalars)
  {
    throw InputError("--mode '" + mode + "'", "is about the scalars, and has no array",
      "leave the array's name out");
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
    const std::string flow = wantedFlow.empty() ? FindField(image, Needs::Vectors) : wantedFlow;
    const bool hasVectors = !flow.empty();
    const bool hasTensors = !FindField(image, Needs::Tensors).empty();
    const std::string first = hasVectors ? "vector-follow:" + flow
      : hasTensors                       ? "tensor-follow"
                                         : "surface";
    AddMode(first, image, filter);
    filter->GetMode(filter->GetNumberOfModes() - 1)->SetActive(guide.empty());
    OfferModes(image, filter);
  }
}
} // namespace Explore
