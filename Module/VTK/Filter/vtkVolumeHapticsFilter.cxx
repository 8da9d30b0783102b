// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVolumeHapticsFilter.h"

#include "VTK/Baking/ArrayHash.h"
#include "VTK/Baking/HapticCut.h"
#include "VTK/Baking/HapticFrames.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/TouchedArray.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Filter/BakePreparation.h"
#include "VTK/Filter/FilterFrames.h"
#include "VTK/Filter/FilterSources.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/RegionSeries.h"
#include "VTK/Filter/ResampledInput.h"
#include "VTK/Regions/RegionsAlongPath.h"
#include "VTK/Tools/ShareArrays.h"
#include "VTK/Trace/HapticTrace.h"
#include "VTK/Trace/Paths/TipPaths.h"
#include "VTK/Trace/Paths/TipPathsWalk.h"
#include "VTK/Trace/RecordedLabels.h"
#include "VTK/Trace/RecordingNames.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticMode.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticRemoval.h"
#include "vtkHapticTool.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>
#include <utility>

namespace
{
/** Whether this is a piece after the first one, which makes the whole trace. */
bool IsLaterPiece(vtkInformationVector* outputs)
{
  vtkInformation* const output = outputs->GetInformationObject(0);
  return output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
}
} // namespace

vtkStandardNewMacro(vtkVolumeHapticsFilter);
vtkCxxSetSmartPointerMacro(vtkVolumeHapticsFilter, LabelTable, vtkHapticLabelTable);

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter::vtkVolumeHapticsFilter()
  : Preparation(new VolumeHaptics::BakePreparation(this))
  , Resampled(new VolumeHaptics::ResampledInput)
  , MotionWarning(new VolumeHaptics::FastMotionWarning)
  , Regions(new VolumeHaptics::RegionSeries)
  , Hashes(new VolumeHaptics::ArrayHash[2])
  , Removal(vtkSmartPointer<vtkHapticRemoval>::New())
  , Cut(new VolumeHaptics::HapticCut)
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
vtkHapticLabelTable* vtkVolumeHapticsFilter::GetLabelTable()
{
  return this->LabelTable;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetRemoval(vtkHapticRemoval* removal)
{
  if (!removal)
  {
    this->SetRemoval(vtkNew<vtkHapticRemoval>());
  }
  else if (this->Removal != removal)
  {
    this->Removal = removal;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticRemoval* vtkVolumeHapticsFilter::GetRemoval()
{
  return this->Removal;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetClippingPlanes(vtkPlaneCollection* planes)
{
  if (this->Cut->Planes != planes)
  {
    this->Cut->Planes = planes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPlaneCollection* vtkVolumeHapticsFilter::GetClippingPlanes()
{
  return this->Cut->Planes;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::AddClippingPlane(vtkPlane* plane)
{
  if (plane && !this->Cut->Planes)
  {
    this->SetClippingPlanes(vtkNew<vtkPlaneCollection>());
  }
  if (plane && !this->Cut->Planes->IsItemPresent(plane))
  {
    this->Cut->Planes->AddItem(plane);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::RemoveClippingPlane(vtkPlane* plane)
{
  if (this->Cut->Planes && this->Cut->Planes->IsItemPresent(plane))
  {
    this->Cut->Planes->RemoveItem(plane);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::RemoveAllClippingPlanes()
{
  this->SetClippingPlanes(nullptr);
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCropping(bool cropping)
{
  if (this->Cut->Cropping != cropping)
  {
    this->Cut->Cropping = cropping;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::GetCropping()
{
  return this->Cut->Cropping;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCroppingRegionPlanes(const double planes[6])
{
  if (!std::equal(planes, planes + 6, this->Cut->RegionPlanes))
  {
    std::copy(planes, planes + 6, this->Cut->RegionPlanes);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCroppingRegionPlanes(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const double planes[6] = { xmin, xmax, ymin, ymax, zmin, zmax };
  this->SetCroppingRegionPlanes(planes);
}

//------------------------------------------------------------------------------
double* vtkVolumeHapticsFilter::GetCroppingRegionPlanes()
{
  return this->Cut->RegionPlanes;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetCroppingRegionFlags(int flags)
{
  if (this->Cut->RegionFlags != flags)
  {
    this->Cut->RegionFlags = flags;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::GetCroppingRegionFlags()
{
  return this->Cut->RegionFlags;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::SetFeelCutFaces(bool feel)
{
  if (this->Cut->HasSolidFaces != feel)
  {
    this->Cut->HasSolidFaces = feel;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkVolumeHapticsFilter::GetFeelCutFaces()
{
  return this->Cut->HasSolidFaces;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVolumeHapticsFilter::GetMTime()
{
  const vtkMTimeType time =
    std::max({ this->Superclass::GetMTime(), this->Cut->GetMTime(), this->Removal->GetMTime() });
  return this->LabelTable ? std::max(time, this->LabelTable->GetMTime()) : time;
}

//------------------------------------------------------------------------------
vtkHapticRegionSource* vtkVolumeHapticsFilter::GetRegionSource()
{
  if (auto* const source = vtkHapticRegionSource::SafeDownCast(this->GetInputAlgorithm(0, 0)))
  {
    return source;
  }
  std::vector<std::string> arrays;
  const char* const name = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  arrays.emplace_back(name ? name : "");
  for (vtkHapticMode* const mode : this->Modes)
  {
    const bool isFelt = this->Method == PRIMITIVES && mode->GetActive();
    arrays.push_back(isFelt ? mode->GetArrayName() : std::string());
  }
  return this->Resampled->Find(this->GetInputDataObject(0, 0), std::move(arrays));
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
int vtkVolumeHapticsFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    // Data sets are allowed, too, and composite ones as a whole: see GetTouchedImage().
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 3 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::HashScalars()
{
  return this->Hashes[0].Get(VolumeHaptics::HapticBaker(this).GetTouched()[0]);
}

//------------------------------------------------------------------------------
std::string vtkVolumeHapticsFilter::HashLabels()
{
  return this->Hashes[1].Get(VolumeHaptics::HapticBaker(this).GetTouched()[1]);
}

//------------------------------------------------------------------------------
int vtkVolumeHapticsFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;

  if (VolumeHaptics::AreTimeStepsFelt(this) &&
    !VolumeHaptics::ReadTimeSteps(inputs[0]->GetInformationObject(0)).empty())
  {
    // The trace runs through all time steps, so it has none itself.
    outputs->GetInformationObject(0)->Remove(Pipeline::TIME_STEPS());
    outputs->GetInformationObject(0)->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
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
    if (input->Has(Pipeline::WHOLE_EXTENT()))
    {
      constexpr int none[] = { 0, -1, 0, -1, 0, -1 };
      input->Set(
        Pipeline::UPDATE_EXTENT(), isFirst ? input->Get(Pipeline::WHOLE_EXTENT()) : none, 6);
      input->Set(Pipeline::EXACT_EXTENT(), 0);
    }
    if (port == 0 && VolumeHaptics::AreTimeStepsFelt(this))
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
    vtkErrorMacro(<< this->Resampled->DescribeFault(this->GetInputDataObject(0, 0)));
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
int vtkVolumeHapticsFilter::TouchPath(
  vtkImageData* image, vtkPolyData* path, vtkPolyData* output, vtkIdType& ticks)
{
  using namespace VolumeHaptics;

  std::string error;
  const double period = 1.0 / this->ServoRate;
  TipPaths paths;
  const bool readable =
    !path || (paths.Read(path, period, error) && (!this->Tool || paths.ReadHand(path, error)));
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
  if (VolumeHaptics::AreTimeStepsFelt(this))
  {
    HapticBaker(this).WarnOfStillSteps();
  }
  const RegionsAlongPath regions(source,
    [&](vtkImageData* region, std::string& flaw) {
      return HapticBaker(this).BakeImage(region, period, ForceCaps{}, nullptr, flaw, nullptr, {});
    });
  HapticFrames frames;
  if (path && readable && !source && !CollectFramesOfPaths(this, paths, frames, error))
  {
    vtkErrorMacro(<< error);
    return 0;
  }
  // Without a path, only the input is checked, and a slow mesh is left to the background.
  if (readable && !source && frames.Frames.empty() &&
    !(path ? this->Preparation->AwaitSurface() : this->Preparation->IsSurfaceAtHand()))
  {
    return 1;
  }
  std::string imageError;
  std::shared_ptr<const HapticModel> model = source
    ? regions.Begin()
    : HapticBaker(this).BakeImage(image, recording ? recording->TickPeriod : period, ForceCaps{},
        nullptr, imageError, recording ? path : nullptr, std::move(frames));
  if (!model || !readable)
  {
    error = model ? error : imageError;
    vtkErrorMacro(<< Printable(error));
    return 0;
  }

  if (model->Baked->IsMoving())
  {
    HapticBaker(this).WarnOfFastMotion(*model->Baked, true);
  }
  if (path && !FindLabelHash(path).empty())
  {
    const std::string hash = this->Hashes[1].Await(VolumeHaptics::HapticBaker(this).GetTouched()[1],
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
  if (const auto* const shares = walk.GetFinalShares())
  {
    AddShareArrays(*shares, FinalShareNames, output->GetFieldData());
  }
  // Ticks of a recording are points of the path, one for one, unless the user aborted the run.
  vtkDataArray* const orientations =
    recording ? path->GetPointData()->GetArray(RecordingNames::Orientation) : nullptr;
  if (orientations && !output->GetPointData()->HasArray(RecordingNames::Orientation) &&
    output->GetNumberOfPoints() == orientations->GetNumberOfTuples())
  {
    output->GetPointData()->AddArray(orientations);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkVolumeHapticsFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Cut->Print(os, indent);
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
