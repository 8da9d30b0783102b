// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/HapticModelBuilder.h"

#include "Core/Math/PolylineMask.h"
#include "Core/Model/SurfaceMesh.h"
#include "Core/Solvers/SurfaceProxy/SurfaceProxy.h"
#include "VTK/Baking/HapticCut.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Filter/RegionSeries.h"
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Tools/RemovalAccess.h"
#include "VTK/Tools/ToolKind.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/** Describes the allowed range of a function's values, with the unit. */
std::string DescribeRange(const PropertyFunction& function)
{
  const std::string unit = *function.Unit ? std::string(" ") + function.Unit : std::string();
  return function.Maximum == 1.0 ? "between 0 and 1" + unit : "0" + unit + " or more";
}

/** Converts a function of the gradient magnitude from the property's values to scalar units. */
void ScaleSlopes(vtkHapticProperty* property, Polyline& line)
{
  for (Vertex& vertex : line)
  {
    vertex.X /= property->GetScalarScale();
  }
}

/**
 * Estimates from the image, if possible, the shift to add to the scalars, stores it in the
 * property, and describes it in `notice`.
 */
void EstimateShift(vtkHapticProperty* property, vtkImageData* image, vtkDataArray* scalars,
  const HapticVolume& volume, int component, std::string& notice)
{
  property->NoteShift(0.0);
  if (!property->GetShiftFromImage() || property->GetScalarShift() != 0.0 ||
    property->GetScalarScale() != 1.0)
  {
    return;
  }
  const StoredShift found = volume.Whole.IsThere
    ? volume.Whole.Shift
    : EstimateStoredShift(image, scalars, volume.View, component);
  property->NoteShift(found.Shift);
  std::ostringstream text;
  if (found.Shift != 0.0)
  {
    text << "The " << DescribeArray(scalars)
         << " of the input image is taken for Hounsfield units + " << -found.Shift
         << ": its air is at " << found.Air << ". vtkHapticProperty::SetScalarShift(" << found.Shift
         << ") says so without a search; ShiftFromImageOff() takes the values as they are.";
  }
  else if (found.IsStrange || scalars->GetDataTypeSize() == 1)
  {
    text << "The " << DescribeArray(scalars)
         << " of the input image can't be a CT in Hounsfield units, of which the preset is: its "
            "values go from "
         << found.Range[0] << " to " << found.Range[1]
         << ". Choose a preset for other data or propose one from the image, or say with "
            "vtkHapticProperty's SetScalarShift() and SetScalarScale() how (scalar + shift) scale "
            "becomes Hounsfield units.";
  }
  notice = text.str();
}

bool BakeFunctions(vtkHapticProperty* property, HapticMaterial& material, std::string& error)
{
  for (const PropertyFunction& rule : PropertyFunctions)
  {
    Polyline& line = material.*rule.Baked;
    line = ToPolyline((property->*rule.Get)(), rule.Default);
    error =
      DetectFunctionFault(line, rule.Maximum, std::string(rule.Name) + " of the haptic property",
        DescribeRange(rule), std::string("vtkHapticProperty::Get") + rule.Name + "()");
    if (!error.empty())
    {
      return false;
    }
    rule.Baked == &HapticMaterial::Distinctness ? ScaleSlopes(property, line)
                                                : ToScalars(property, line);
  }
  return true;
}

/** Bakes the volume property's opacities as visibility masks of the material. */
void BakeVisibility(vtkHapticProperty* property, vtkImageData* image, HapticMaterial& material)
{
  vtkVolumeProperty* const volume = property->GetVisibilityFrom();
  if (!volume)
  {
    return;
  }
  constexpr int mostComponents = 4; // as many as vtkVolumeProperty supports
  const int component =
    volume->GetIndependentComponents() ? std::min(property->GetComponent(), mostComponents - 1) : 0;
  const double* const spacing = image->GetSpacing();
  const double average = (std::abs(spacing[0]) + std::abs(spacing[1]) + std::abs(spacing[2])) / 3.0;
  material.ScalarVisibility = MaskAbove(ToPolyline(volume->GetScalarOpacity(component), 1.0));
  // Use nearest samples only for labels: nearest is VTK's default, so for other scalars the user
  // need not have chosen it.
  material.IsSeenByNearest =
    property->GetScalarsAreLabels() && volume->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  // Check before getting a function, because getting a missing one would create it, and mappers
  // would then draw with it.
  if (volume->HasGradientOpacity(component))
  {
    material.GradientVisibility =
      MaskAbove(ToPolyline(volume->GetGradientOpacity(component), 1.0), 0.0, 1.0 / average);
  }
}

/**
 * Derives the distinctness from the noise if the user enables that and has set no Distinctness
 * function. Otherwise converts a Distinctness that is given per millimetre to world units.
 */
void BakeDistinctness(vtkHapticProperty* property, vtkImageData* image, vtkDataArray* scalars,
  int component, const WholeFacts& whole, double metersPerWorldUnit, HapticModelDescription& d)
{
  Polyline ramp;
  if (property->GetDistinctnessFromNoise() && property->GetDistinctness()->GetSize() == 0)
  {
    const double noise =
      whole.IsThere ? whole.Noise : EstimateImageNoise(image, scalars, d.View, component).Noise;
    ramp = MakeNoiseRamp(noise, BakedVolume::MakeKernel(d), d.IndexToWorld);
  }
  if (!ramp.empty())
  {
    d.Material.Distinctness = ramp;
    d.Material.IsDistinctFromNoise = true;
  }
  else if (property->GetDistinctnessPerMillimeter())
  {
    // The factor is exactly 1 for a world in millimetres.
    const double millimetersPerUnit = metersPerWorldUnit / 1e-3;
    for (Vertex& vertex : d.Material.Distinctness)
    {
      vertex.X *= millimetersPerUnit;
    }
  }
  property->NoteNoiseRamp(ramp.empty() ? 0.0 : ramp.front().X, ramp.empty() ? 0.0 : ramp.back().X);
}

/** Removes the surface strength of the background, if the image shows where the background ends. */
void BakeSolid(vtkHapticProperty* property, vtkImageData* image, vtkDataArray* scalars,
  int component, const WholeFacts& whole, HapticModelDescription& d)
{
  if (!property->GetSolidFromImage() || d.Settings.Side != SurfaceSide::Higher)
  {
    return;
  }
  const BackgroundLevel solid =
    whole.IsThere ? whole.Solid : EstimateSolid(image, scalars, d.View, component);
  if (solid.IsThere)
  {
    // Cut up to a little above the threshold, which noise grains of the background reach.
    d.Material.SurfaceStrength =
      CutBelow(d.Material.SurfaceStrength, solid.Full, 2.0 * solid.Full - solid.Threshold);
  }
}

/** Makes the missing isosurfaces of all time steps except the last one. */
void MeshTimeSteps(const std::vector<ImageTimeStep>& read, double value,
  const Affine3& indexToWorld, std::vector<VolumeTimeStep>& timeSteps)
{
  for (std::size_t i = 0; i + 1 < timeSteps.size(); ++i)
  {
    if (!timeSteps[i].Mesh)
    {
      timeSteps[i].Mesh =
        MeshTimeStep(timeSteps[i], timeSteps[i + 1], read[i].Component, value, indexToWorld);
    }
  }
}

/**
 * Returns the mesh with the most triangles among all time steps. Returns null, with an error, if
 * none has a triangle.
 */
std::shared_ptr<const SurfaceMesh> FindLargestMesh(
  const std::vector<VolumeTimeStep>& timeSteps, double value, std::string& error)
{
  std::shared_ptr<const SurfaceMesh> largest;
  for (const VolumeTimeStep& timeStep : timeSteps)
  {
    const std::int64_t most = largest ? largest->GetNumberOfTriangles() : 0;
    largest =
      timeStep.Mesh && timeStep.Mesh->GetNumberOfTriangles() > most ? timeStep.Mesh : largest;
  }
  if (!largest)
  {
    std::ostringstream message;
    message << "There is no isosurface at the IsoValue " << value
            << " of vtkVolumeHapticsFilter in any frame of the image on input port 0. "
               "SetIsoValue() to a value between its scalars.";
    error = message.str();
  }
  return largest;
}

/** Bakes the mesh and the proxy's radius if the method touches a mesh. */
bool BakeSurface(vtkImageData* image, vtkDataArray* scalars, int component,
  const HapticModelOptions& options, HapticModelDescription& d, std::string& error)
{
  d.Settings.HasIsoSurface = d.Settings.Method == HapticMethod::LocalSurface;
  if (d.Settings.Method != HapticMethod::SurfaceProxy)
  {
    return true;
  }
  if (d.Settings.ProxyRadius == 0.0)
  {
    d.Settings.ProxyRadius = 0.5 * SmallestSpacing(image);
  }
  d.Settings.HasIsoSurface = options.Surface == nullptr;
  if (!d.TimeSteps.empty())
  {
    MeshTimeSteps(options.TimeSteps, d.Settings.IsoValue, d.IndexToWorld, d.TimeSteps);
  }
  const std::int64_t* const first = d.View.First;
  const IsoSurface iso = { image, scalars, component, d.Settings.IsoValue,
    { static_cast<int>(first[0]), static_cast<int>(first[1]), static_cast<int>(first[2]) },
    !ResidentBox(d.View).IsWhole() };
  d.Mesh = d.TimeSteps.empty() ? options.Surfaces->Get(options.Surface, iso, d.IndexToWorld, error)
                               : FindLargestMesh(d.TimeSteps, d.Settings.IsoValue, error);
  if (!d.Mesh)
  {
    return false;
  }
  const int touched = d.Mesh->EstimateVisits(d.Settings.ProxyRadius);
  if (touched > MostTouched)
  {
    std::ostringstream message;
    message
      << "The ProxyRadius " << d.Settings.ProxyRadius
      << " of vtkVolumeHapticsFilter is too large for a surface as fine as this: a sphere of it "
         "may touch some "
      << touched / 2 << " of its triangles at once, and a tick has time for " << MostTouched / 2
      << ". Lower ProxyRadius, or connect a coarser surface to input port 2.";
    error = message.str();
    return false;
  }
  return true;
}

/**
 * Returns a shared pointer that owns a reference to the array. Create and release it outside the
 * servo's thread.
 */
std::shared_ptr<const void> ShareArray(vtkDataArray* array)
{
  array->Register(nullptr);
  return { static_cast<const void*>(array), [array](const void*) { array->UnRegister(nullptr); } };
}

/** Copies the component of an array that represents a time step. */
vtkSmartPointer<vtkDataArray> CopyComponent(const ImageTimeStep& timeStep)
{
  auto copy = NewArray(timeStep.Array->GetDataType(), 1, timeStep.Array->GetNumberOfTuples());
  copy->SetName(timeStep.Array->GetName());
  copy->CopyComponent(0, timeStep.Array, timeStep.Component);
  return copy;
}

bool AreAlike(const VolumeView& a, const VolumeView& b)
{
  return std::equal(a.Dimensions, a.Dimensions + 3, b.Dimensions) &&
    std::equal(a.First, a.First + 3, b.First) && std::equal(a.Whole, a.Whole + 3, b.Whole);
}

bool BakeTimeSteps(const HapticModelOptions& options, HapticModelDescription& d, std::string& error)
{
  const std::vector<ImageTimeStep>& timeSteps = options.TimeSteps;
  if (!timeSteps.empty() && d.Settings.Method == HapticMethod::SurfaceProxy && options.Surface)
  {
    error = "The surface on input port 2 does not move, and the image on input port 0 has several "
            "frames. Disconnect the surface to touch the isosurface at IsoValue, which moves, or "
            "stop time with SetTimeUnitsPerSecond(0).";
    return false;
  }
  if (!timeSteps.empty() && d.Settings.Method == HapticMethod::Primitives)
  {
    error =
      "PRIMITIVES feels vectors of one time, and the image on input port 0 has several frames. "
      "Choose another method, or stop time with SetTimeUnitsPerSecond(0).";
    return false;
  }
  // If the time steps are only a part of the series, the last one needs no displacements.
  TimeStepSeries series = d.Series;
  series.Last = timeSteps.empty() ? 0.0 : timeSteps.back().Time;
  series.First = timeSteps.empty() ? 0.0 : std::min(series.First, timeSteps.front().Time);
  const TimeStepShape shape{ d.View, d.IndexToWorld, series, d.KernelRadius, options.Displacements,
    options.Outside };
  for (const ImageTimeStep& timeStep : timeSteps)
  {
    d.TimeSteps.emplace_back();
    if (!MakeVolumeTimeStep(timeStep, shape, d.TimeSteps.back(), error))
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool MakeVolumeTimeStep(const ImageTimeStep& read, const TimeStepShape& shape,
  VolumeTimeStep& timeStep, std::string& error)
{
  HapticVolume volume;
  std::ostringstream message;
  if (!read.Array)
  {
    message << "The input image on input port 0 has no point array to touch at time " << read.Time
            << ". Give all time steps the same array.";
    error = message.str();
    return false;
  }
  // If the time steps are components of one array, copy only this component: filling a copy of the
  // array would copy all of them.
  const bool isAlone = !shape.Outside.HasAny() || read.Array->GetNumberOfComponents() == 1 ||
    read.Component >= read.Array->GetNumberOfComponents();
  const vtkSmartPointer<vtkDataArray> array =
    CopyFilled(shape.Outside, isAlone ? read.Array : CopyComponent(read), 0);
  const int component = isAlone ? read.Component : 0;
  if (!ReadVolume(read.Image, array, component, shape.KernelRadius, volume, error))
  {
    message << "At time " << read.Time << ": " << error;
    error = message.str();
    return false;
  }
  if (!AreAlike(volume.View, shape.View) || !IsIdentical(volume.IndexToWorld, shape.IndexToWorld))
  {
    const std::int64_t* const n = volume.View.Dimensions;
    message << "The input image at time " << read.Time << " has another geometry than at time "
            << shape.Series.First << " (" << n[0] << " x " << n[1] << " x " << n[2]
            << " points): all time steps need the same extent, origin, spacing and direction. "
               "Resample them to one geometry, for example with vtkImageReslice, or stop time "
               "with SetTimeUnitsPerSecond(0).";
    error = message.str();
    return false;
  }
  // Replace samples that are not numbers by the same value in all time steps.
  volume.View.BorderValue = shape.View.BorderValue;
  timeStep = { read.Time, volume.View, ShareArray(volume.Holder) };
  timeStep.Mesh = read.Mesh;
  const bool isMoved = read.Displacements || read.Time < shape.Series.Last;
  return shape.Displacements.empty() || !isMoved ||
    ReadDisplacements(read, shape.Displacements, timeStep, error);
}

std::shared_ptr<const BakedVolume> GoOnWithTimeSteps(const BakedVolume& last,
  const std::vector<ImageTimeStep>& timeSteps, const TimeStepSeries& series, int kernelRadius,
  const std::string& displacements, const OutsideSamples& outside)
{
  const ImageTimeStep& first = timeSteps.front();
  const VolumeView& before = last.Field.GetView();
  HapticVolume volume;
  std::string error;
  if (!first.Array ||
    !ReadVolume(first.Image, first.Array, first.Component, kernelRadius, volume, error))
  {
    return nullptr;
  }
  const VolumeView& now = volume.View;
  bool isAlike = now.Type == before.Type && IsIdentical(volume.IndexToWorld, last.IndexToWorld);
  for (int axis = 0; axis < 3; ++axis)
  {
    isAlike = isAlike && now.Border(axis) == before.Border(axis) &&
      now.Dimensions[axis] >= PointsNeeded(kernelRadius);
  }
  volume.View.BorderValue = before.BorderValue;
  const TimeStepShape shape{ now, volume.IndexToWorld, series, kernelRadius, displacements,
    outside };
  std::vector<VolumeTimeStep> made(timeSteps.size());
  for (std::size_t i = 0; i < timeSteps.size(); ++i)
  {
    if (!isAlike || !MakeVolumeTimeStep(timeSteps[i], shape, made[i], error))
    {
      return nullptr; // baking again will report the reason
    }
  }
  if (last.Mesh)
  {
    MeshTimeSteps(timeSteps, last.Settings.IsoValue, last.IndexToWorld, made);
  }
  return std::make_shared<const BakedVolume>(last, made, series);
}

std::shared_ptr<const HapticModel> BuildHapticModel(vtkImageData* image, vtkDataArray* scalars,
  vtkHapticProperty* property, const HapticModelOptions& options, std::string& notice,
  std::string& error)
{
  HapticModelDescription d = options.Description;
  HapticVolume volume;
  const int component =
    options.TimeSteps.empty() ? property->GetComponent() : options.TimeSteps.front().Component;
  if (!ReadVolume(image, scalars, component, d.KernelRadius, volume, error))
  {
    return nullptr;
  }
  EstimateShift(property, image, scalars, volume, component, notice);
  if (!BakeFunctions(property, d.Material, error))
  {
    return nullptr;
  }
  const WholeFacts& whole = volume.Whole;
  d.View = volume.View;
  d.ResidentShare = whole.Share;
  d.Series = options.Series;
  d.IndexToWorld = volume.IndexToWorld;
  const std::int64_t* const n = d.View.Dimensions;
  const std::int64_t needed = PointsNeeded(d.KernelRadius);
  if (std::min({ n[0], n[1], n[2] }) < needed)
  {
    std::ostringstream message;
    message << "The kernel is larger than the input image: a KernelRadius of " << d.KernelRadius
            << " needs " << needed << " points along every axis, and the image is " << n[0] << " x "
            << n[1] << " x " << n[2] << ". Lower KernelRadius or use a larger image"
            << (ResidentBox(d.View).IsWhole() ? "." : ", here a larger region of the volume.");
    error = message.str();
    return nullptr;
  }
  if (options.Cut)
  {
    const int* const extent = whole.IsThere ? whole.Extent : image->GetExtent();
    d.Cut = options.Cut->Make(image, extent, d.IndexToWorld, error);
  }
  if (!error.empty())
  {
    return nullptr;
  }
  BakeVisibility(property, image, d.Material);
  d.Samples = ShareArray(volume.Holder);
  for (const PropertySetting& setting : PropertySettings)
  {
    if (setting.Bake)
    {
      setting.Bake(property, d);
    }
  }
  if (!BakeTimeSteps(options, d, error) ||
    !BakeSurface(image, scalars, component, options, d, error))
  {
    return nullptr;
  }
  if (d.Settings.Method == HapticMethod::Primitives &&
    !DescribeModes(options.Modes, image, d.View, d.Modes, error))
  {
    return nullptr;
  }
  if (!DescribeTool(options.Tool, property, d, error))
  {
    return nullptr;
  }
  if (options.Removal)
  {
    const int* const extent = whole.IsThere ? whole.Extent : image->GetExtent();
    if (!DescribeRemoval(
          options.Removal, image, extent, scalars, component, whole.IsThere, d, error))
    {
      return nullptr;
    }
  }
  BakeDistinctness(property, image, scalars, component, whole, options.MetersPerWorldUnit, d);
  BakeSolid(property, image, scalars, component, whole, d);
  if (!d.TimeSteps.empty())
  {
    // Use the copy of the first step, because the source may write the next step to the image's
    // memory.
    d.View = d.TimeSteps.front().View;
    d.Samples = d.TimeSteps.front().Samples;
  }
  const std::string array =
    std::to_string(component) + (scalars->GetName() ? scalars->GetName() : "");
  d.Number = options.Regions ? options.Regions->Find(d, whole, array) : 0;
  auto model = std::make_shared<const HapticModel>(d);
  if (options.Regions)
  {
    options.Regions->Record(d, whole, array, model->Baked->Number);
  }
  return model;
}

} // namespace VolumeHaptics
