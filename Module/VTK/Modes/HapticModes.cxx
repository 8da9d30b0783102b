// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Modes/HapticModes.h"

#include "Core/Solvers/Primitives/ModePrimitives.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Modes/GuideShapes.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/HapticModeSettings.h"

#include "vtkHapticGuideMode.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** Returns the name of a mode for an error. */
std::string NameOf(vtkHapticMode* mode)
{
  return mode->GetKind() == vtkHapticMode::GUIDE
    ? "vtkHapticGuideMode"
    : std::string("vtkHapticMode of kind ") + ModeSettingRows::KindNames[mode->GetKind()].Name;
}

vtkDataArray* FindArray(vtkHapticMode* mode, ModeInput input, vtkImageData* image)
{
  vtkPointData* const data = image->GetPointData();
  const std::string name = mode->GetArrayName();
  if (!name.empty())
  {
    return data->GetArray(name.c_str());
  }
  vtkDataArray* const active =
    input == ModeInput::Vectors ? data->GetVectors() : data->GetTensors();
  vtkDataArray* const scalars = data->GetScalars();
  const bool areScalars = scalars && HasComponents(input, scalars->GetNumberOfComponents());
  return active ? active : areScalars ? scalars : nullptr;
}

/**
 * Returns a pointer that holds a reference to an object. It must be created and released outside
 * the servo's thread.
 */
std::shared_ptr<const void> ShareObject(vtkObjectBase* object)
{
  object->Register(nullptr);
  return { static_cast<const void*>(object),
    [object](const void*) { object->UnRegister(nullptr); } };
}

/** Describes modes one after another, until the first error. */
class ModeDescriber
{
public:
  ModeDescriber(vtkImageData* image, const VolumeView& view)
    : Image(image)
    , View(view)
  {
  }

  bool Describe(vtkHapticMode* mode, ModeDescription& d)
  {
    const ModeKindRow& kind = GetModeKind(mode);
    d.Kind = kind.Describe(mode, d);
    d.IsActive = mode->GetActive();
    d.Axes = mode->GetAxes() == vtkHapticMode::IMAGE ? VectorAxes::Image : VectorAxes::World;
    if (!d.IsActive)
    {
      return true;
    }
    Polyline* line = &d.First;
    for (const ModeFunction& function : GetModeFunctions(mode))
    {
      if (!this->ReadFunction(mode, function, *line))
      {
        return false;
      }
      line = &d.Second;
    }
    if (!kind.Functions[1] && mode->GetSecondStrength()->GetSize() > 0)
    {
      this->Message << "A " << NameOf(mode)
                    << " has no SecondStrength, but was given one. "
                       "Take it away with SetSecondStrength(nullptr), or choose another kind.";
      return false;
    }
    auto* const guide = vtkHapticGuideMode::SafeDownCast(mode);
    return (!guide || this->ReadGuide(guide, d)) &&
      (mode->GetArrayText().empty() || this->ReadArray(mode, d));
  }

  std::string GetError() const { return this->Message.str(); }

private:
  bool ReadFunction(vtkHapticMode* mode, const ModeFunction& function, Polyline& line)
  {
    line = ToPolyline(function.Function, function.Default);
    const std::string fault =
      DetectFunctionFault(line, HUGE_VAL, std::string(function.Name) + " of a " + NameOf(mode),
        "0 N or more", std::string("vtkHapticMode::") + function.Getter);
    this->Message << fault;
    return fault.empty();
  }

  bool ReadArray(vtkHapticMode* mode, ModeDescription& d)
  {
    const ModeInput input = GetInput(mode);
    vtkDataArray* const array = FindArray(mode, input, this->Image);
    const std::string name = mode->GetArrayName();
    const char* const wanted = input == ModeInput::Vectors
      ? "vectors of 3 components"
      : "tensors of 6 (XX, YY, ZZ, XY, YZ, XZ) or 9 components";
    if (!array)
    {
      this->Message << "The input image on input port 0 has no "
                    << (name.empty() ? "active " + std::string(wanted)
                                     : "numeric point array \"" + name + "\"")
                    << " for a " << NameOf(mode) << ". Name a point array of " << wanted
                    << " with SetArrayName(), or switch the mode off with SetActive(false).";
      return false;
    }
    const int components = array->GetNumberOfComponents();
    if (!HasComponents(input, components))
    {
      this->Message << "The " << DescribeArray(array) << " of the input image on input port 0 has "
                    << components << " component(s), and a " << NameOf(mode) << " needs " << wanted
                    << ". Name another array with SetArrayName().";
      return false;
    }
    const vtkIdType points = this->Image->GetNumberOfPoints();
    if (array->GetNumberOfTuples() != points)
    {
      this->Message << "The " << DescribeArray(array) << " of the input image on input port 0 has "
                    << array->GetNumberOfTuples() << " tuples for " << points
                    << " points. Give it one tuple a point.";
      return false;
    }
    return this->ReadSamples(array, d);
  }

  bool ReadSamples(vtkDataArray* array, ModeDescription& d)
  {
    const int components = array->GetNumberOfComponents();
    int dimensions[3];
    this->Image->GetDimensions(dimensions);
    d.View.Volume = this->View;
    vtkSmartPointer<vtkDataArray> holder;
    bool isThere = LocateSamples(array, 0, dimensions, d.View.Volume, holder);
    if (!isThere || d.View.Volume.Stride[0] != components)
    {
      // Copy components that are stored separately, or computed on access.
      const auto copy = CopyArray(array);
      isThere = LocateSamples(copy, 0, dimensions, d.View.Volume, holder);
    }
    if (!isThere || !d.View.Volume.Data)
    {
      this->Message
        << "The " << DescribeArray(array) << " of the input image on input port 0 is a "
        << array->GetClassName() << " of " << array->GetDataTypeAsString()
        << ", which is an unsupported type. Copy it into an array of numbers, for example "
           "with vtkFloatArray::DeepCopy(), and give the mode that one.";
      return false;
    }
    d.View.Components = components;
    d.View.Stride = 1;
    d.Samples = ShareObject(holder);
    return true;
  }

  bool ReadGuide(vtkHapticGuideMode* mode, ModeDescription& d)
  {
    std::string error;
    const bool isThere = DescribeGuide(mode, SmallestSpacing(this->Image), d, error);
    this->Message << error;
    return isThere;
  }

  vtkImageData* const Image;
  const VolumeView& View;
  std::ostringstream Message;
};

} // namespace

const ModeKindRow& GetModeKind(vtkHapticMode* mode)
{
  using M = vtkHapticMode;
  using D = ModeDescription;
  constexpr const char* strength = "Strength";
  static constexpr ModeKindRow rows[] = {
    { { strength, "Push" }, {}, [](M*, D&) { return ModeKind::VectorFollow; } },
    { { strength, nullptr }, { "TwoSided", nullptr },
      [](M* mode, D&)
      { return mode->GetTwoSided() ? ModeKind::TwoSidedFront : ModeKind::VectorFront; } },
    { { strength, "AxisStrength" }, {}, [](M*, D&) { return ModeKind::VortexTube; } },
    { { strength, nullptr }, {}, [](M*, D&) { return ModeKind::Shear; } },
    { { strength, "SheetStrength" }, {}, [](M*, D&) { return ModeKind::TensorFollow; } },
    { { strength, nullptr }, { "Polarity", "SnapDistance" },
      [](M* mode, D& d)
      {
        d.IsDark = mode->GetPolarity() == M::DARK;
        d.SnapDistance = mode->GetSnapDistance();
        return ModeKind::Ridge;
      } },
    // GuideShapes.h describes the settings of a guide, which are those of vtkHapticGuideMode.
    { { strength, nullptr }, {},
      [](M* mode, D&)
      {
        return vtkHapticGuideMode::SafeDownCast(mode)->GetPath() ? ModeKind::Guide
                                                                 : ModeKind::GuideSurface;
      } },
    { {}, {}, [](M*, D&) { return ModeKind::Surface; } },
  };
  static_assert(std::size(rows) == std::size(ModeSettingRows::KindNames));
  return rows[mode->GetKind()];
}

ModeInput GetInput(vtkHapticMode* mode)
{
  ModeDescription unused;
  return FactsOf(GetModeKind(mode).Describe(mode, unused)).Input;
}

bool HasComponents(ModeInput input, int components)
{
  return input == ModeInput::Vectors
    ? components == 3
    : input == ModeInput::Tensors && (components == 6 || components == 9);
}

std::vector<ModeFunction> GetModeFunctions(vtkHapticMode* mode)
{
  const ModeKindRow& kind = GetModeKind(mode);
  std::vector<ModeFunction> functions;
  if (kind.Functions[0])
  {
    functions.push_back({ kind.Functions[0], "GetStrength()", 2.0, mode->GetStrength() });
  }
  if (kind.Functions[1])
  {
    functions.push_back(
      { kind.Functions[1], "GetSecondStrength()", 0.0, mode->GetSecondStrength() });
  }
  return functions;
}

vtkDataArray* FindModeArray(const HapticModes& modes, vtkImageData* image)
{
  for (vtkHapticMode* const mode : modes)
  {
    vtkDataArray* const array = mode->GetActive() && !mode->GetArrayText().empty()
      ? FindArray(mode, GetInput(mode), image)
      : nullptr;
    if (array)
    {
      return array;
    }
  }
  return nullptr;
}

bool DescribeModes(const HapticModes& modes, vtkImageData* image, const VolumeView& view,
  std::vector<ModeDescription>& described, std::string& error)
{
  ModeDescriber describer(image, view);
  int primitives = 0;
  for (vtkHapticMode* const mode : modes)
  {
    described.emplace_back();
    if (!describer.Describe(mode, described.back()))
    {
      error = describer.GetError();
      return false;
    }
    primitives += mode->GetActive() ? FactsOf(described.back().Kind).Primitives : 0;
  }
  std::ostringstream message;
  if (static_cast<int>(modes.size()) > ModeField::Most || primitives > PrimitiveSet::Most)
  {
    message << "The " << modes.size() << " modes of the method PRIMITIVES are too many: a tick has "
            << "time for " << ModeField::Most << " modes with " << PrimitiveSet::Most
            << " primitives, and those that are active have " << primitives
            << ". Take some away with RemoveMode()"
            << (static_cast<int>(modes.size()) > ModeField::Most
                   ? "; modes that are switched off count, too."
                   : ", or switch them off with SetActive(false).");
  }
  error = message.str();
  return error.empty();
}

bool FitIntoATick(const HapticModes& modes)
{
  int primitives = 0;
  for (vtkHapticMode* const mode : modes)
  {
    ModeDescription unused;
    primitives += FactsOf(GetModeKind(mode).Describe(mode, unused)).Primitives;
  }
  return static_cast<int>(modes.size()) <= ModeField::Most && primitives <= PrimitiveSet::Most;
}

} // namespace VolumeHaptics
