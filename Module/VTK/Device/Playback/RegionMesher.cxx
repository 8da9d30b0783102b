// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/RegionMesher.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/WholeFacts.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/PlannerSettings.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkStructuredData.h"
#include "vtkVolumeHapticsFilter.h"

#include <string>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Number of samples of a region: meshing takes about ten milliseconds. */
constexpr vtkIdType MostMeshedSamples = 1 << 20;
/**
 * Smallest image (samples) for which a region is meshed first. Meshing a smaller image whole takes
 * nearly as long as a region, and is faster without a region at the same time.
 */
constexpr vtkIdType LeastWholeSamples = 4 * MostMeshedSamples;

/** Copies part of an extent's tuples into an array that no other thread uses. */
vtkSmartPointer<vtkDataArray> CopyTuples(
  vtkDataArray* whole, const int extent[6], const int part[6])
{
  auto copy = NewArray(whole->GetDataType(), whole->GetNumberOfComponents(),
    vtkStructuredData::GetNumberOfPoints(part));
  copy->SetName(whole->GetName());
  const vtkIdType nx = vtkIdType{ extent[1] } - extent[0] + 1;
  const vtkIdType ny = vtkIdType{ extent[3] } - extent[2] + 1;
  const vtkIdType row = vtkIdType{ part[1] } - part[0] + 1;
  vtkIdType to = 0;
  for (int k = part[4]; k <= part[5]; ++k)
  {
    for (int j = part[2]; j <= part[3]; ++j, to += row)
    {
      copy->InsertTuples(
        to, row, part[0] - extent[0] + nx * (j - extent[2] + ny * (k - extent[4])), whole);
    }
  }
  return copy;
}

} // namespace

RegionMesher::RegionMesher()
  : Region{ 0, -1, 0, -1, 0, -1 }
{
  this->Planner.SetMaximumVoxels(MostMeshedSamples);
}

RegionMesher::~RegionMesher() = default;

void RegionMesher::End()
{
  this->Meshing.Abandon();
  this->Of.reset();
  this->Ordered.reset();
  this->Region = { 0, -1, 0, -1, 0, -1 };
}

std::optional<SurfaceRegion> RegionMesher::Drain(
  vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  const Made* const made =
    this->Ordered ? this->Meshing.Find({ *this->Of, *this->Ordered }) : nullptr;
  if (!made)
  {
    return std::nullopt;
  }
  this->Region = *std::exchange(this->Ordered, std::nullopt);
  this->Planner.AddLatency(ServoClock::SecondsSince(this->OrderTime));
  const int component = filter->GetProperty()->GetComponent();
  const TouchedArray scalars = filter->GetBaker().GetFilled();
  HapticVolume volume;
  std::string error;
  if (!scalars.Array ||
    !ReadVolume(image, scalars.Array, component, filter->GetKernelRadius(), volume, error))
  {
    return std::nullopt;
  }
  SurfaceRegion region{ vtkSmartPointer<vtkImageData>::New(), made->Mesh };
  region.Image->SetExtent(this->Region.data());
  region.Image->SetOrigin(image->GetOrigin());
  region.Image->SetSpacing(image->GetSpacing());
  region.Image->SetDirectionMatrix(image->GetDirectionMatrix());
  region.Image->GetPointData()->SetScalars(made->Samples);
  WholeFields facts;
  image->GetExtent(facts.Extent);
  facts.Noise.resize(component + 1);
  facts.Noise[component] = EstimateImageNoise(image, scalars.Array, volume.View, component).Noise;
  facts.BorderValues.assign(component + 1, volume.View.BorderValue);
  facts.Solids.assign(component + 1, EstimateSolid(image, scalars.Array, volume.View, component));
  facts.Shifts.assign(
    component + 1, EstimateStoredShift(image, scalars.Array, volume.View, component));
  facts.Time = static_cast<double>(scalars.Time);
  WriteWholeFacts(facts, region.Image);
  return region;
}

void RegionMesher::Order(vtkImageData* image, vtkVolumeHapticsFilter* filter, const Extent& region)
{
  Affine3 map;
  std::string error;
  Extent whole;
  image->GetExtent(whole.data());
  if (!MakeIndexToWorld(image, whole.data(), "input image", map, error))
  {
    return; // meshing the whole image will report the error
  }
  // Extent relative to the image's first sample, as the map to the world expects.
  Extent fromFirst;
  for (int a = 0; a < 6; ++a)
  {
    fromFirst[a] = region[a] - whole[a - a % 2];
  }
  const vtkSmartPointer<vtkDataArray> scalars = filter->GetBaker().GetFilled().Array;
  if (!scalars)
  {
    return; // meshing the whole image will report the error
  }
  const int component = filter->GetProperty()->GetComponent();
  const double value = filter->GetIsoValue();
  this->Meshing.Poll({ *this->Of, region },
    [=](WorkMonitor& monitor) -> std::optional<Made>
    {
      Made made{ CopyTuples(scalars, whole.data(), region.data()), nullptr };
      if (!monitor.IsCancelled())
      {
        made.Mesh = MeshIsoSurface(made.Samples, fromFirst.data(), component, value, map);
      }
      return made;
    });
  this->Ordered = region;
  this->OrderTime = ServoClock::Now();
}

std::optional<SurfaceRegion> RegionMesher::Poll(vtkVolumeHapticsFilter* filter, const double tip[3])
{
  const TouchedArray scalars = filter->GetBaker().GetTouched()[0];
  vtkImageData* const image = filter->GetTouchedImage();
  WholeFacts facts;
  std::string error;
  // A given surface has no regions, because its gaps could not be told from missing parts. An image
  // that is itself a region is meshed whole.
  if (!scalars.Array || filter->GetInputDataObject(2, 0) ||
    image->GetNumberOfPoints() < LeastWholeSamples ||
    !ReadWholeFacts(image, filter->GetProperty()->GetComponent(), facts, error) || facts.IsThere)
  {
    return std::nullopt;
  }
  const SurfaceKey key{ scalars.GetKey(), filter->GetProperty()->GetComponent(),
    filter->GetIsoValue() };
  if (this->Of != key)
  {
    this->End();
    this->Of = key;
  }
  std::optional<SurfaceRegion> made = this->Drain(image, filter);
  Extent wanted;
  this->Planner.SetWhole(image, error);
  ConfigurePlanner(this->Planner, filter);
  const double atRest[3] = { 0.0, 0.0, 0.0 };
  if (!this->Meshing.IsUnderWay() &&
    this->Planner.Plan(tip, atRest, this->Region.data(), wanted.data()))
  {
    this->Order(image, filter, wanted);
  }
  return made;
}

} // namespace VolumeHaptics
