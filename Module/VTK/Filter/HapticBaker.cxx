// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/HapticBaker.h"

#include "VTK/Baking/HapticCut.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/WholeFacts.h"
#include "VTK/Filter/FilterSources.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Filter/HapticModelBuilder.h"
#include "VTK/Trace/RecordedLabels.h"

#include "vtkDataSetAttributes.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMode.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticRemoval.h"
#include "vtkHapticTool.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <new>
#include <utility>

namespace VolumeHaptics
{

//------------------------------------------------------------------------------
std::shared_ptr<const HapticModel> HapticBaker::BakeOrTell(
  double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld, ImageTimeSteps&& timeSteps)
{
  try
  {
    return this->BakeInput(rate, deviceCaps, deviceToWorld, std::move(timeSteps));
  }
  catch (const SourceLacksMemory& lack)
  {
    vtkErrorWithObjectMacro(this->Filter,
      "There is not enough memory for the source of input port "
        << lack.Port
        << " to run. VTK can't run it again after this, not even with more memory: connect a new "
           "source, "
        << "of a smaller image or of a region of it.");
    return nullptr;
  }
  catch (const std::bad_alloc&)
  {
    vtkImageData* const image = vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(0, 0));
    vtkErrorWithObjectMacro(this->Filter, << DescribeLackOfMemory(image));
    return nullptr;
  }
}

//------------------------------------------------------------------------------
void HapticBaker::WarnOfFastMotion(const BakedVolume& volume, bool isLoop)
{
  const std::string warning = this->MotionWarning.Describe(this->Filter, volume, isLoop);
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << warning);
  }
}

//------------------------------------------------------------------------------
bool HapticBaker::IsResampled()
{
  vtkDataObject* const data = this->Filter->GetInputDataObject(0, 0);
  return data && !vtkImageData::SafeDownCast(data);
}

//------------------------------------------------------------------------------
void HapticBaker::WarnOfStillSteps()
{
  if (this->Filter->GetFrames() != vtkVolumeHapticsFilter::TIME_STEPS ||
    this->Filter->GetTimeUnitsPerSecond() == 0.0 || !this->IsResampled())
  {
    return;
  }
  const std::string warning = this->Resampled.DescribeStillSteps(
    this->Filter->GetInputDataObject(0, 0), ReadTimeSteps(this->Filter->GetInputInformation(0, 0)));
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << warning);
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const HapticModel> HapticBaker::BakeInput(
  double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld, ImageTimeSteps&& timeSteps)
{
  const bool isMoving = !timeSteps.TimeSteps.empty();
  std::string error;
  if (auto* const source =
        vtkHapticRegionSource::SafeDownCast(this->Filter->GetInputAlgorithm(0, 0)))
  {
    this->Filter->ConfigureSource(source);
  }
  const char* const hint = UpdateSources(this->Filter) ? "" : FailedSource;
  vtkDataObject* const surface = this->Filter->GetInputDataObject(2, 0);
  vtkImageData* const image = this->Filter->GetTouchedImage();
  if (!image)
  {
    vtkErrorWithObjectMacro(this->Filter,
      << this->Resampled.DescribeFault(this->Filter->GetInputDataObject(0, 0)) << hint);
    return nullptr;
  }
  // Reuse the baked volume if only the device's caps have changed or the device has moved, which it
  // does in every frame while it follows the camera.
  vtkDataArray* const scalars = this->GetArray(0, image);
  vtkImageData* const labels = vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(3, 0));
  vtkDataArray* const labelArray = labels ? this->GetArray(1, labels) : nullptr;
  const auto getTime = [&]
  {
    return std::max({ this->Filter->GetMTime(), image->GetMTime(),
      scalars ? scalars->GetMTime() : 0, surface ? surface->GetMTime() : 0,
      labels ? labels->GetMTime() : 0, labelArray ? labelArray->GetMTime() : 0 });
  };
  Affine3 placement;
  const std::shared_ptr<const BakedVolume> baked = this->LastBaked.lock();
  const bool isCurrent = baked && !isMoving && getTime() == this->LastBakedTime &&
    baked->Settings.TickPeriod == 1.0 / rate;
  std::shared_ptr<const HapticModel> model;
  if (isCurrent && this->ReadPlacement(deviceToWorld, placement, error))
  {
    model = std::make_shared<const HapticModel>(baked, placement, deviceCaps);
  }
  else if (error.empty())
  {
    model = this->BakeImage(
      image, 1.0 / rate, deviceCaps, deviceToWorld, error, nullptr, std::move(timeSteps));
  }
  if (!error.empty())
  {
    vtkErrorWithObjectMacro(this->Filter, << Printable(error) << hint);
    return nullptr;
  }
  // Keep the volume, not the model, because a model that is baked only once would take the volume
  // with it.
  this->LastBaked = isMoving || !model ? nullptr : model->Baked;
  // Get the time after the bake, because the first bake creates what the property lacks.
  this->LastBakedTime = getTime();
  return model;
}

//------------------------------------------------------------------------------
std::shared_ptr<const HapticModel> HapticBaker::BakeImage(vtkImageData* image, double tickPeriod,
  const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld, std::string& error,
  vtkPolyData* recording, ImageTimeSteps&& timeSteps)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->Filter->GetChosenArray(0, image, association);
  if (!scalars && this->Filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES)
  {
    // Modes need no scalars: only the array Value reads them.
    scalars = FindModeArray(this->Filter->GetModes(), image);
  }
  if (!scalars || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    const char* const name =
      this->Filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
    error = (name ? "The input image has no numeric point array \"" + std::string(name) + "\"."
                  : std::string("The input image has no point scalars to touch.")) +
      " Give its point data active scalars, or name a numeric point array with "
      "SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name).";
    return nullptr;
  }
  HapticModelOptions options;
  error = this->Filter->CheckSettings(1.0 / tickPeriod);
  if (!error.empty() ||
    !this->ReadPlacement(deviceToWorld, options.Description.DeviceToWorld, error) ||
    !this->BakeLabels(recording, options.Description.Labels, error))
  {
    return nullptr;
  }
  for (const FilterSetting& setting : FilterSettings)
  {
    if (setting.Bake)
    {
      setting.Bake(this->Filter, options.Description);
    }
  }
  if (recording && IsOlderThanMaterialPlacement(recording))
  {
    HapticSettings& settings = options.Description.Settings;
    settings.Placement = MaterialPlacement::Kernel;
    settings.Alignment = FindRecordedSetting(recording, "ContactAlignment: ") == "Edge"
      ? ContactAlignment::Edge
      : ContactAlignment::Distinctness;
  }
  if (timeSteps.TimeSteps.empty() && this->AreLabels(image))
  {
    options.Description.Labels = this->Preparation.GetLabels().GetOfScalars(
      image, scalars, this->Filter->GetProperty(), HasFineLabels(recording));
    options.Description.Settings.Geometry =
      options.Description.Labels ? SurfaceGeometry::Labels : SurfaceGeometry::Scalars;
  }
  const std::string warning = this->Preparation.GetLabels().DrainWarning();
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << warning);
  }
  options.Description.Settings.TickPeriod = tickPeriod;
  options.Description.Settings.Caps.Stiffness = this->Filter->GetMaximumStiffness();
  options.Description.DeviceCaps = deviceCaps;
  options.Surfaces = &this->Preparation.GetSurfaces();
  options.Regions = &this->Regions;
  options.TimeSteps = std::move(timeSteps.TimeSteps);
  options.Series = timeSteps.Series;
  options.Displacements = this->Filter->GetDisplacementArrayName();
  options.Modes = this->Filter->GetModes();
  options.Tool = this->Filter->GetTool();
  options.Removal = this->Filter->GetRemoval();
  options.Cut = this->Filter->GetCut();
  options.MetersPerWorldUnit = this->Filter->GetMetersPerWorldUnit();
  vtkDataObject* const surface = this->Filter->GetInputDataObject(2, 0);
  options.Surface = vtkPolyData::SafeDownCast(surface);
  if (surface && !options.Surface &&
    this->Filter->GetMethod() == vtkVolumeHapticsFilter::SURFACE_PROXY)
  {
    error = std::string("The surface (input port 2) is a ") + surface->GetClassName() +
      ", which has no triangles. Give it a vtkPolyData, or nothing: then the isosurface at the "
      "IsoValue is touched.";
    return nullptr;
  }
  const bool areTimeSteps = !options.TimeSteps.empty();
  const vtkSmartPointer<vtkDataArray> filled = this->Preparation.FillOutside(image, scalars,
    areTimeSteps ? options.TimeSteps.front().Component
                 : this->Filter->GetProperty()->GetComponent(),
    areTimeSteps && this->Filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS);
  options.Outside = filled != scalars ? this->GetOutside() : OutsideSamples{};
  const std::string notice = this->Preparation.GetOutside().DrainNotice();
  if (!notice.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << Printable(notice));
  }
  std::string guess;
  auto model = BuildHapticModel(image, filled, this->Filter->GetProperty(), options, guess, error);
  if (this->Preparation.IsNewGuess(guess))
  {
    vtkWarningWithObjectMacro(this->Filter, << Printable(guess));
  }
  return model;
}

//------------------------------------------------------------------------------
bool HapticBaker::BakeLabels(
  vtkPolyData* recording, std::shared_ptr<const BakedLabels>& labels, std::string& error)
{
  vtkImageData* const image = vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(3, 0));
  if (!image && this->Filter->GetMethod() == vtkVolumeHapticsFilter::PROXY &&
    this->Filter->GetGeometry() != vtkVolumeHapticsFilter::FROM_SCALARS)
  {
    error =
      "The geometry is to come from labels, and there is no label image. Connect one to input "
      "port 3 with SetLabelConnection, or call SetGeometryFromScalars.";
    return false;
  }
  if (!image)
  {
    return true;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const array = this->Filter->GetChosenArray(1, image, association);
  if (!array || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    const char* const name =
      this->Filter->GetInputArrayInformation(1)->Get(vtkDataObject::FIELD_NAME());
    error = (name ? "The label image on input port 3 has no numeric point array \"" +
                  std::string(name) + "\"."
                  : std::string("The label image on input port 3 has no point scalars.")) +
      " Give its point data active scalars, or name a numeric point array with "
      "SetInputArrayToProcess(1, 3, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name).";
    return false;
  }
  labels = this->Preparation.GetLabels().Get(image, array, this->Filter->GetLabelTable(),
    this->HasLabelWalls() && HasFineLabels(recording), error);
  return labels != nullptr;
}

//------------------------------------------------------------------------------
bool HapticBaker::HasLabelWalls()
{
  return this->Filter->GetLabelTable() &&
    this->Filter->GetGeometry() != vtkVolumeHapticsFilter::FROM_SCALARS;
}

//------------------------------------------------------------------------------
bool HapticBaker::AreLabels(vtkImageData* image)
{
  WholeFacts whole;
  std::string error; // BuildHapticModel() reports the error
  return this->Filter->GetProperty()->GetScalarsAreLabels() &&
    this->Filter->GetMethod() == vtkVolumeHapticsFilter::PROXY &&
    this->Filter->GetGeometry() == vtkVolumeHapticsFilter::FROM_SCALARS &&
    !this->Filter->GetInputDataObject(3, 0) && ReadWholeFacts(image, 0, whole, error) &&
    !whole.IsThere;
}

//------------------------------------------------------------------------------
bool HapticBaker::ReadPlacement(vtkMatrix4x4* deviceToWorld, Affine3& placement, std::string& error)
{
  if (deviceToWorld)
  {
    return ReadSimilarity(deviceToWorld, placement, error);
  }
  placement = ScaledPlacement(this->Filter->GetMetersPerWorldUnit());
  return true;
}

//------------------------------------------------------------------------------
std::shared_ptr<const HapticModel> HapticBaker::BakeRegion(
  const SurfaceRegion& part, double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld)
{
  try
  {
    std::string error;
    vtkDataArray* const scalars = part.Image->GetPointData()->GetScalars();
    this->Preparation.GetSurfaces().Give(
      { part.Image, scalars, this->Filter->GetProperty()->GetComponent(),
        this->Filter->GetIsoValue() },
      part.Mesh);
    return this->BakeImage(part.Image, 1.0 / rate, deviceCaps, deviceToWorld, error, nullptr, {});
  }
  catch (const std::bad_alloc&)
  {
    return nullptr; // baking the whole image reports the error
  }
}

//------------------------------------------------------------------------------
std::array<TouchedArray, 2> HapticBaker::GetTouched()
{
  std::array<TouchedArray, 2> touched;
  constexpr int ports[] = { 0, 3 };
  for (int i = 0; i < 2; ++i)
  {
    vtkImageData* const image = i == 0
      ? this->Filter->GetTouchedImage()
      : vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(ports[i], 0));
    if (vtkDataArray* const array = image ? this->GetArray(i, image) : nullptr)
    {
      touched[i].Array = array;
      std::copy_n(image->GetDimensions(), 3, touched[i].Dimensions.begin());
      touched[i].Time = std::max(image->GetMTime(), array->GetMTime());
    }
  }
  return touched;
}

//------------------------------------------------------------------------------
TouchedArray HapticBaker::GetFilled(int component, bool areTimeSteps)
{
  TouchedArray filled = this->GetTouched()[0];
  try
  {
    if (filled.Array)
    {
      filled.Array = this->Preparation.FillOutside(
        this->Filter->GetTouchedImage(), filled.Array, component, areTimeSteps);
    }
  }
  catch (const std::bad_alloc&)
  {
    filled.Array = nullptr; // Bake() reports the error
  }
  return filled;
}

} // namespace VolumeHaptics
