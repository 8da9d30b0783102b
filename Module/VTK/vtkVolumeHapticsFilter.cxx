// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsFilter.h"

#include "VTK/Baking/ArrayHash.h"
#include "VTK/Baking/HapticBaker.h"
#include "VTK/Baking/HapticFrames.h"
#include "VTK/Baking/HapticLabels.h"
#include "VTK/Baking/HapticModelBuilder.h"
#include "VTK/Baking/HapticNoise.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Baking/HapticSettingLists.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Baking/HapticVolume.h"
#include "VTK/Baking/RegionSeries.h"
#include "VTK/Baking/SurfaceRegion.h"
#include "VTK/Baking/TouchedArray.h"
#include "VTK/Baking/WholeFacts.h"
#include "VTK/Files/HapticFiles.h"
#include "VTK/Large/RegionsAlongPath.h"
#include "VTK/Trace/HapticTrace.h"
#include "VTK/Trace/RecordedLabels.h"
#include "VTK/Trace/RecordingNames.h"
#include "VTK/Trace/TipPaths.h"
#include "VTK/Trace/TipPathsWalk.h"
#include "vtkVolumeHapticsCompat.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>
#include <sstream>
#include <utility>

namespace
{
/** Whether another piece makes the trace. */
bool IsLaterPiece(vtkInformationVector* outputs)
{
  vtkInformation* const output = outputs->GetInformationObject(0);
  return output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
}

/** Memory ran out in the source of an input port. */
struct SourceLacksMemory : std::bad_alloc
{
  explicit SourceLacksMemory(int port)
    : Port(port)
  {
  }
  const int Port;
};

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
             "SURFACE_PROXY "
             "takes the most.";
  return message.str();
}

/** Runs the sources of the image, the surface and the labels; false if one of them failed. */
bool UpdateSources(vtkAlgorithm* filter)
{
  bool hasRun = true;
  for (const int port : { 0, 2, 3 }) // the servo does not use the path on port 1
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

double FindLastDataTime(const VolumeHaptics::RecordedPath& recording)
{
  return *std::max_element(recording.DataTimes.begin(), recording.DataTimes.end());
}

/** If a recording went on from the last frame to the first one, the first one follows again. */
void AddLoop(
  const VolumeHaptics::RecordedPath& recording, std::vector<VolumeHaptics::HapticFrame>& frames)
{
  if (!frames.empty() && FindLastDataTime(recording) > frames.back().Time)
  {
    const VolumeHaptics::HapticFrame first = frames.front();
    frames.push_back(first);
  }
}

/// If a source threw, VTK's executive thinks that it still runs, and refuses it from then on.
const char* const FailedSource = " A source of this filter failed: see its errors. If memory ran "
                                 "out in it before, VTK can't run it again: connect a "
                                 "new source.";
} // namespace

vtkStandardNewMacro(vtkVolumeHapticsFilter);

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter::vtkVolumeHapticsFilter()
  : Surfaces(new VolumeHaptics::HapticSurface)
  , Regions(new VolumeHaptics::RegionSeries)
  , Labels(new VolumeHaptics::HapticLabels)
  , Hashes(new VolumeHaptics::ArrayHash[2])
{
  this->SetNumberOfInputPorts(4);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  this->SetInputArrayToProcess(
    1, 3, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter::~vtkVolumeHapticsFilter() = default;

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetPathData(vtkPolyData* path)
{
  this->SetInputDataInternal(1, path);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputDataInternal(2, surface);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetLabelData(vtkImageData* labels)
{
  this->SetInputDataInternal(3, labels);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetLabelTable(vtkHapticLabelTable* table)
{
  if (this->LabelTable != table)
  {
    this->LabelTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticLabelTable* vtkVolumeHapticsFilter::GetLabelTable()
{
  return this->LabelTable;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeHapticsFilter::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->LabelTable ? std::max(time, this->LabelTable->GetMTime()) : time;
}

//------------------------------------------------------------------------------
vtkHapticRegionSource* vtkVolumeHapticsFilter::GetRegionSource()
{
  if (auto* const source = vtkHapticRegionSource::SafeDownCast(this->GetInputAlgorithm(0, 0)))
  {
    return source;
  }
  vtkDataObject* const data = this->GetInputDataObject(0, 0);
  const bool isSet = vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data);
  if (!isSet || vtkImageData::SafeDownCast(data))
  {
    this->Resampled = {};
    return nullptr;
  }
  std::vector<std::string> arrays;
  const char* const name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  arrays.emplace_back(name ? name : "");
  for (vtkHapticMode* const mode : this->Modes)
  {
    const bool isFelt = this->Method == PRIMITIVES && mode->GetActive();
    arrays.push_back(isFelt ? mode->GetArrayName() : std::string());
  }
  arrays.erase(std::remove(arrays.begin(), arrays.end(), std::string()), arrays.end());
  auto& now = this->Resampled;
  if (now.Of != data || now.Time != data->GetMTime() || now.Arrays != arrays)
  {
    now = { vtkSmartPointer<vtkHapticRegionSource>::New(), data, data->GetMTime(), arrays, {} };
    if (!now.Source->OpenDataSet(data, 0.0, arrays, now.Error))
    {
      now.Source = nullptr;
    }
  }
  return now.Source;
}

//------------------------------------------------------------------------------
vtkImageData* vtkVolumeHapticsFilter::GetTouchedImage()
{
  vtkImageData* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  vtkHapticRegionSource* const source = this->GetRegionSource();
  if (source && source != this->GetInputAlgorithm(0, 0))
  {
    source->UseSettingsOf(this);
    source->Update();
    return source->GetOutput();
  }
  return image;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::DescribeLackOfImage()
{
  vtkDataObject* const data = this->GetInputDataObject(0, 0);
  if (!this->Resampled.Error.empty())
  {
    return VolumeHaptics::Printable(this->Resampled.Error);
  }
  return data ? std::string("A ") + data->GetClassName() +
      " can't be touched. Connect a vtkImageData, or a data set with cells, to input port 0."
              : "There is no image to touch. Connect a vtkImageData to input port 0.";
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    // Also data sets, and composite ones as a whole: see GetTouchedImage.
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 3 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::ReadPlacement(
  vtkMatrix4x4* deviceToWorld, VolumeHaptics::Affine3& placement, std::string& error)
{
  if (deviceToWorld)
  {
    return VolumeHaptics::ReadSimilarity(deviceToWorld, placement, error);
  }
  placement = VolumeHaptics::ScaledPlacement(this->MetersPerWorldUnit);
  return true;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::BakeLabels(
  std::shared_ptr<const VolumeHaptics::BakedLabels>& labels, std::string& error)
{
  vtkImageData* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(3, 0));
  if (!image && this->Method == PROXY && this->Geometry != FROM_SCALARS)
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
  vtkDataArray* const array = this->GetInputArrayToProcess(1, image, association);
  if (!array || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    const char* const name = this->GetInputArrayInformation(1)->Get(vtkDataObject::FIELD_NAME());
    error = (name ? "The label image on input port 3 has no numeric point array \"" +
                  std::string(name) + "\"."
                  : std::string("The label image on input port 3 has no point scalars.")) +
      " Give its point data active scalars, or name a numeric point array with "
      "SetInputArrayToProcess(1, 3, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name).";
    return false;
  }
  labels = this->Labels->Get(image, array, this->LabelTable, error);
  return labels != nullptr;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::AreLabels(vtkImageData* image)
{
  VolumeHaptics::WholeFacts whole;
  std::string error; // BuildHapticModel reports it
  return this->GetProperty()->GetScalarsAreLabels() && this->Method == PROXY &&
    this->Geometry == FROM_SCALARS && !this->GetInputDataObject(3, 0) &&
    VolumeHaptics::ReadWholeFacts(image, 0, whole, error) && !whole.IsThere;
}

//------------------------------------------------------------------------------
std::shared_ptr<const VolumeHaptics::HapticModel> vtkVolumeHapticsFilter::BakeImage(
  vtkImageData* image, double tickPeriod, const VolumeHaptics::ForceCaps& deviceCaps,
  vtkMatrix4x4* deviceToWorld, std::string& error, vtkPolyData* recording,
  VolumeHaptics::HapticFrames&& frames)
{
  using namespace VolumeHaptics;

  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* scalars = this->GetInputArrayToProcess(0, image, association);
  if (!scalars && this->Method == PRIMITIVES)
  {
    // Modes need no scalars; only the array Value has these.
    scalars = FindModeArray(this->Modes, image);
  }
  if (!scalars || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    const char* const name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
    error = (name ? "The input image has no numeric point array \"" + std::string(name) + "\"."
                  : std::string("The input image has no point scalars to touch.")) +
      " Give its point data active scalars, or name a numeric point array with "
      "SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name).";
    return nullptr;
  }
  HapticModelOptions options;
  error = this->CheckSettings(1.0 / tickPeriod);
  if (!error.empty() ||
    !this->ReadPlacement(deviceToWorld, options.Description.DeviceToWorld, error) ||
    !this->BakeLabels(options.Description.Labels, error))
  {
    return nullptr;
  }
  for (const FilterSetting& setting : FilterSettings)
  {
    if (setting.Bake)
    {
      setting.Bake(this, options.Description);
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
  if (frames.Frames.empty() && this->AreLabels(image))
  {
    options.Description.Labels = this->Labels->GetOfScalars(image, scalars, this->GetProperty());
    options.Description.Settings.Geometry =
      options.Description.Labels ? SurfaceGeometry::Labels : SurfaceGeometry::Scalars;
  }
  options.Description.Settings.TickPeriod = tickPeriod;
  options.Description.Settings.Caps.Stiffness = this->MaximumStiffness;
  options.Description.DeviceCaps = deviceCaps;
  options.Surfaces = this->Surfaces.get();
  options.Regions = this->Regions.get();
  options.Frames = std::move(frames.Frames);
  options.Series = frames.Series;
  options.Displacements = this->DisplacementArrayName;
  options.Modes = this->Modes;
  options.Surface = vtkPolyData::SafeDownCast(this->GetInputDataObject(2, 0));
  return BuildHapticModel(image, scalars, this->GetProperty(), options, error);
}

//------------------------------------------------------------------------------
const char* vtkVolumeHapticsFilter::PrepareBake()
{
  const bool hasLabels = this->LabelTable && this->GetInputDataObject(3, 0);
  const bool hasMesh = this->Method == SURFACE_PROXY;
  if (!hasLabels)
  {
    this->Labels->EndPreparing();
  }
  if (!hasMesh)
  {
    this->Surfaces->EndPreparing();
  }
  if (hasLabels || hasMesh)
  {
    try
    {
      UpdateSources(this);
    }
    catch (const std::bad_alloc&)
    {
      return nullptr; // Bake() reports it
    }
  }
  const bool areLabelsReady = !hasLabels || this->PrepareLabels();
  const bool isMeshReady = !hasMesh || this->PrepareSurface();
  return !areLabelsReady ? "the distances to forbidden labels are measured"
    : !isMeshReady       ? VolumeHaptics::MeshingWork
                         : nullptr;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::PrepareLabels()
{
  vtkImageData* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(3, 0));
  vtkDataArray* const labels = image ? this->GetInputArrayToProcess(1, image) : nullptr;
  return !labels || this->Labels->Prepare(image, labels, this->LabelTable);
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::PrepareSurface()
{
  vtkImageData* const image = this->GetTouchedImage();
  vtkDataArray* const scalars = image ? this->GetInputArrayToProcess(0, image) : nullptr;
  const int component = this->GetProperty()->GetComponent();
  VolumeHaptics::HapticVolume volume;
  std::string error;
  if (!scalars ||
    !VolumeHaptics::ReadVolume(image, scalars, component, this->KernelRadius, volume, error))
  {
    return true; // Bake() reports what can't be read
  }
  const std::int64_t* const first = volume.View.First;
  return this->Surfaces->Prepare(vtkPolyData::SafeDownCast(this->GetInputDataObject(2, 0)),
    { image, scalars, component, this->IsoValue,
      { static_cast<int>(first[0]), static_cast<int>(first[1]), static_cast<int>(first[2]) },
      volume.Whole.IsThere },
    volume.IndexToWorld);
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::IsSurfaceAtHand()
{
  return this->Method != SURFACE_PROXY || this->PrepareSurface();
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::AwaitSurface()
{
  constexpr double piece = 0.02; // s
  while (!this->IsSurfaceAtHand())
  {
    if (!this->Surfaces->WaitFor(piece))
    {
      this->UpdateProgress(0.0);
    }
    if (VolumeHaptics::MustAbort(this))
    {
      this->Surfaces->EndPreparing();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::shared_ptr<const VolumeHaptics::HapticModel> vtkVolumeHapticsFilter::BakeRegion(
  const VolumeHaptics::SurfaceRegion& part, double rate, const VolumeHaptics::ForceCaps& deviceCaps,
  vtkMatrix4x4* deviceToWorld)
{
  try
  {
    std::string error;
    vtkDataArray* const scalars = part.Image->GetPointData()->GetScalars();
    this->Surfaces->Give(
      { part.Image, scalars, this->GetProperty()->GetComponent(), this->IsoValue }, part.Mesh);
    return this->BakeImage(part.Image, 1.0 / rate, deviceCaps, deviceToWorld, error, nullptr, {});
  }
  catch (const std::bad_alloc&)
  {
    return nullptr; // the whole tells
  }
}

//------------------------------------------------------------------------------
double vtkVolumeHapticsFilter::EstimateBakeTime()
{
  if (this->Method != SURFACE_PROXY)
  {
    return 0.0;
  }
  try
  {
    UpdateSources(this);
  }
  catch (const std::bad_alloc&)
  {
    return 0.0; // Bake() reports it
  }
  vtkImageData* const image = this->GetTouchedImage();
  vtkDataArray* const scalars = image ? this->GetInputArrayToProcess(0, image) : nullptr;
  if (!scalars)
  {
    return 0.0; // Bake() reports the error
  }
  return this->Surfaces->EstimateTime(vtkPolyData::SafeDownCast(this->GetInputDataObject(2, 0)),
    { image, scalars, this->GetProperty()->GetComponent(), this->IsoValue });
}

//------------------------------------------------------------------------------
std::shared_ptr<const VolumeHaptics::HapticModel> vtkVolumeHapticsFilter::Bake(double rate,
  const VolumeHaptics::ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld,
  VolumeHaptics::HapticFrames&& frames)
{
  try
  {
    return this->BakeInput(rate, deviceCaps, deviceToWorld, std::move(frames));
  }
  catch (const SourceLacksMemory& lack)
  {
    vtkErrorMacro("There is not enough memory for the source of input port "
      << lack.Port
      << " to run. VTK can't run it again after this, not even with more memory: connect a new "
         "source, "
      << "of a smaller image or of a region of it.");
    return nullptr;
  }
  catch (const std::bad_alloc&)
  {
    vtkImageData* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
    vtkErrorMacro(<< DescribeLackOfMemory(image));
    return nullptr;
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const VolumeHaptics::HapticModel> vtkVolumeHapticsFilter::BakeInput(double rate,
  const VolumeHaptics::ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld,
  VolumeHaptics::HapticFrames&& frames)
{
  const bool isMoving = !frames.Frames.empty();
  std::string error;
  if (auto* const source = vtkHapticRegionSource::SafeDownCast(this->GetInputAlgorithm(0, 0)))
  {
    source->UseSettingsOf(this);
  }
  const char* const hint = UpdateSources(this) ? "" : FailedSource;
  vtkDataObject* const surface = this->GetInputDataObject(2, 0);
  vtkImageData* const image = this->GetTouchedImage();
  if (!image)
  {
    vtkErrorMacro(<< this->DescribeLackOfImage() << hint);
    return nullptr;
  }
  // If only the device has moved, as it does with every frame while it follows the camera, or holds
  // more or less than before, the baked volume is shared.
  vtkDataArray* const scalars = this->GetInputArrayToProcess(0, image);
  vtkImageData* const labels = vtkImageData::SafeDownCast(this->GetInputDataObject(3, 0));
  vtkDataArray* const labelArray = labels ? this->GetInputArrayToProcess(1, labels) : nullptr;
  const auto getTime = [&]
  {
    return std::max({ this->GetMTime(), image->GetMTime(), scalars ? scalars->GetMTime() : 0,
      surface ? surface->GetMTime() : 0, labels ? labels->GetMTime() : 0,
      labelArray ? labelArray->GetMTime() : 0 });
  };
  VolumeHaptics::Affine3 placement;
  auto model = this->LastBaked.lock();
  const bool isCurrent = model && !isMoving && getTime() == this->LastBakedTime &&
    model->Baked->Settings.TickPeriod == 1.0 / rate;
  if (isCurrent && this->ReadPlacement(deviceToWorld, placement, error))
  {
    model = std::make_shared<const VolumeHaptics::HapticModel>(*model, placement, deviceCaps);
  }
  else if (error.empty())
  {
    model = this->BakeImage(
      image, 1.0 / rate, deviceCaps, deviceToWorld, error, nullptr, std::move(frames));
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< VolumeHaptics::Printable(error) << hint);
    return nullptr;
  }
  this->LastBaked = isMoving ? nullptr : model;
  // Afterwards: the first bake makes what the property lacks.
  this->LastBakedTime = getTime();
  return model;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::HashScalars()
{
  return this->Hashes[0].Get(this->GetTouched()[0]);
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::HashLabels()
{
  return this->Hashes[1].Get(this->GetTouched()[1]);
}

//------------------------------------------------------------------------------
std::array<VolumeHaptics::TouchedArray, 2> vtkVolumeHapticsFilter::GetTouched()
{
  std::array<VolumeHaptics::TouchedArray, 2> touched;
  constexpr int ports[] = { 0, 3 };
  for (int i = 0; i < 2; ++i)
  {
    vtkImageData* const image = i == 0
      ? this->GetTouchedImage()
      : vtkImageData::SafeDownCast(this->GetInputDataObject(ports[i], 0));
    if (vtkDataArray* const array = image ? this->GetInputArrayToProcess(i, image) : nullptr)
    {
      touched[i].Array = array;
      std::copy_n(image->GetDimensions(), 3, touched[i].Dimensions.begin());
      touched[i].Time = std::max(image->GetMTime(), array->GetMTime());
    }
  }
  return touched;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  if (this->FeelsMotion() &&
    !VolumeHaptics::ReadTimeSteps(inputs[0]->GetInformationObject(0)).empty())
  {
    // The trace goes through them; it has none.
    outputs->GetInformationObject(0)->Remove(Pipeline::TIME_STEPS());
    outputs->GetInformationObject(0)->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::FeelsMotion()
{
  return this->Frames == TIME_STEPS && this->TimeUnitsPerSecond != 0.0 &&
    this->GetNumberOfInputConnections(1) > 0;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  const bool isFirst = !IsLaterPiece(outputs);
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* const input = inputs[port]->GetInformationObject(0);
    if (!input)
    {
      continue;
    }
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), isFirst ? 1 : 0);
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if ((port == 0 || port == 3) && input->Has(Pipeline::WHOLE_EXTENT()))
    {
      constexpr int none[] = { 0, -1, 0, -1, 0, -1 };
      input->Set(
        Pipeline::UPDATE_EXTENT(), isFirst ? input->Get(Pipeline::WHOLE_EXTENT()) : none, 6);
      input->Set(Pipeline::EXACT_EXTENT(), 0);
    }
    if (port == 0 && this->FeelsMotion())
    {
      const std::vector<double> steps = VolumeHaptics::ReadTimeSteps(input);
      if (!steps.empty())
      {
        input->Set(Pipeline::UPDATE_TIME_STEP(), steps.front());
      }
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using namespace VolumeHaptics;

  vtkPolyData* const output = vtkPolyData::GetData(outputs);
  if (IsLaterPiece(outputs))
  {
    output->Initialize();
    return 1;
  }
  vtkImageData* const image = this->GetTouchedImage();
  if (!image)
  {
    vtkErrorMacro(<< this->DescribeLackOfImage());
    return 0;
  }
  vtkIdType ticks = 0;
  try
  {
    return this->TouchPath(image, vtkPolyData::GetData(inputs[1]), output, ticks);
  }
  catch (const RegionLost& lost)
  {
    output->Initialize();
    vtkErrorMacro(<< Printable(lost.what()));
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    vtkErrorMacro(<< (ticks > 0 ? DescribeLackOfMemory(ticks) : DescribeLackOfMemory(image)));
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::WarnOfFastMotion(
  vtkImageData* image, const VolumeHaptics::BakedVolume& volume)
{
  using namespace VolumeHaptics;

  vtkAlgorithm* const producer = this->GetInputAlgorithm(0, 0);
  const SeriesKey series = { producer, producer->GetMTime() };
  if (!this->DisplacementArrayName.empty() || this->LookedAt == series)
  {
    return;
  }
  this->LookedAt = series;
  vtkDataArray* const scalars = this->GetInputArrayToProcess(0, image);
  const int component = this->Frames == COMPONENTS ? 0 : this->GetProperty()->GetComponent();
  const double noise = FindNoise(image, scalars, volume.Field.GetView(), component).Noise;
  const std::string warning = DescribeFastMotion(volume, noise);
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::CollectComponents(std::vector<VolumeHaptics::HapticFrame>& frames)
{
  vtkImageData* const image = this->GetTouchedImage();
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const array = image ? this->GetInputArrayToProcess(0, image, association) : nullptr;
  if (!array || association != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return true; // BakeImage tells
  }
  const char* flaw = nullptr;
  if (array->GetNumberOfComponents() < 2)
  {
    flaw = " has one component, and the components are the frames (SetFramesToComponents). Give it "
           "one for each frame, for example with vtkNIFTIImageReader::TimeAsVectorOn(), or take "
           "SetFramesToTimeSteps().";
  }
  else if (!this->DisplacementArrayName.empty())
  {
    flaw = " has frames that are components (SetFramesToComponents), which have no displacements. "
           "Give them as time steps, or take SetDisplacementArrayName(\"\").";
  }
  if (flaw)
  {
    vtkErrorMacro("The input image's "
      << VolumeHaptics::Printable(VolumeHaptics::DescribeArray(array)) << flaw);
    return false;
  }
  frames = VolumeHaptics::MakeComponentFrames(image, array, this->FrameSpacing);
  return true;
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::CollectTimeSteps(
  const VolumeHaptics::TipPaths& paths, VolumeHaptics::HapticFrames& frames)
{
  using namespace VolumeHaptics;

  const RecordedPath* const recording = paths.GetRecording();
  const bool isMoving = recording && !recording->DataTimes.empty();
  if (recording && !isMoving)
  {
    return true;
  }
  if (this->Frames == COMPONENTS && this->TimeUnitsPerSecond != 0.0)
  {
    const bool areThere = this->CollectComponents(frames.Frames);
    if (isMoving)
    {
      AddLoop(*recording, frames.Frames);
    }
    return areThere;
  }
  const std::vector<double> steps =
    this->FeelsMotion() ? ReadTimeSteps(this->GetInputInformation(0, 0)) : std::vector<double>();
  if (steps.empty())
  {
    if (isMoving)
    {
      vtkErrorMacro("The recording on port 1 is of a volume that moves (it has the point array "
                    "DataTime), and the image on input port 0 does not. Connect the source of its "
                    "time steps, with a TimeUnitsPerSecond that is not 0.");
    }
    return !isMoving;
  }
  const double last = isMoving ? FindLastDataTime(*recording)
                               : steps.front() + this->TimeUnitsPerSecond * paths.FindLastTime();
  frames.Series = MakeSeries(steps);
  frames.Frames = CollectFrames(this, steps, last, HapticBaker(this).GetReading());
  if (isMoving)
  {
    AddLoop(*recording, frames.Frames);
  }
  if (frames.Frames.empty())
  {
    vtkErrorMacro("A time step of the image on input port 0 can't be read: see the errors of its "
                  "source. SetTimeUnitsPerSecond(0) takes one time step alone.");
  }
  return !frames.Frames.empty();
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::TouchPath(
  vtkImageData* image, vtkPolyData* path, vtkPolyData* output, vtkIdType& ticks)
{
  using namespace VolumeHaptics;

  std::string error;
  const double period = 1.0 / this->ServoRate;
  TipPaths paths;
  const bool readable = !path || paths.Read(path, period, error);
  const RecordedPath* const recording = paths.GetRecording();
  vtkHapticRegionSource* const source = this->GetRegionSource();
  if (source && (!path || !readable || recording))
  {
    error = recording ? "The path on port 1 is a recording, which can't be replayed through a "
                        "vtkHapticRegionSource: connect the whole image that it was made with."
                      : error;
    if (!error.empty())
    {
      vtkErrorMacro(<< Printable(error));
    }
    return error.empty() ? 1 : 0;
  }
  const RegionsAlongPath regions(source,
    [&](vtkImageData* region, std::string& flaw)
    { return this->BakeImage(region, period, ForceCaps{}, nullptr, flaw, nullptr, {}); });
  HapticFrames frames;
  if (path && readable && !source && !this->CollectTimeSteps(paths, frames))
  {
    return 0;
  }
  // Without a path, input is only checked, and a mesh that takes long is left to the background.
  if (readable && !source && frames.Frames.empty() &&
    !(path ? this->AwaitSurface() : this->IsSurfaceAtHand()))
  {
    return 1;
  }
  std::string imageError;
  std::shared_ptr<const HapticModel> model = source
    ? regions.Begin()
    : this->BakeImage(image, recording ? recording->TickPeriod : period, ForceCaps{}, nullptr,
        imageError, recording ? path : nullptr, std::move(frames));
  if (!model || !readable)
  {
    error = model ? error : imageError;
    vtkErrorMacro(<< Printable(error));
    return 0;
  }

  if (model->Baked->IsMoving())
  {
    this->WarnOfFastMotion(image, *model->Baked);
  }
  if (path && !FindLabelHash(path).empty())
  {
    const std::string hash = this->Hashes[1].Await(this->GetTouched()[1],
      [this](double)
      {
        this->UpdateProgress(0.0);
        return !MustAbort(this);
      });
    if (MustAbort(this))
    {
      return 1;
    }
    error = CompareLabels(path, hash);
    if (!error.empty())
    {
      vtkErrorMacro(<< error);
      return 0;
    }
  }

  ticks = paths.GetNumberOfTicks();
  HapticTrace trace(ticks, this->TraceArrays, *model->Baked);
  TipPathsWalk walk(paths, model, trace,
    source ? [&regions](auto felt, const ServoState& state, const Vector3& tip)
      { return regions.Find(std::move(felt), state, tip); }
           : ModelFinder());
  while (!walk.IsDone())
  {
    this->UpdateProgress(walk.GetProgress());
    if (MustAbort(this))
    {
      break;
    }
    walk.Advance();
    if (walk.GetFlaw() >= 0)
    {
      vtkErrorMacro("The recording on port 1 gives numbers that are not finite in tick "
        << walk.GetFlaw() << ": it was changed, or made with another volume. Record again.");
      return 0;
    }
  }
  trace.WriteTo(output, walk.GetRows(), paths.AreSeveral());
  // Ticks of a recording are points of the path, one for one, unless the user ended this.
  vtkDataArray* const orientations =
    recording ? path->GetPointData()->GetArray(RecordingNames::Orientation) : nullptr;
  if (orientations && output->GetNumberOfPoints() == orientations->GetNumberOfTuples())
  {
    output->GetPointData()->AddArray(orientations);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelTable: ";
  if (this->LabelTable)
  {
    os << "\n";
    this->LabelTable->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilterUpdate(vtkObjectBase* filter)
{
  if (auto* const haptics = vtkVolumeHapticsFilter::SafeDownCast(filter))
  {
    haptics->Update();
  }
}
