// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/TouchedVolume.h"

#include "Core/Math/Vector3.h"
#include "VTK/Scene/WindowVolumes.h"

#include "vtkAlgorithmOutput.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkMatrix3x3.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

bool IsSamePlace(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(a->GetDirectionMatrix()->GetData(), a->GetDirectionMatrix()->GetData() + 9,
      b->GetDirectionMatrix()->GetData());
}

} // namespace

TouchedVolume::TouchedVolume() = default;
TouchedVolume::~TouchedVolume() = default;

vtkImageData* FindBinaryMask(vtkVolumeMapper* mapper)
{
  auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
  const bool hides = gpu && gpu->GetMaskType() == vtkGPUVolumeRayCastMapper::BinaryMaskType;
  return hides ? gpu->GetMaskInput() : nullptr;
}

bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed)
{
  constexpr double rounding = 1e-9;
  double origin[4] = { 0.0, 0.0, 0.0, 1.0 };
  std::copy(image->GetOrigin(), image->GetOrigin() + 3, origin);
  matrix->MultiplyPoint(origin, origin);
  Vector3 columns[3];
  double spacing[3];
  double direction[9];
  for (int axis = 0; axis < 3; ++axis)
  {
    double step[4] = { 0.0, 0.0, 0.0, 0.0 };
    for (int row = 0; row < 3; ++row)
    {
      step[row] = image->GetDirectionMatrix()->GetElement(row, axis) * image->GetSpacing()[axis];
    }
    matrix->MultiplyPoint(step, step);
    columns[axis] = { step[0], step[1], step[2] };
    spacing[axis] = Norm(columns[axis]);
    for (int row = 0; row < 3; ++row)
    {
      direction[3 * row + axis] = step[row] / spacing[axis];
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3;
    const double together = std::abs(Dot(columns[axis], columns[next]));
    // False for NaN, too.
    if (!(together <= rounding * spacing[axis] * spacing[next]) || !(spacing[axis] > 0.0))
    {
      return false;
    }
  }
  placed->SetOrigin(origin);
  placed->SetSpacing(spacing);
  placed->SetDirectionMatrix(direction);
  return true;
}

void MapCropping(vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6])
{
  mapper->GetCroppingRegionPlanes(planes);
  for (int i = 0; i < 6; ++i)
  {
    const int axis = i / 2;
    const double index = (planes[i] - shown->GetOrigin()[axis]) / shown->GetSpacing()[axis] -
      shown->GetExtent()[2 * axis] + felt->GetExtent()[2 * axis];
    planes[i] = felt->GetOrigin()[axis] + index * felt->GetSpacing()[axis];
  }
}

bool TouchedVolume::FindPlace(const std::vector<DrawnVolume>& drawn)
{
  const auto one = std::find_if(drawn.begin(), drawn.end(),
    [this](const DrawnVolume& candidate) { return candidate.Volume == this->Volume; });
  const bool isDrawn = one != drawn.end();
  this->Matrix->DeepCopy(isDrawn ? one->Matrix.Get() : this->Volume->GetMatrix());
  return isDrawn;
}

void TouchedVolume::Update(
  vtkVolumeHapticsFilter* filter, const HapticShownFrames& pictures, const CarvedPictures& carved)
{
  auto* const mapper =
    this->Volume ? vtkVolumeMapper::SafeDownCast(this->Volume->GetMapper()) : nullptr;
  vtkImageData* const shown = carved.FindImage(mapper);
  if (!shown)
  {
    return;
  }
  if (!pictures.IsPicture(shown))
  {
    this->Place(carved.FindInput(mapper), shown, filter);
  }
  if (filter->GetProperty()->GetVisibilityFrom() != this->Volume->GetProperty())
  {
    filter->GetProperty()->SetVisibilityFrom(this->Volume->GetProperty());
  }
  Crop(mapper, shown, filter);
  filter->SetClippingPlanes(mapper->GetClippingPlanes());
  this->Mask(mapper, filter);
}

void TouchedVolume::Place(
  vtkAlgorithmOutput* input, vtkImageData* shown, vtkVolumeHapticsFilter* filter)
{
  vtkNew<vtkImageData> place;
  place->SetExtent(shown->GetExtent());
  // What is sheared stays where its image is: the style warns of it.
  if (!PlaceImage(this->Matrix, shown, place) || IsSamePlace(place, shown))
  {
    if (filter->GetNumberOfInputConnections(0) == 0 || filter->GetInputConnection(0, 0) != input)
    {
      filter->SetInputConnection(0, input);
    }
    return;
  }
  const bool isOther = this->PlacedTime != shown->GetMTime();
  if (isOther)
  {
    this->Placed->ShallowCopy(shown);
    this->PlacedTime = shown->GetMTime();
  }
  if (isOther || !IsSamePlace(place, this->Placed))
  {
    PlaceImage(this->Matrix, shown, this->Placed);
  }
  if (filter->GetInputDataObject(0, 0) != this->Placed)
  {
    filter->SetInputData(0, this->Placed);
  }
}

void TouchedVolume::Crop(
  vtkVolumeMapper* mapper, vtkImageData* shown, vtkVolumeHapticsFilter* filter)
{
  vtkImageData* const felt = filter->GetTouchedImage();
  filter->SetCropping(mapper->GetCropping() != 0);
  if (felt && mapper->GetCropping())
  {
    double planes[6];
    MapCropping(mapper, shown, felt, planes);
    filter->SetCroppingRegionPlanes(planes);
    filter->SetCroppingRegionFlags(mapper->GetCroppingRegionFlags());
  }
}

void TouchedVolume::TakeBack(vtkVolumeHapticsFilter* filter)
{
  if (filter->GetInputDataObject(3, 0) == this->Labels)
  {
    filter->SetLabelData(nullptr);
    filter->SetLabelTable(nullptr);
  }
}

void TouchedVolume::Mask(vtkVolumeMapper* mapper, vtkVolumeHapticsFilter* filter)
{
  vtkImageData* const mask = FindBinaryMask(mapper);
  vtkImageData* const felt = filter->GetTouchedImage();
  vtkDataObject* const labels = filter->GetInputDataObject(3, 0);
  const bool isOurs = labels == this->Labels;
  // A mapper's mask has a voxel for each one of the image, whatever its own place.
  const bool fits = mask && felt &&
    std::equal(mask->GetDimensions(), mask->GetDimensions() + 3, felt->GetDimensions());
  if (!fits)
  {
    this->TakeBack(filter);
    return;
  }
  if (!isOurs && (labels || filter->GetLabelTable()))
  {
    return; // the style warns of it
  }
  const bool isOther = this->MaskImage != mask || this->MaskTime != mask->GetMTime();
  if (isOther || !IsSamePlace(this->Labels, felt) ||
    !std::equal(felt->GetExtent(), felt->GetExtent() + 6, this->Labels->GetExtent()))
  {
    this->Labels->ShallowCopy(mask);
    this->Labels->SetExtent(felt->GetExtent());
    this->Labels->SetOrigin(felt->GetOrigin());
    this->Labels->SetSpacing(felt->GetSpacing());
    this->Labels->SetDirectionMatrix(felt->GetDirectionMatrix());
    this->MaskImage = mask;
    this->MaskTime = mask->GetMTime();
  }
  if (!this->Unfelt)
  {
    this->Unfelt = vtkSmartPointer<vtkHapticLabelTable>::New();
    this->Unfelt->SetFelt(0, false);
  }
  if (!isOurs)
  {
    filter->SetLabelData(this->Labels);
    filter->SetLabelTable(this->Unfelt);
  }
}

} // namespace VolumeHaptics
