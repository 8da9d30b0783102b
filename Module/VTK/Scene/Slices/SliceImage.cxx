// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Slices/SliceImage.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticDevice.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkPointData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

struct FeltSamples
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Array = nullptr;
};

FeltSamples FindSliceSamples(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  if (!filter || filter->GetNumberOfInputConnections(0) == 0)
  {
    return {};
  }
  vtkImageData* image = device->HasFrames() ? device->GetFrameImage() : nullptr;
  if (auto* const large = vtkHapticRegionSource::SafeDownCast(filter->GetInputAlgorithm(0, 0)))
  {
    image = large->GetCoarseImage();
  }
  if (image)
  {
    return { image, image->GetPointData()->GetScalars() };
  }
  image = filter->GetTouchedImage();
  vtkDataArray* const array = image ? HapticBaker(filter).GetReading().GetArray(image) : nullptr;
  return { image, array };
}

} // namespace

//------------------------------------------------------------------------------
bool SliceImage::Follow(vtkHapticDevice* device, vtkImageData* chosen)
{
  FeltSamples felt =
    chosen ? FeltSamples{ chosen, chosen->GetPointData()->GetScalars() } : FindSliceSamples(device);
  if (!felt.Image || !felt.Array || felt.Array->GetNumberOfTuples() == 0 ||
    felt.Array->GetNumberOfTuples() != felt.Image->GetNumberOfPoints())
  {
    felt = {};
  }
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  const int components = felt.Array ? felt.Array->GetNumberOfComponents() : 1;
  const bool isMagnitude =
    components > 1 && filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES;
  const int wanted = filter ? filter->GetProperty()->GetComponent() : 0;
  const int component = std::min(wanted, components - 1);
  const vtkMTimeType time =
    felt.Array ? std::max(felt.Image->GetMTime(), felt.Array->GetMTime()) : 0;
  if (felt.Image == this->Image && felt.Array == this->Samples && time == this->Time &&
    isMagnitude == this->IsMagnitude && component == this->Component)
  {
    return false;
  }
  this->Image = felt.Image;
  this->Samples = felt.Array;
  this->Time = time;
  this->IsMagnitude = isMagnitude;
  this->Component = component;
  this->Plain->Initialize();
  if (felt.Image)
  {
    this->Plain->SetExtent(felt.Image->GetExtent());
    this->Plain->SetSpacing(felt.Image->GetSpacing());
    this->Plain->GetPointData()->SetScalars(felt.Array);
  }
  this->Layers = {};
  return true;
}

//------------------------------------------------------------------------------
bool SliceImage::FollowRemoval(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  auto* const large = filter && filter->GetNumberOfInputConnections(0) > 0
    ? vtkHapticRegionSource::SafeDownCast(filter->GetInputAlgorithm(0, 0))
    : nullptr;
  const bool isCoarse = large && this->Image && this->Image == large->GetCoarseImage();
  // While the data time runs, all tissue is felt.
  const bool isFelt = filter && !device->HasFrames() && this->Samples && !large &&
    filter->GetTouchedImage() && this->Samples == HapticBaker(filter).GetTouched()[0].Array;
  RemovedTissue removed = isCoarse || isFelt ? FindRemoved(filter) : RemovedTissue();
  if (removed.IsSame(this->Removed))
  {
    return false;
  }
  this->Removed = std::move(removed);
  this->Cover = isCoarse ? CarvedCover::Voxel : CarvedCover::Nearest;
  this->Layers = {};
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* SliceImage::GetLayer(int axis, int number)
{
  if (!this->IsCarved())
  {
    return this->Plain;
  }
  Layer& layer = this->Layers[axis];
  if (layer.Image && layer.Number == number)
  {
    return layer.Image;
  }
  int part[6];
  this->Image->GetExtent(part);
  number = std::clamp(number, part[2 * axis], part[2 * axis + 1]);
  part[2 * axis] = part[2 * axis + 1] = number;
  const auto left = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(this->Samples->GetDataType()));
  this->CopyLeftPart(part, left);
  layer.Number = number;
  layer.Image = vtkSmartPointer<vtkImageData>::New();
  layer.Image->SetExtent(part);
  layer.Image->SetSpacing(this->Image->GetSpacing());
  layer.Image->GetPointData()->SetScalars(left);
  return layer.Image;
}

//------------------------------------------------------------------------------
void SliceImage::CopyLeftPart(const int part[6], vtkDataArray* left) const
{
  vtkNew<vtkImageData> place;
  place->CopyStructure(this->Image);
  if (this->IsCarved() && this->Cover == CarvedCover::Nearest)
  {
    // The image is the volume, or a region of the volume, which may have been moved since.
    place->CopyStructure(this->Removed.Volume);
    place->SetExtent(this->Image->GetExtent());
  }
  CopyLeft(this->Removed, this->Cover, place, this->Samples, part, left);
}

//------------------------------------------------------------------------------
std::array<double, 3> SliceImage::Clamp(std::array<double, 3> index) const
{
  const int* const extent = this->Image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = std::clamp<double>(index[axis], extent[2 * axis], extent[2 * axis + 1]);
  }
  return index;
}

//------------------------------------------------------------------------------
std::array<double, 3> SliceImage::FindIndex(const double world[3]) const
{
  std::array<double, 3> index;
  this->Image->TransformPhysicalPointToContinuousIndex(world, index.data());
  return this->Clamp(index);
}

//------------------------------------------------------------------------------
void SliceImage::FindWorld(const std::array<double, 3>& index, double world[3]) const
{
  this->Image->TransformContinuousIndexToPhysicalPoint(index.data(), world);
}

//------------------------------------------------------------------------------
std::array<double, 3> SliceImage::GetCentre() const
{
  const int* const extent = this->Image->GetExtent();
  std::array<double, 3> centre;
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis] = 0.5 * (extent[2 * axis] + extent[2 * axis + 1]);
  }
  return centre;
}

//------------------------------------------------------------------------------
double SliceImage::GetValue(const std::array<double, 3>& index) const
{
  int part[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    part[2 * axis] = part[2 * axis + 1] = static_cast<int>(std::lround(index[axis]));
  }
  const auto left = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(this->Samples->GetDataType()));
  this->CopyLeftPart(part, left);
  return this->GetValueOf(left, 0);
}

//------------------------------------------------------------------------------
double SliceImage::GetValueOf(vtkDataArray* samples, vtkIdType id) const
{
  if (!this->IsMagnitude)
  {
    return samples->GetComponent(id, this->Component);
  }
  double sum = 0.0;
  for (int c = 0; c < samples->GetNumberOfComponents(); ++c)
  {
    const double part = samples->GetComponent(id, c);
    sum += part * part;
  }
  return std::sqrt(sum);
}

//------------------------------------------------------------------------------
std::string SliceImage::DescribeComponents() const
{
  const int count = this->Samples->GetNumberOfComponents();
  if (count == 1)
  {
    return {};
  }
  return this->IsMagnitude
    ? "magnitude "
    : "component " + std::to_string(this->Component + 1) + " of " + std::to_string(count) + ": ";
}

//------------------------------------------------------------------------------
std::array<double, 2> SliceImage::FindUsualValues() const
{
  constexpr vtkIdType most = 20000;
  constexpr double below = 0.01;
  constexpr double above = 0.995;
  const vtkIdType count = this->Samples->GetNumberOfTuples();
  // Use an odd step, so that it does not take the same column of each row.
  const vtkIdType step = (count / most) | 1;
  std::vector<double> values;
  for (vtkIdType i = 0; i < count; i += step)
  {
    const double value = this->GetValueOf(this->Samples, i);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  if (values.empty())
  {
    return { 0.0, 1.0 };
  }
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return { values[static_cast<std::size_t>(below * last)],
    values[static_cast<std::size_t>(above * last)] };
}

} // namespace VolumeHaptics
