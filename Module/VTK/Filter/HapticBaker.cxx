// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/HapticBaker.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Baking/HapticCut.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/WholeFacts.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Filter/HapticModelBuilder.h"
#include "VTK/Trace/RecordedLabels.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMode.h"
#include "vtkHapticPointShell.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticRemoval.h"
#include "vtkHapticTool.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Returns the fault in the settings for a servo at this rate (Hz), with the cure; empty if the
 * settings are valid.
 */
std::string CheckSettings(vtkVolumeHapticsFilter* filter, double rate)
{
  for (const FilterSetting& setting : FilterSettings)
  {
    // Check the rate of the servo instead of the filter's setting.
    const bool isRate = std::string("ServoRate") == setting.Name;
    if (!std::isfinite(isRate ? rate : setting.Get(filter)))
    {
      return std::string("The setting ") + setting.Name +
        " of vtkVolumeHapticsFilter is not a finite number. Set" + setting.Name + "() to one.";
    }
  }
  return {};
}

} // namespace

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
  // Reuse the baked volume if only the device's caps or its placement have changed. The placement
  // changes in every frame while the device follows the camera.
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
  // Keep a weak reference to the volume, not to the model: a model that is baked only once would
  // take the volume with it.
  this->LastBaked = isMoving || !model ? nullptr : model->Baked;
  // Read the time after the bake, because the first bake creates the property's missing functions.
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
    // Modes work without scalars; only the trace's array Value reads them.
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
  error = CheckSettings(this->Filter, 1.0 / tickPeriod);
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
  std::string error; // ignored: BuildHapticModel() reports the error
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
    return nullptr; // baking the whole image will report the error
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
    filled.Array = nullptr; // Bake() will report the error
  }
  return filled;
}

//------------------------------------------------------------------------------
vtkHapticRegionSource* ResampledInput::Find(vtkDataObject* data, std::vector<std::string>&& arrays)
{
  const bool isSet = vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data);
  if (!isSet || vtkImageData::SafeDownCast(data))
  {
    *this = {};
    return nullptr;
  }
  arrays.erase(std::remove(arrays.begin(), arrays.end(), std::string()), arrays.end());
  if (this->Of != data || this->Time != data->GetMTime() || this->Arrays != arrays)
  {
    this->Source = vtkSmartPointer<vtkHapticRegionSource>::New();
    this->Of = data;
    this->Time = data->GetMTime();
    this->Arrays = std::move(arrays);
    this->Error.clear();
    if (!this->Source->OpenDataSet(data, 0.0, this->Arrays, this->Error))
    {
      this->Source = nullptr;
    }
  }
  return this->Source;
}

//------------------------------------------------------------------------------
std::string ResampledInput::DescribeFault(vtkDataObject* data) const
{
  if (!this->Error.empty())
  {
    return Printable(this->Error);
  }
  return data ? std::string("A ") + data->GetClassName() +
      " can't be touched. Connect a vtkImageData, or a data set with cells, to input port 0."
              : "There is no image to touch. Connect a vtkImageData to input port 0.";
}

//------------------------------------------------------------------------------
std::string ResampledInput::DescribeStillSteps(
  vtkDataObject* data, const std::vector<double>& steps)
{
  if (!data || steps.empty() || steps == this->ToldSteps)
  {
    return {};
  }
  this->ToldSteps = steps;
  std::ostringstream text;
  text << "The " << data->GetClassName() << " on port 0 has " << steps.size()
       << " time steps, of which only the first one, " << steps.front()
       << ", is felt: what is resampled around the tip stands still. For a volume that moves put "
          "vtkResampleToImage between source and filter, which gives an image of each step. Else "
          "choose one step: SetTimeUnitsPerSecond(0), and UpdateTimeStep().";
  return text.str();
}

//------------------------------------------------------------------------------
const char* BakePreparation::Prepare(bool isMoving)
{
  vtkVolumeHapticsFilter* const filter = this->Filter;
  const bool hasLabels = (filter->GetLabelTable() && filter->GetInputDataObject(3, 0)) ||
    (filter->GetProperty()->GetScalarsAreLabels() && !isMoving);
  const bool hasMesh = filter->GetMethod() == vtkVolumeHapticsFilter::SURFACE_PROXY && !isMoving;
  if (!hasLabels)
  {
    this->Labels.EndPreparing();
  }
  if (!hasMesh)
  {
    this->Surfaces.EndPreparing();
  }
  if (hasLabels || hasMesh)
  {
    try
    {
      UpdateSources(filter);
    }
    catch (const std::bad_alloc&)
    {
      return nullptr; // Bake() will report the error
    }
  }
  const char* const labels = hasLabels ? this->PrepareLabels() : nullptr;
  const bool isMeshReady = !hasMesh || this->PrepareSurface();
  const bool isToolReady = this->PrepareTool();
  return labels    ? labels
    : !isMeshReady ? MeshingWork
    : !isToolReady ? "the points of the tool are spread"
                   : nullptr;
}

//------------------------------------------------------------------------------
void BakePreparation::EndPreparing()
{
  this->Labels.EndPreparing();
  this->Surfaces.EndPreparing();
  this->Shells.EndPreparing();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> BakePreparation::FillOutside(
  vtkImageData* image, vtkDataArray* scalars, int component, bool areTimeSteps)
{
  const bool areScalars = areTimeSteps || AreScalars(scalars->GetNumberOfComponents());
  if (this->Filter->GetProperty()->GetScalarsAreLabels() || !areScalars)
  {
    this->Outside = OutsideFiller{};
    return scalars;
  }
  return this->Outside.Fill(image, scalars, component);
}

//------------------------------------------------------------------------------
bool BakePreparation::PrepareTool()
{
  auto* const shell = vtkHapticPointShell::SafeDownCast(this->Filter->GetTool());
  if (!shell)
  {
    this->Shells.EndPreparing();
  }
  return !shell || this->Shells.Prepare(shell->GetMesh(), shell->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
const char* BakePreparation::PrepareLabels()
{
  HapticBaker& baker = this->Filter->GetBaker();
  const std::array<TouchedArray, 2> touched = baker.GetTouched();
  vtkImageData* const image = vtkImageData::SafeDownCast(this->Filter->GetInputDataObject(3, 0));
  if (image && touched[1].Array && this->Filter->GetLabelTable())
  {
    return this->Labels.Prepare(
      image, touched[1].Array, this->Filter->GetLabelTable(), baker.HasLabelWalls());
  }
  vtkImageData* const scalars = this->Filter->GetTouchedImage();
  if (scalars && touched[0].Array && baker.AreLabels(scalars))
  {
    return this->Labels.PrepareScalars(scalars, touched[0].Array, this->Filter->GetProperty());
  }
  this->Labels.EndPreparing();
  return nullptr;
}

//------------------------------------------------------------------------------
bool BakePreparation::PrepareSurface()
{
  vtkImageData* const image = this->Filter->GetTouchedImage();
  const vtkSmartPointer<vtkDataArray> scalars = this->Filter->GetBaker().GetFilled().Array;
  const int component = this->Filter->GetProperty()->GetComponent();
  HapticVolume volume;
  std::string error;
  if (!scalars ||
    !ReadVolume(image, scalars, component, this->Filter->GetKernelRadius(), volume, error))
  {
    return true; // Bake() will report an image that can't be read
  }
  const std::int64_t* const first = volume.View.First;
  return this->Surfaces.Prepare(vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(2, 0)),
    { image, scalars, component, this->Filter->GetIsoValue(),
      { static_cast<int>(first[0]), static_cast<int>(first[1]), static_cast<int>(first[2]) },
      volume.Whole.IsThere },
    volume.IndexToWorld);
}

//------------------------------------------------------------------------------
bool BakePreparation::IsSurfaceAtHand()
{
  return this->Filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY ||
    this->PrepareSurface();
}

//------------------------------------------------------------------------------
bool BakePreparation::AwaitSurface()
{
  constexpr double piece = 0.02; // s
  while (!this->IsSurfaceAtHand())
  {
    if (!this->Surfaces.WaitFor(piece))
    {
      this->Filter->UpdateProgress(0.0);
    }
    if (MustAbort(this->Filter))
    {
      this->Surfaces.EndPreparing();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double BakePreparation::EstimateTime()
{
  if (this->Filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY)
  {
    return 0.0;
  }
  try
  {
    UpdateSources(this->Filter);
  }
  catch (const std::bad_alloc&)
  {
    return 0.0; // Bake() will report the error
  }
  vtkImageData* const image = this->Filter->GetTouchedImage();
  const vtkSmartPointer<vtkDataArray> scalars = this->Filter->GetBaker().GetFilled().Array;
  if (!scalars)
  {
    return 0.0; // Bake() will report the error
  }
  return this->Surfaces.EstimateTime(
    vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(2, 0)),
    { image, scalars, this->Filter->GetProperty()->GetComponent(), this->Filter->GetIsoValue() });
}

//------------------------------------------------------------------------------
bool UpdateSources(vtkAlgorithm* filter)
{
  bool hasRun = true;
  for (const int port : { 0, 2, 3 }) // all ports except the path on port 1
  {
    if (vtkAlgorithm* const source = filter->GetInputAlgorithm(port, 0))
    {
      try
      {
        const int output = filter->GetInputConnection(port, 0)->GetIndex();
        hasRun = source->GetExecutive()->Update(output) != 0 && hasRun;
      }
      catch (const std::bad_alloc&)
      {
        throw SourceLacksMemory(port);
      }
    }
  }
  return hasRun;
}

//------------------------------------------------------------------------------
std::string DescribeLackOfMemory(vtkImageData* image)
{
  std::ostringstream message;
  message << "There is not enough memory to make the image on input port 0 ready to be touched";
  if (image && image->GetNumberOfPoints() > 0)
  {
    const int* const n = image->GetDimensions();
    message << ": it is of " << n[0] << " x " << n[1] << " x " << n[2] << " points and takes "
            << image->GetActualMemorySize() / 1024 << " MiB itself";
  }
  message << ". Use a smaller image, or a region of it with vtkHapticRegionFilter; of the methods, "
             "SURFACE_PROXY takes the most.";
  return message.str();
}

} // namespace VolumeHaptics
