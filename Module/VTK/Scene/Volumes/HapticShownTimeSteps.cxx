// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Volumes/HapticShownTimeSteps.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

vtkImageData* GetGivenInput(vtkVolumeMapper* mapper)
{
  return mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
}

bool HasShapeOf(vtkImageData* image, vtkImageData* other)
{
  const double* const direction = image->GetDirectionMatrix()->GetData();
  return std::equal(image->GetExtent(), image->GetExtent() + 6, other->GetExtent()) &&
    std::equal(image->GetSpacing(), image->GetSpacing() + 3, other->GetSpacing()) &&
    std::equal(image->GetOrigin(), image->GetOrigin() + 3, other->GetOrigin()) &&
    std::equal(direction, direction + 9, other->GetDirectionMatrix()->GetData());
}

/**
 * Returns whether an array seems to be a component of another one. Compares only some samples,
 * which is enough to exclude, for example, a mask of the same shape.
 */
bool IsComponentOf(vtkDataArray* array, vtkDataArray* timeSteps)
{
  constexpr vtkIdType looks = 1000;
  const vtkIdType count = timeSteps ? timeSteps->GetNumberOfTuples() : 0;
  if (!array || array->GetNumberOfTuples() != count || count == 0 ||
    array->GetNumberOfComponents() != 1 || array->GetDataType() != timeSteps->GetDataType())
  {
    return false;
  }
  const vtkIdType step = count / looks + 1;
  for (int component = 0; component < timeSteps->GetNumberOfComponents(); ++component)
  {
    vtkIdType at = 0;
    while (at < count && array->GetComponent(at, 0) == timeSteps->GetComponent(at, component))
    {
      at += step;
    }
    if (at >= count)
    {
      return true;
    }
  }
  return false;
}

bool ShowsFelt(vtkImageData* shown, vtkImageData* felt, vtkDataArray* timeSteps)
{
  return HasSamplesOf(shown, felt) ||
    (timeSteps && HasShapeOf(shown, felt) &&
      IsComponentOf(shown->GetPointData()->GetScalars(), timeSteps));
}

} // namespace

bool HasSamplesOf(vtkImageData* shown, vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  return shown == image || (scalars && shown->GetPointData()->GetScalars() == scalars);
}

void HapticShownTimeSteps::Collect(vtkRenderer* renderer, vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  auto* const felt =
    filter ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0)) : nullptr;
  vtkDataArray* const timeSteps = felt && filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS
    ? filter->GetBaker().GetTouched()[0].Array
    : nullptr;
  std::vector<Shown> now;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    auto* const volume = vtkVolume::SafeDownCast(prop);
    auto* const mapper = volume ? vtkVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
    vtkImageData* const input = GetGivenInput(mapper);
    if (!input)
    {
      continue;
    }
    const auto known = std::find_if(this->All.begin(), this->All.end(),
      [mapper](const Shown& one) { return one.Mapper.GetPointer() == mapper; });
    const bool isKnown = known != this->All.end() &&
      (known->Picture ? known->Picture == input : known->Image == input);
    if (isKnown)
    {
      now.push_back(std::move(*known));
      known->Mapper = nullptr;
    }
    else if (felt && ShowsFelt(input, felt, timeSteps))
    {
      now.push_back({ volume, mapper, input, nullptr, nullptr });
    }
  }
  // Drop volumes that have left the scene or that show other data.
  this->Restore();
  this->All = std::move(now);
}

bool HapticShownTimeSteps::Show(vtkHapticDevice* device)
{
  if (this->All.empty())
  {
    return false;
  }
  vtkImageData* const timeStep = device->GetPlayback()->GetTimeStepImage();
  if (!timeStep)
  {
    this->Restore();
    return false;
  }
  vtkDataArray* const scalars = timeStep->GetPointData()->GetScalars();
  bool isNew = false;
  for (Shown& shown : this->All)
  {
    vtkVolumeMapper* const mapper = shown.Mapper;
    if (!mapper || (!shown.Picture && !shown.Image))
    {
      continue;
    }
    if (!shown.Picture)
    {
      shown.Before = mapper->GetInputAlgorithm(0, 0);
      shown.Port = mapper->GetInputConnection(0, 0)->GetIndex();
      shown.Picture = vtkSmartPointer<vtkImageData>::New();
      shown.Picture->CopyStructure(shown.Image);
    }
    if (shown.Picture->GetPointData()->GetScalars() != scalars)
    {
      shown.Picture->GetPointData()->SetScalars(scalars);
      shown.Picture->Modified();
      isNew = true;
    }
    if (GetGivenInput(mapper) != shown.Picture)
    {
      mapper->SetInputDataObject(0, shown.Picture);
    }
  }
  return isNew;
}

void HapticShownTimeSteps::Restore(Shown& shown)
{
  vtkVolumeMapper* const mapper = shown.Mapper;
  if (mapper && shown.Picture && GetGivenInput(mapper) == shown.Picture)
  {
    mapper->SetInputConnection(0, shown.Before->GetOutputPort(shown.Port));
  }
  shown.Picture = nullptr;
  shown.Before = nullptr;
}

void HapticShownTimeSteps::Restore()
{
  for (Shown& shown : this->All)
  {
    Restore(shown);
  }
}

bool HapticShownTimeSteps::IsPicture(vtkImageData* image) const
{
  return image &&
    std::any_of(this->All.begin(), this->All.end(),
      [image](const Shown& shown) { return shown.Picture == image; });
}

} // namespace VolumeHaptics
