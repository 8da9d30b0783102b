// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/ModelSource.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Device/HapticLongWork.h"
#include "VTK/Device/Playback/HapticChangeTime.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/HapticMethods.h"
#include "VTK/Tools/RemovalAccess.h"

#include "vtkHapticDevice.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticRemoval.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

vtkSmartPointer<vtkHapticRegionSource> RegionSourceOf(vtkVolumeHapticsFilter* filter)
{
  return filter ? filter->GetRegionSource() : nullptr;
}

///@{
/**
 * Results of Prepare() for the status text, while time steps wait for their meshes or for earlier
 * time steps.
 */
constexpr char TimeStepMeshingWork[] = "the surfaces of the frames are meshed";
constexpr char TimeStepFeelingWork[] = "the frames before the new ones are felt to their end";
///@}

} // namespace

ModelSource::ModelSource(vtkHapticDevice* device, const DeviceSession& session)
  : Device(device)
  , Session(session)
  , Playback(session)
{
}

ModelSource::~ModelSource()
{
  this->LetRemovalsGo();
}

bool ModelSource::SetFilter(vtkVolumeHapticsFilter* filter)
{
  if (this->Filter == filter)
  {
    return false;
  }
  this->Filter = filter;
  this->MadeTime = 0;
  return true;
}

bool ModelSource::SetDeviceToWorld(vtkMatrix4x4* matrix)
{
  if (this->DeviceToWorld == matrix)
  {
    return false;
  }
  this->DeviceToWorld = matrix;
  return true;
}

std::string ModelSource::GetMethodText() const
{
  const TickCollector* const ticks = this->Session.GetTicks();
  const HapticModel* const model = ticks ? ticks->GetLatestModel() : nullptr;
  if (!model)
  {
    return this->Filter ? this->Filter->GetMethodText() : std::string();
  }
  const HapticSettings& settings = model->Baked->Settings;
  return GetMethodChoice(static_cast<int>(settings.Method), static_cast<int>(settings.Solver)).Text;
}

bool ModelSource::Make(double rate, std::shared_ptr<const HapticModel>& model)
{
  // Keep a reference, because observers of the work may set another filter on the device.
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->Filter;
  if (filter)
  {
    const bool isMoving = this->Playback.IsFelt(filter);
    const double seconds =
      isMoving ? this->Playback.EstimateTime() : filter->GetBaker().GetPreparation().EstimateTime();
    const LongWork work(
      this->Device, "the surface is meshed", this->Device->IsRunning() ? seconds : 0.0);
    const ForceCaps caps = this->Session.ComputeCaps(rate);
    const bool isCurrent = this->IsUpToDate();
    if (isMoving)
    {
      model = this->Playback.Make(filter, rate, caps, this->DeviceToWorld, isCurrent);
    }
    else
    {
      this->Playback.Forget();
      model = filter->GetBaker().Bake(rate, caps, this->DeviceToWorld);
    }
    model = this->FitToHand(std::move(model), caps);
    if (model && !this->HoldRemovalOf(*model, filter))
    {
      model = nullptr;
    }
    this->IsMadeOfTimeSteps = isMoving;
    this->MadeTime = this->IsBehind() ? 0 : ComputeChangeTime(filter, isMoving);
  }
  return !filter || model;
}

std::shared_ptr<const HapticModel> ModelSource::FitToHand(
  std::shared_ptr<const HapticModel> model, const ForceCaps& caps)
{
  if (!model || this->Device->GetUseTool() || (!model->Baked->Tool && !model->Baked->Removal))
  {
    this->WithTool = this->ForPoint = nullptr;
    return model;
  }
  // Cache both volumes, because the device is published in every frame while it follows the camera.
  if (this->WithTool != model->Baked)
  {
    this->WithTool = model->Baked;
    this->ForPoint = std::make_shared<const BakedVolume>(*model->Baked, BakedVolume::ForAPoint{});
  }
  return std::make_shared<const HapticModel>(this->ForPoint, model->DeviceToWorld, caps);
}

bool ModelSource::HoldRemovalOf(const HapticModel& model, vtkVolumeHapticsFilter* filter)
{
  vtkHapticRemoval* const removal = filter->GetRemoval();
  if (!model.Baked->Removal || model.Baked->Removal != GetTissueRemoval(removal))
  {
    return true;
  }
  if (!HoldRemoval(removal, this))
  {
    vtkErrorWithObjectMacro(this->Device,
      "Another vtkHapticDevice ticks with the removed tissue of this filter, and only one at a "
      "time can. Give the filter of this device one of its own with SetRemoval(nullptr), or Stop() "
      "the other device. UseToolOff() of this device lets its hand feel what the other one "
      "removes.");
    return false;
  }
  if (std::find(this->Held.begin(), this->Held.end(), removal) == this->Held.end())
  {
    this->Held.emplace_back(removal);
  }
  return true;
}

void ModelSource::LetRemovalsGo()
{
  for (vtkHapticRemoval* const removal : this->Held)
  {
    LetRemovalGo(removal, this);
  }
  this->Held.clear();
  this->WithTool = this->ForPoint = nullptr;
  this->Leads(nullptr);
}

bool ModelSource::Leads(vtkHapticRegionSource* source)
{
  if (this->Led && this->Led != source)
  {
    this->Led->LeaveLead(this);
    this->Led = nullptr;
  }
  if (source && source->TakeLead(this))
  {
    this->Led = source;
  }
  return this->Led;
}

void ModelSource::TakeLead()
{
  this->Leads(RegionSourceOf(this->Filter));
}

void ModelSource::LetUnusedRemovalsGo()
{
  const TickCollector* const ticks = this->Session.GetTicks();
  if (this->Held.empty() || !ticks || !ticks->IsLatestUsed())
  {
    return;
  }
  const HapticModel* const model = ticks->GetLatestModel();
  const auto unused = std::partition(this->Held.begin(), this->Held.end(),
    [model](vtkHapticRemoval* removal)
    { return model && model->Baked->Removal == GetTissueRemoval(removal); });
  const std::vector<vtkSmartPointer<vtkHapticRemoval>> released(unused, this->Held.end());
  this->Held.erase(unused, this->Held.end());
  for (vtkHapticRemoval* const removal : released)
  {
    LetRemovalGo(removal, this);
  }
}

const char* ModelSource::Prepare(double rate)
{
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->Filter;
  const bool isMoving = this->Playback.DetectFelt(filter);
  this->Awaited = filter ? filter->GetBaker().GetPreparation().Prepare(isMoving) : nullptr;
  if (!isMoving)
  {
    this->Playback.EndPreparing();
  }
  else if (!this->Playback.Prepare(filter, rate, this->IsUpToDate()) && !this->Awaited)
  {
    const bool hasMeshes = filter->GetMethod() == vtkVolumeHapticsFilter::SURFACE_PROXY;
    this->Awaited = hasMeshes ? TimeStepMeshingWork : TimeStepFeelingWork;
  }
  if (this->Awaited != MeshingWork)
  {
    this->Regions.End();
    this->ReportRegionMade();
  }
  return this->Awaited;
}

void ModelSource::ReportRegionMade()
{
  const std::int64_t time = std::exchange(this->RegionTime, 0);
  const vtkSmartPointer<vtkHapticRegionSource> source = RegionSourceOf(this->Filter);
  if (time > 0 && source && source == this->Led)
  {
    source->NoteUseTime(ServoClock::SecondsSince(time));
  }
}

std::shared_ptr<const HapticModel> ModelSource::MakeRegion(double rate)
{
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->Filter;
  if (this->Awaited != MeshingWork || !(this->Session.GetState().Time > 0.0))
  {
    return nullptr;
  }
  const std::optional<SurfaceRegion> region =
    this->Regions.Poll(filter, this->Session.GetLatest()->GetTipPosition());
  const ForceCaps caps = this->Session.ComputeCaps(rate);
  const std::shared_ptr<const HapticModel> model = region
    ? this->FitToHand(filter->GetBaker().BakeRegion(*region, rate, caps, this->DeviceToWorld), caps)
    : nullptr;
  return model && this->HoldRemovalOf(*model, filter) ? model : nullptr;
}

void ModelSource::EndPreparing()
{
  this->Regions.End();
  this->Playback.EndPreparing();
  if (this->Awaited && this->Filter)
  {
    this->Filter->GetBaker().GetPreparation().EndPreparing();
  }
  this->Awaited = nullptr;
}

bool ModelSource::PollRegion(std::string& status)
{
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->Filter;
  const vtkSmartPointer<vtkHapticRegionSource> source = RegionSourceOf(filter);
  if (!this->Leads(source))
  {
    // The region follows the tip of another device. The force fades outside of it.
    status = source ? "It feels the region around the other hand." : "";
    return source && this->Awaited != MeshingWork && !this->IsUpToDate();
  }
  // Publish the next region only once the surface in this one can be felt: otherwise each move of
  // the hand would cancel the meshing before it is done.
  vtkHapticState* const state = this->Session.GetLatest();
  bool hasCome = false;
  if (state->GetTime() > 0.0 && this->Awaited != MeshingWork)
  {
    filter->ConfigureSource(source);
    hasCome = source->Follow(state->GetTipPosition(), state->GetTime());
  }
  this->RegionTime = hasCome ? ServoClock::Now() : this->RegionTime;
  status = source->GetStatusText();
  return hasCome;
}

bool ModelSource::IsUpToDate() const
{
  return this->MadeTime == ComputeChangeTime(this->Filter, this->IsMadeOfTimeSteps);
}

std::shared_ptr<const HapticModel> ModelSource::PollTimeSteps()
{
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->Filter;
  std::shared_ptr<const HapticModel> model = this->Playback.Poll(filter);
  const auto isShown = [this](const FieldTimeStep& timeStep)
  { return timeStep.Samples.get() == this->Shown.GetArray(); };
  const bool hasShown =
    model && std::any_of(model->Baked->TimeSteps.begin(), model->Baked->TimeSteps.end(), isShown);
  if (model && !hasShown)
  {
    this->Shown.Clear(); // frees the memory of the shown model for the next one
  }
  return model;
}

bool ModelSource::LacksTimeSteps() const
{
  return !this->IsMadeOfTimeSteps && this->IsUpToDate() && this->Playback.IsFelt(this->Filter);
}

bool ModelSource::HasTimeSteps() const
{
  return this->Filter && this->Playback.GetShown(this->Filter).Array;
}

vtkImageData* ModelSource::GetTimeStepImage()
{
  auto* const shape =
    vtkImageData::SafeDownCast(this->Filter ? this->Filter->GetInputDataObject(0, 0) : nullptr);
  const ImageTimeStep timeStep = shape ? this->Playback.GetShown(this->Filter) : ImageTimeStep{};
  if (!timeStep.Array)
  {
    this->Shown.Clear();
    return nullptr;
  }
  const bool isComponent = this->Filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS;
  return this->Shown.Show(timeStep, isComponent, shape);
}

Affine3 ModelSource::GetPlacement() const
{
  const TickCollector* const ticks = this->Session.GetTicks();
  if (ticks && ticks->GetLatestModel())
  {
    return ticks->GetLatestModel()->DeviceToWorld;
  }
  Affine3 map;
  std::string error;
  if (!this->DeviceToWorld || !ReadSimilarity(this->DeviceToWorld, map, error))
  {
    map = ScaledPlacement(this->Filter ? this->Filter->GetMetersPerWorldUnit() : 1e-3);
  }
  return map;
}

} // namespace VolumeHaptics
