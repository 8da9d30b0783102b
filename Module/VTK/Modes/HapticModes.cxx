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
#include "vtkHapticRidgeMode.h"
#include "vtkHapticShearMode.h"
#include "vtkHapticSurfaceMode.h"
#include "vtkHapticTensorFollowMode.h"
#include "vtkHapticVectorFollowMode.h"
#include "vtkHapticVectorFrontMode.h"
#include "vtkHapticVortexMode.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

template <typename Mode>
vtkSmartPointer<vtkHapticMode> MakeMode()
{
  return vtkSmartPointer<Mode>::New();
}

constexpr ModeFunction HoldStrength = { "Strength", 2.0,
  [](vtkHapticMode* mode) { return mode->GetStrength(); } };

std::string ClassOf(const ModeKindRow& kind)
{
  return std::string("vtkHaptic") + kind.Name + "Mode";
}

/** Returns the index of a mode's kind in GetModeKinds(); their number if it has none. */
std::size_t IndexOfKind(vtkHapticMode* mode)
{
  const auto& kinds = GetModeKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
    [mode](const ModeKindRow& kind) { return mode->IsA(ClassOf(kind).c_str()); });
  return static_cast<std::size_t>(found - kinds.begin());
}

ModeKind BakedKindOf(vtkHapticMode* mode)
{
  if (auto* const front = vtkHapticVectorFrontMode::SafeDownCast(mode))
  {
    return front->GetTwoSided() ? ModeKind::TwoSidedFront : ModeKind::VectorFront;
  }
  constexpr ModeKind kinds[] = { ModeKind::VectorFollow, ModeKind::VectorFront,
    ModeKind::VortexTube, ModeKind::Shear, ModeKind::TensorFollow, ModeKind::Ridge, ModeKind::Guide,
    ModeKind::Surface };
  return kinds[IndexOfKind(mode)];
}

bool HasComponents(ModeInput input, int components)
{
  return input == ModeInput::Vectors ? components == 3 : components == 6 || components == 9;
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

/** Holds a reference to an object; created and released outside the servo thread. */
std::shared_ptr<const void> ShareObject(vtkObjectBase* object)
{
  object->Register(nullptr);
  return { static_cast<const void*>(object),
    [object](const void*) { object->UnRegister(nullptr); } };
}

/** Describes modes one by one, until there is an error. */
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
    const ModeKindRow& kind = FindModeKind(mode);
    d.Kind = BakedKindOf(mode);
    d.IsActive = mode->GetActive();
    d.Axes = mode->GetAxes() == vtkHapticMode::IMAGE ? VectorAxes::Image : VectorAxes::World;
    if (!d.IsActive)
    {
      return true;
    }
    if (auto* const ridge = vtkHapticRidgeMode::SafeDownCast(mode))
    {
      d.IsDark = ridge->GetPolarity() == vtkHapticRidgeMode::DARK;
      d.SnapDistance = ridge->GetSnapDistance();
    }
    Polyline* const lines[] = { &d.First, &d.Second };
    for (std::size_t i = 0; i < kind.Functions.size(); ++i)
    {
      if (!this->ReadFunction(mode, kind, kind.Functions[i], *lines[i]))
      {
        return false;
      }
    }
    auto* const guide = vtkHapticGuideMode::SafeDownCast(mode);
    return (!guide || this->ReadGuide(guide, d)) &&
      (kind.Input == ModeInput::None || this->ReadArray(mode, kind, d));
  }

  std::string GetError() const { return this->Message.str(); }

private:
  bool ReadFunction(
    vtkHapticMode* mode, const ModeKindRow& kind, const ModeFunction& function, Polyline& line)
  {
    line = ToPolyline(function.Get(mode), function.Default);
    const std::string fault =
      FindFunctionFault(line, HUGE_VAL, std::string(function.Name) + " of a " + ClassOf(kind),
        "0 N or more", ClassOf(kind) + "::Get" + function.Name + "()");
    this->Message << fault;
    return fault.empty();
  }

  bool ReadArray(vtkHapticMode* mode, const ModeKindRow& kind, ModeDescription& d)
  {
    vtkDataArray* const array = FindArray(mode, kind.Input, this->Image);
    const std::string name = mode->GetArrayName();
    const char* const wanted = kind.Input == ModeInput::Vectors
      ? "vectors of 3 components"
      : "tensors of 6 (XX, YY, ZZ, XY, YZ, XZ) or 9 components";
    if (!array)
    {
      this->Message << "The input image on input port 0 has no "
                    << (name.empty() ? "active " + std::string(wanted)
                                     : "numeric point array \"" + name + "\"")
                    << " for a " << ClassOf(kind) << ". Name a point array of " << wanted
                    << " with SetArrayName(), or switch the mode off with SetActive(false).";
      return false;
    }
    const int components = array->GetNumberOfComponents();
    if (!HasComponents(kind.Input, components))
    {
      this->Message << "The " << DescribeArray(array) << " of the input image on input port 0 has "
                    << components << " component(s), and a " << ClassOf(kind) << " needs " << wanted
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
      // Copies components that are stored separately, or computed.
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

const std::vector<ModeKindRow>& GetModeKinds()
{
  using F = vtkHapticVectorFollowMode;
  using V = vtkHapticVortexMode;
  using T = vtkHapticTensorFollowMode;
  // Never destroyed: see MethodChoices().
  static const auto* const kinds = new std::vector<ModeKindRow>{
    { "VectorFollow", ModeInput::Vectors, &MakeMode<F>,
      { HoldStrength,
        { "Push", 0.0, [](vtkHapticMode* m) { return F::SafeDownCast(m)->GetPush(); } } } },
    { "VectorFront", ModeInput::Vectors, &MakeMode<vtkHapticVectorFrontMode>, { HoldStrength } },
    { "Vortex", ModeInput::Vectors, &MakeMode<V>,
      { HoldStrength,
        { "AxisStrength", 0.0,
          [](vtkHapticMode* m) { return V::SafeDownCast(m)->GetAxisStrength(); } } } },
    { "Shear", ModeInput::Vectors, &MakeMode<vtkHapticShearMode>, { HoldStrength } },
    { "TensorFollow", ModeInput::Tensors, &MakeMode<T>,
      { HoldStrength,
        { "SheetStrength", 0.0,
          [](vtkHapticMode* m) { return T::SafeDownCast(m)->GetSheetStrength(); } } } },
    { "Ridge", ModeInput::None, &MakeMode<vtkHapticRidgeMode>, { HoldStrength } },
    { "Guide", ModeInput::None, &MakeMode<vtkHapticGuideMode>, { HoldStrength } },
    { "Surface", ModeInput::None, &MakeMode<vtkHapticSurfaceMode>, {} },
  };
  return *kinds;
}

bool HasModeKind(vtkHapticMode* mode)
{
  return IndexOfKind(mode) < GetModeKinds().size();
}

const ModeKindRow& FindModeKind(vtkHapticMode* mode)
{
  return GetModeKinds()[IndexOfKind(mode)];
}

std::string GetModeText(vtkHapticMode* mode)
{
  std::string text;
  if (HasModeKind(mode))
  {
    for (const char* c = FindModeKind(mode).Name; *c; ++c)
    {
      const bool isCapital = *c >= 'A' && *c <= 'Z';
      text += isCapital && !text.empty() ? " " : "";
      text += isCapital ? static_cast<char>(*c - 'A' + 'a') : *c;
    }
    const std::string array = mode->GetArrayName();
    text += FindModeKind(mode).Input == ModeInput::None || array.empty() ? "" : ", " + array;
  }
  return text;
}

void PrintMode(std::ostream& os, vtkIndent indent, vtkHapticMode* mode)
{
  PrintSettings(os, indent, mode, ModeTexts);
  PrintSettings(os, indent, mode, ModeSettings);
  if (!HasModeKind(mode))
  {
    return;
  }
  for (const ModeFunction& function : FindModeKind(mode).Functions)
  {
    os << indent << function.Name << ":\n";
    function.Get(mode)->PrintSelf(os, indent.GetNextIndent());
  }
}

vtkDataArray* FindModeArray(const HapticModes& modes, vtkImageData* image)
{
  for (vtkHapticMode* const mode : modes)
  {
    const ModeInput input = FindModeKind(mode).Input;
    vtkDataArray* const array =
      mode->GetActive() && input != ModeInput::None ? FindArray(mode, input, image) : nullptr;
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
    primitives += mode->GetActive() ? CountPrimitives(described.back().Kind) : 0;
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
    primitives += CountPrimitives(BakedKindOf(mode));
  }
  return static_cast<int>(modes.size()) <= ModeField::Most && primitives <= PrimitiveSet::Most;
}

} // namespace VolumeHaptics
