// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Modes/ModePresets.h"

#include "Core/Field/FieldSampler.h"
#include "Core/Math/SymmetricEigen.h"
#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/HapticModes.h"

#include "vtkHapticMode.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace VolumeHaptics
{

namespace
{

constexpr double WholeHold = 2.0; ///< strength (N) of a hold at full strength
/** Largest number of positions examined along an axis: a few thousand in total are enough. */
constexpr std::int64_t MostLookups = 24;
/** Fraction of the positive values that lie below the "large value" of a measure. */
constexpr double LargeFraction = 0.95;
/** LargeFraction for ridges: vessels fill only a small part of a volume. */
constexpr double LargeRidgeFraction = 0.995;

using Measure = std::function<double(const Vector3& index)>;

/**
 * Computes a measure at a regular grid of positions. Returns the positive values in ascending
 * order.
 */
std::vector<double> CollectMeasure(const VolumeView& view, const Measure& measure)
{
  std::vector<double> found;
  std::int64_t step[3];
  for (int a = 0; a < 3; ++a)
  {
    step[a] = std::max<std::int64_t>(1, view.Dimensions[a] / MostLookups);
  }
  for (std::int64_t k = step[2] / 2; k < view.Dimensions[2]; k += step[2])
  {
    for (std::int64_t j = step[1] / 2; j < view.Dimensions[1]; j += step[1])
    {
      for (std::int64_t i = step[0] / 2; i < view.Dimensions[0]; i += step[0])
      {
        const double value = measure({ static_cast<double>(view.First[0] + i),
          static_cast<double>(view.First[1] + j), static_cast<double>(view.First[2] + k) });
        if (value > 0.0 && std::isfinite(value))
        {
          found.push_back(value);
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

double FirstRate(const Matrix3& j)
{
  const Matrix3 turned = Transpose(j);
  return ComputeEigen({ { 0.5 * (j.Row[0] + turned.Row[0]), 0.5 * (j.Row[1] + turned.Row[1]),
                        0.5 * (j.Row[2] + turned.Row[2]) } })
    .Value[0];
}

/** Returns the quantity that the strength of a vector mode depends on. */
Measure MeasureVectors(ModeKind kind, const VectorField& field)
{
  return [kind, &field](const Vector3& index)
  {
    Vector3 v;
    Matrix3 j;
    if (!field.Read(index, v, j))
    {
      return 0.0;
    }
    if (kind == ModeKind::VortexTube)
    {
      return Norm({ j.Row[2].Y - j.Row[1].Z, j.Row[0].Z - j.Row[2].X, j.Row[1].X - j.Row[0].Y });
    }
    return kind == ModeKind::Shear ? FirstRate(j) : Norm(v);
  };
}

/**
 * Returns the measure of how tubular the scalars are (vtkHapticMode::SetKind), computed with a
 * kernel of 2 voxels.
 */
Measure MeasureRidges(const FieldSampler& scalars, const Affine3& indexToWorld, bool isDark)
{
  return [&scalars, sign = isDark ? -1.0 : 1.0, worldToIndex = Inverse(indexToWorld.Linear)](
           const Vector3& index)
  {
    const auto slope = [&](const Vector3& half)
    { return scalars.Gradient(index + half).Gradient - scalars.Gradient(index - half).Gradient; };
    if (!(scalars.DistanceToBorder(index) > 1.0))
    {
      return 0.0; // derivatives need samples on both sides
    }
    const Matrix3 ofIndex = Matrix3::FromColumns(
      slope({ 0.5, 0.0, 0.0 }), slope({ 0.0, 0.5, 0.0 }), slope({ 0.0, 0.0, 0.5 }));
    const Matrix3 turned = Transpose(worldToIndex);
    const Matrix3 hessian = sign * (turned * (ofIndex * worldToIndex));
    const Matrix3 other = Transpose(hessian);
    const SymmetricEigen eigen = ComputeEigen({ { 0.5 * (hessian.Row[0] + other.Row[0]),
      0.5 * (hessian.Row[1] + other.Row[1]), 0.5 * (hessian.Row[2] + other.Row[2]) } });
    return -eigen.Value[1] - std::abs(eigen.Value[0]);
  };
}

void SetPoints(vtkHapticMode* mode, double none, double whole)
{
  vtkPiecewiseFunction* const strength = mode->GetStrength();
  strength->RemoveAllPoints();
  strength->AddPoint(none, 0.0);
  strength->AddPoint(whole, WholeHold);
}

/**
 * Sets the strength: 0 up to a tenth of the large value of the measure, and full from half of the
 * large value on.
 */
bool SetPointsOf(vtkHapticMode* mode, const std::vector<double>& found, double fraction)
{
  if (found.empty())
  {
    return false;
  }
  const auto at = static_cast<std::size_t>(fraction * static_cast<double>(found.size() - 1));
  SetPoints(mode, 0.1 * found[at], 0.5 * found[at]);
  return true;
}

} // namespace

bool ProposeStrength(vtkHapticMode* mode, vtkImageData* image, std::string& error)
{
  constexpr int kernelRadius = 2;
  std::vector<ModeDescription> described;
  if (mode->GetKind() == vtkHapticMode::GUIDE || mode->GetKind() == vtkHapticMode::SURFACE)
  {
    mode->SetStrength(nullptr); // the default of a guide is the same strength everywhere
    return true;
  }
  vtkDataArray* const own = FindModeArray({ mode }, image);
  vtkDataArray* const array = own ? own : image->GetPointData()->GetScalars();
  HapticVolume volume;
  const bool wasActive = mode->GetActive();
  mode->SetActive(true);
  const bool isThere = array != nullptr &&
    ReadVolume(image, array, 0, kernelRadius, volume, error) &&
    DescribeModes({ mode }, image, volume.View, described, error);
  mode->SetActive(wasActive);
  if (!isThere)
  {
    error = error.empty() ? "The image has no point array for this mode. Name one with "
                            "SetArrayName(), or give the image active vectors, tensors or scalars."
                          : error;
    return false;
  }
  const ModeDescription& d = described.front();
  bool isFound = true;
  if (d.Kind == ModeKind::TensorFollow)
  {
    SetPoints(mode, 0.15, 0.4); // the linear anisotropy has no unit, so these suit any image
  }
  else if (d.Kind == ModeKind::Ridge)
  {
    const GradientKernel kernel(GradientEstimator::Gaussian, kernelRadius);
    const FieldSampler scalars(volume.View, kernel);
    isFound = SetPointsOf(mode,
      CollectMeasure(volume.View, MeasureRidges(scalars, volume.IndexToWorld, d.IsDark)),
      LargeRidgeFraction);
  }
  else
  {
    const VectorField field(d.View, volume.IndexToWorld, d.Axes);
    isFound =
      SetPointsOf(mode, CollectMeasure(volume.View, MeasureVectors(d.Kind, field)), LargeFraction);
  }
  error = isFound
    ? ""
    : "The array has nothing that this mode could hold: it is 0, the same everywhere, "
      "or not finite. Name another one with SetArrayName().";
  return isFound;
}

namespace
{

struct ModePreset
{
  const char* Name;
  int Kind;
  /** Ratio of the second strength to the proposed strength; 0: no second strength. */
  double Fraction;
  bool TouchesSurfaces;
  void (*Adjust)(vtkHapticMode*); ///< changes further settings of the kind; null: keep the defaults
};

constexpr ModePreset ModePresetRows[] = {
  { "Follow the flow", vtkHapticMode::VECTOR_FOLLOW, 0.0, false, nullptr },
  { "Drift with the flow", vtkHapticMode::VECTOR_FOLLOW, 0.25, false, nullptr },
  { "Feel wave fronts", vtkHapticMode::VECTOR_FRONT, 0.0, false,
    [](vtkHapticMode* mode) { mode->TwoSidedOn(); } },
  { "Find a vortex", vtkHapticMode::VORTEX, 0.25, false, nullptr },
  { "Feel where a flow stretches", vtkHapticMode::SHEAR, 0.0, false, nullptr },
  { "Slide along fibres", vtkHapticMode::TENSOR_FOLLOW, 0.0, false, nullptr },
  { "Slide along fibres and sheets", vtkHapticMode::TENSOR_FOLLOW, 0.5, false, nullptr },
  { "Follow a vessel", vtkHapticMode::RIDGE, 0.0, false, nullptr },
  { "Follow a dark vessel", vtkHapticMode::RIDGE, 0.0, false,
    [](vtkHapticMode* mode) { mode->SetPolarityToDark(); } },
  { "Follow the flow and touch surfaces", vtkHapticMode::VECTOR_FOLLOW, 0.0, true, nullptr },
};

vtkSmartPointer<vtkHapticMode> MakeMode(int kind)
{
  auto mode = vtkSmartPointer<vtkHapticMode>::New();
  mode->SetKind(kind);
  return mode;
}

bool SuitImage(
  const ModePreset& preset, vtkHapticMode* mode, vtkImageData* image, std::string& error)
{
  if (!mode->GetArrayText().empty() && !FindModeArray({ mode }, image))
  {
    const std::string array = mode->FindArrayName(image);
    if (array.empty())
    {
      error = "The image has no " + mode->GetArrayText() + " for the preset \"" + preset.Name +
        "\". Give it such an array, or use another preset: see GetModePresetNames().";
      return false;
    }
    mode->SetArrayName(array.c_str());
  }
  return ProposeStrength(mode, image, error);
}

/** Sets the second strength to the strength times the preset's Fraction. */
void FillSecond(const ModePreset& preset, vtkHapticMode* mode)
{
  vtkPiecewiseFunction* const strength = mode->GetStrength();
  vtkPiecewiseFunction* const second = mode->GetSecondStrength();
  for (int i = 0; i < strength->GetSize(); ++i)
  {
    double node[4];
    strength->GetNodeValue(i, node);
    second->AddPoint(node[0], preset.Fraction * node[1], node[2], node[3]);
  }
  if (strength->GetSize() == 0)
  {
    second->AddPoint(0.0, preset.Fraction * GetModeFunctions(mode).front().Default);
  }
}

} // namespace

HapticModes MakeModePreset(const char* name, vtkImageData* image, std::string& error)
{
  std::string known;
  for (const ModePreset& preset : ModePresetRows)
  {
    known += (known.empty() ? "\"" : ", \"") + std::string(preset.Name) + "\"";
    if (!name || std::string(name) != preset.Name)
    {
      continue;
    }
    HapticModes modes = { MakeMode(preset.Kind) };
    if (preset.Adjust)
    {
      preset.Adjust(modes.front());
    }
    if (image && !SuitImage(preset, modes.front(), image, error))
    {
      return {};
    }
    if (preset.Fraction > 0.0)
    {
      FillSecond(preset, modes.front());
    }
    if (preset.TouchesSurfaces)
    {
      modes.push_back(MakeMode(vtkHapticMode::SURFACE));
    }
    return modes;
  }
  error = "There is no preset of modes \"" + (name ? Printable(name) : std::string("(null)")) +
    "\". Use one of: " + known + ".";
  return {};
}

vtkSmartPointer<vtkStringArray> MakeModePresetNames()
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  for (const ModePreset& preset : ModePresetRows)
  {
    names->InsertNextValue(preset.Name);
  }
  return names;
}

} // namespace VolumeHaptics
