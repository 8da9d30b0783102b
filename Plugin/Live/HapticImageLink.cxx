// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticImageLink.h"

#include "HapticCropPlanes.h"
#include "HapticTimeStepLink.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCollection.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVHapticLargeFile.h"
#include "vtkPVVersion.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSISourceProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHapticsLive
{
namespace
{

vtkDataObject* DataOf(vtkAlgorithmOutput* output)
{
  return output ? output->GetProducer()->GetOutputDataObject(output->GetIndex()) : nullptr;
}

/**
 * Returns the time of the last change in the pipeline up to an output, not counting executions of
 * filters.
 */
vtkMTimeType PipelineTimeOf(vtkAlgorithmOutput* output)
{
  auto* const pipeline =
    vtkDemandDrivenPipeline::SafeDownCast(output->GetProducer()->GetExecutive());
  return pipeline ? pipeline->GetPipelineMTime() : 0;
}

bool HasGeometryOf(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin());
}

bool SharesArrays(vtkImageData* a, vtkImageData* b)
{
  vtkPointData* const arrays = a->GetPointData();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    const char* const name = arrays->GetArrayName(i);
    vtkAbstractArray* const other = name ? b->GetPointData()->GetAbstractArray(name) : nullptr;
    if (other && other == arrays->GetAbstractArray(i))
    {
      return true;
    }
  }
  return false;
}

/** Returns whether two times are consecutive time steps of an output, in either order. */
bool AreNeighbours(vtkAlgorithmOutput* output, double a, double b)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const info = output->GetProducer()->GetOutputInformation(output->GetIndex());
  if (!info->Has(Pipeline::TIME_STEPS()))
  {
    return false;
  }
  const double* const begin = info->Get(Pipeline::TIME_STEPS());
  const double* const end = begin + info->Length(Pipeline::TIME_STEPS());
  const double* const step = std::find(begin, end, std::min(a, b));
  return step != end && step + 1 != end && step[1] == std::max(a, b);
}

bool IsCropped(vtkSMProxy* representation)
{
  return representation && representation->GetProperty("UseCropping") &&
    representation->GetProperty("CroppingOrigin") && representation->GetProperty("CroppingScale") &&
    vtkSMPropertyHelper(representation, "UseCropping").GetAsInt() != 0;
}

bool IsOn(vtkSMProxy* proxy, const char* name)
{
  return proxy->GetProperty(name) && vtkSMPropertyHelper(proxy, name, true).GetAsInt() != 0;
}

std::string TextOf(vtkSMProxy* proxy, const char* name)
{
  const char* const text =
    proxy->GetProperty(name) ? vtkSMPropertyHelper(proxy, name, true).GetAsString() : nullptr;
  return text ? text : "";
}

/** Returns whether the opacity of an array with several components depends on this component. */
bool ShowsComponent(vtkSMProxy* representation, int component)
{
  vtkSMProxy* const colors = representation->GetProperty("LookupTable")
    ? vtkSMPropertyHelper(representation, "LookupTable", true).GetAsProxy()
    : nullptr;
  return colors && colors->GetProperty("VectorMode") && colors->GetProperty("VectorComponent") &&
    IsOn(representation, "MapScalars") && !IsOn(representation, "MultiComponentsMapping") &&
    vtkSMPropertyHelper(colors, "VectorMode", true).GetAsInt() == vtkScalarsToColors::COMPONENT &&
    vtkSMPropertyHelper(colors, "VectorComponent", true).GetAsInt() == component;
}

bool Shows(vtkSMProxy* representation, vtkVolumeHapticsFilter* filter)
{
  if (!IsOn(representation, "Visibility") || TextOf(representation, "Representation") != "Volume" ||
    IsOn(representation, "UseSeparateOpacityArray") || IsOn(representation, "UseTransfer2D") ||
    !representation->GetProperty("ColorArrayName"))
  {
    return false;
  }
  const vtkSMPropertyHelper color(representation, "ColorArrayName", true);
  const char* const shown = color.GetInputArrayNameToProcess();
  auto* const image = vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0));
  if (!shown || !*shown || !image ||
    color.GetInputArrayAssociation() != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    return false;
  }
  const char* const name = filter->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
  vtkPointData* const points = image->GetPointData();
  vtkDataArray* const touched = name && *name ? points->GetArray(name) : points->GetScalars();
  return touched && touched->GetName() && std::string(shown) == touched->GetName() &&
    (touched->GetNumberOfComponents() == 1 ||
      ShowsComponent(representation, filter->GetProperty()->GetComponent()));
}

vtkSMProxy* FindRepresentation(vtkSMProxy* view, vtkSMProxy* volume, vtkVolumeHapticsFilter* filter)
{
  const vtkSMPropertyHelper shown(view, "Representations", true);
  for (unsigned int i = 0; i < shown.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const representation = shown.GetAsProxy(i);
    if (representation && representation->GetProperty("Input") &&
      representation->GetProperty("ScalarOpacityFunction") &&
      vtkSMPropertyHelper(representation, "Input", true).GetAsProxy() == volume &&
      Shows(representation, filter))
    {
      return representation;
    }
  }
  return nullptr;
}

vtkPiecewiseFunction* GetOpacity(vtkSMProxy* representation)
{
  vtkSMProxy* const function =
    vtkSMPropertyHelper(representation, "ScalarOpacityFunction", true).GetAsProxy();
  return function ? vtkPiecewiseFunction::SafeDownCast(function->GetClientSideObject()) : nullptr;
}

} // namespace

vtkAlgorithmOutput* HapticImageLink::GetUpdatedOutput(vtkSMSourceProxy* source, unsigned int port)
{
  if (!source || !source->GetSession())
  {
    return nullptr;
  }
  source->UpdatePipeline();
  auto* const implementation =
    vtkSISourceProxy::SafeDownCast(source->GetSession()->GetSIObject(source->GetGlobalID()));
  return implementation ? implementation->GetOutputPort(static_cast<int>(port)) : nullptr;
}

bool HapticImageLink::IsSeen(vtkDataObject* data, vtkAlgorithm* filter) const
{
  return data == this->Seen && (data ? data->GetMTime() : 0) == this->SeenTime &&
    filter == this->SeenFilter;
}

void HapticImageLink::See(vtkDataObject* data, vtkAlgorithm* filter)
{
  this->Seen = data;
  this->SeenTime = data ? data->GetMTime() : 0;
  this->SeenFilter = filter;
}

void HapticImageLink::Forget()
{
  this->SeenFilter = nullptr;
}

void HapticImageLink::Update(
  vtkSMSourceProxy* source, unsigned int port, vtkAlgorithm* filter, int filterPort)
{
  vtkDataObject* const data = DataOf(GetUpdatedOutput(source, port));
  if (this->IsSeen(data, filter))
  {
    return;
  }
  this->See(data, filter);
  vtkSmartPointer<vtkDataObject> copy;
  if (data)
  {
    copy.TakeReference(data->NewInstance());
    copy->ShallowCopy(data);
  }
  filter->SetInputDataObject(filterPort, copy);
}

void HapticImageLink::PollTimeSteps(vtkSMSourceProxy* source, unsigned int port, double time,
  vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticTimeStepLink& timeSteps)
{
  vtkAlgorithmOutput* const output = GetUpdatedOutput(source, port);
  auto* const image = vtkImageData::SafeDownCast(DataOf(output));
  if (!image)
  {
    timeSteps.Clear();
    this->Update(source, port, filter, 0);
    return;
  }
  const vtkMTimeType pipelineTime = PipelineTimeOf(output);
  const bool isBegun = timeSteps.HasBegun(filter) && pipelineTime == this->PipelineTime &&
    HasGeometryOf(image, timeSteps.GetImage());
  if (isBegun && (this->IsSeen(image, filter) || !timeSteps.IsThere(device)))
  {
    return; // the new image is passed later, when the servo is ready for it
  }
  const bool isInPlace = isBegun && (this->IsInPlace || SharesArrays(image, timeSteps.GetImage()));
  vtkNew<vtkImageData> copy;
  isInPlace ? VolumeHaptics::CopyData(image, copy) : copy->ShallowCopy(image);
  this->See(image, filter);
  this->PipelineTime = pipelineTime;
  this->IsInPlace = isInPlace;
  // Displacements are valid only up to the next time step.
  const bool isStep =
    filter->GetDisplacementArrayName().empty() || AreNeighbours(output, timeSteps.GetTime(), time);
  if (isBegun && time != timeSteps.GetTime() && isStep)
  {
    timeSteps.Go(timeSteps.GetImage(), copy, time, device);
  }
  else
  {
    timeSteps.Begin(copy, time, filter, device);
  }
}

bool HapticLargeLink::Update(vtkAlgorithmOutput* output, vtkVolumeHapticsFilter* filter)
{
  vtkPVHapticLargeFile* const file = vtkPVHapticLargeFile::Find(output);
  if (!file)
  {
    this->Regions = nullptr;
    this->File = nullptr;
    return false;
  }
  if (file != this->File || filter != this->Filter || file->GetOpenTime() != this->OpenTime)
  {
    this->File = file;
    this->Filter = filter;
    this->OpenTime = file->GetOpenTime();
    this->Regions = file->MakeRegions();
    filter->SetInputConnection(0, this->Regions ? this->Regions->GetOutputPort() : nullptr);
  }
  return true;
}

void HapticCropLink::Update(vtkSMProxy* representation, vtkVolumeHapticsFilter* filter)
{
  vtkSMSourceProxy* volume = nullptr;
  unsigned int port = 0;
  if (IsCropped(representation))
  {
    const vtkSMPropertyHelper input(representation, "Input", true);
    volume = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    port = input.GetOutputPort();
  }
  if (!volume)
  {
    if (std::exchange(this->HasCropped, false))
    {
      filter->CroppingOff();
    }
    return;
  }
  double origin[3];
  double scale[3];
  vtkSMPropertyHelper(representation, "CroppingOrigin").Get(origin, 3);
  vtkSMPropertyHelper(representation, "CroppingScale").Get(scale, 3);
  vtkPVDataInformation* const data = volume->GetDataInformation(port);
  double planes[6];
  ComputeCropPlanes(ChooseCropBase(PARAVIEW_VERSION_MAJOR, PARAVIEW_VERSION_MINOR),
    data->GetBounds(), data->GetExtent(), origin, scale, planes);
  filter->SetCroppingRegionPlanes(planes);
  filter->CroppingOn();
  this->HasCropped = true;
}

vtkVolumeProperty* HapticOpacityLink::Find(vtkSMProxy* volume, vtkVolumeHapticsFilter* filter)
{
  this->View = nullptr;
  this->Representation = nullptr;
  vtkSMSessionProxyManager* const manager = volume ? volume->GetSessionProxyManager() : nullptr;
  if (!manager || !filter)
  {
    return nullptr;
  }
  std::vector<vtkSMProxy*> views;
  vtkSMProxySelectionModel* const active = manager->GetSelectionModel("ActiveView");
  if (vtkSMProxy* const view = active ? active->GetCurrentProxy() : nullptr)
  {
    views.push_back(view);
  }
  vtkNew<vtkCollection> others;
  manager->GetProxies("views", others);
  for (int i = 0; i < others->GetNumberOfItems(); ++i)
  {
    views.push_back(vtkSMProxy::SafeDownCast(others->GetItemAsObject(i)));
  }
  for (vtkSMProxy* const view : views)
  {
    vtkSMProxy* const representation = view && view->GetProperty("Representations")
      ? FindRepresentation(view, volume, filter)
      : nullptr;
    if (vtkPiecewiseFunction* const opacity = representation ? GetOpacity(representation) : nullptr)
    {
      this->View = view;
      this->Representation = representation;
      // Use this function for whichever component is touched.
      this->Property->IndependentComponentsOff();
      this->Property->SetScalarOpacity(opacity);
      return this->Property;
    }
  }
  return nullptr;
}

} // namespace VolumeHapticsLive
