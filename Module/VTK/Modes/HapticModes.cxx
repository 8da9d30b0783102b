// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Modes/HapticModes.h"

#include "Core/Model/BakedMode.h"
#include "Core/Solvers/Primitives/ModePrimitives.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/HapticModeSettings.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHapticGuideMode.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <sstream>
#include <tuple>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Makes a line of the points with these ids, or, without ids, of the first `count` points in their
 * order.
 */
GuidePath::Line LineOf(vtkPolyData* path, vtkIdType count, const vtkIdType* ids)
{
  GuidePath::Line line;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* const x = path->GetPoint(ids ? ids[i] : i);
    line.push_back({ x[0], x[1], x[2] });
  }
  return line;
}

bool ReadLines(vtkPolyData* path, std::vector<GuidePath::Line>& lines, std::string& error)
{
  if (path->GetNumberOfLines() == 0)
  {
    lines.push_back(LineOf(path, path->GetNumberOfPoints(), nullptr));
    return true;
  }
  const vtkIdType points = path->GetPoints() ? path->GetNumberOfPoints() : 0;
  vtkCellArray* const cells = path->GetLines();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, count, ids);
    const auto* const missing =
      std::find_if(ids, ids + count, [points](vtkIdType id) { return id < 0 || id >= points; });
    if (missing != ids + count)
    {
      error = "A line of the path of a vtkHapticGuideMode has the point " +
        std::to_string(*missing) + ", but the path has " + std::to_string(points) +
        " points. Correct it, or give the mode another one with SetPath().";
      return false;
    }
    lines.push_back(LineOf(path, count, ids));
  }
  return true;
}

bool ReadPath(vtkPolyData* path, double rounding, ModeDescription& d, std::string& error)
{
  std::vector<GuidePath::Line> lines;
  if (!ReadLines(path, lines, error))
  {
    return false;
  }
  for (const GuidePath::Line& line : lines)
  {
    if (!std::all_of(line.begin(), line.end(), [](const Vector3& x) { return IsFinite(x); }))
    {
      error = "The path of a vtkHapticGuideMode has a point that is not finite. Correct it, or "
              "give the mode another one with SetPath().";
      return false;
    }
  }
  d.Guide = std::make_shared<const GuidePath>(lines, rounding);
  if (d.Guide->IsEmpty())
  {
    error = "The path of a vtkHapticGuideMode has no line: it needs at least two points that "
            "differ. Give it polylines with SetPath(), or switch it off with SetActive(false).";
    return false;
  }
  return true;
}

/** Caches the meshes that models still use, so that an unchanged surface is not prepared again. */
class MeshesInUse
{
public:
  std::shared_ptr<const GuideMesh> Get(vtkPolyData* surface, double rounding, std::string& error)
  {
    // Include the modification time, which is unique, so that new data at an old address have
    // another key.
    const Key key{ surface, surface->GetMTime(), rounding };
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (const auto known = this->Meshes[key].lock())
    {
      return known;
    }
    const auto triangles = MeshSurface(surface, "The surface of a vtkHapticGuideMode",
      "Give the mode a vtkPolyData with polygons or strips with SetSurface(), or switch it off "
      "with SetActive(false).",
      error);
    const auto mesh = triangles ? std::make_shared<const GuideMesh>(triangles, rounding) : nullptr;
    this->Meshes[key] = mesh;
    for (auto i = this->Meshes.begin(); i != this->Meshes.end();)
    {
      i = i->second.expired() ? this->Meshes.erase(i) : std::next(i);
    }
    return mesh;
  }

private:
  using Key = std::tuple<const void*, vtkMTimeType, double>;
  std::mutex Mutex;
  std::map<Key, std::weak_ptr<const GuideMesh>> Meshes;
};

bool ReadSurface(
  vtkPolyData* surface, double rounding, double distance, ModeDescription& d, std::string& error)
{
  // Never destroyed: see MethodChoices().
  static auto* const meshes = new MeshesInUse;
  const auto mesh = meshes->Get(surface, rounding, error);
  d.GuideSurface = mesh ? std::make_shared<const GuideSurface>(mesh, distance) : nullptr;
  return mesh != nullptr;
}

bool ReadDistanceField(vtkImageData* field, double distance, ModeDescription& d, std::string& error)
{
  constexpr int kernelRadius = 1;
  const std::string name = "The distance field of a vtkHapticGuideMode";
  vtkDataArray* const scalars = field->GetPointData()->GetScalars();
  if (!scalars)
  {
    error = name +
      " has no active point scalars. Name them with SetActiveScalars() of its point "
      "data, or give the mode another image with SetDistanceField().";
    return false;
  }
  HapticVolume volume;
  if (!ReadVolume(field, scalars, 0, kernelRadius, volume, error))
  {
    error = name + " can't be read. " + error;
    return false;
  }
  vtkDataArray* const holder = volume.Holder;
  holder->Register(nullptr);
  const std::shared_ptr<const void> samples = { static_cast<const void*>(holder),
    [holder](const void*) { holder->UnRegister(nullptr); } };
  d.GuideSurface =
    std::make_shared<const GuideSurface>(volume.View, samples, volume.IndexToWorld, distance);
  return true;
}

/**
 * Describes the path, the surface or the distance field of a guide, with corners rounded by
 * `rounding` (world units). Returns false, with the reason and the cure in `error`, unless the
 * guide has exactly one of them and it can be felt.
 */
bool DescribeGuide(
  vtkHapticGuideMode* mode, double rounding, ModeDescription& d, std::string& error)
{
  const int shapes =
    (mode->GetPath() ? 1 : 0) + (mode->GetSurface() ? 1 : 0) + (mode->GetDistanceField() ? 1 : 0);
  if (shapes != 1)
  {
    error = std::string("A vtkHapticGuideMode has ") +
      (shapes == 0 ? "no path, surface or distance field" : "more than one shape to follow") +
      ". Give it exactly one with SetPath(), SetSurface() or SetDistanceField(), and nullptr for "
      "the others; or switch it off with SetActive(false).";
    return false;
  }
  const double distance = mode->GetDistance();
  if (!std::isfinite(distance))
  {
    error = "The Distance of a vtkHapticGuideMode is not finite. Set a number of world units with "
            "SetDistance().";
    return false;
  }
  if (mode->GetPath())
  {
    return ReadPath(mode->GetPath(), rounding, d, error);
  }
  constexpr GuideSide sides[] = { GuideSide::Surface, GuideSide::Outside, GuideSide::Inside };
  d.Side = sides[mode->GetSide()];
  return mode->GetSurface() ? ReadSurface(mode->GetSurface(), rounding, distance, d, error)
                            : ReadDistanceField(mode->GetDistanceField(), distance, d, error);
}

/** Returns the name of a mode for error texts. */
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
 * Returns a shared pointer that owns a reference to an object. Create and release it outside the
 * servo's thread.
 */
std::shared_ptr<const void> ShareObject(vtkObjectBase* object)
{
  object->Register(nullptr);
  return { static_cast<const void*>(object),
    [object](const void*) { object->UnRegister(nullptr); } };
}

/** Describes modes one after another and stops at the first error. */
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
      // Copy an array whose components are stored separately or computed on access.
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
    // The settings of a guide belong to vtkHapticGuideMode, and are described by DescribeGuide().
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
