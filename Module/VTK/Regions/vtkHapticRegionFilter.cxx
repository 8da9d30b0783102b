// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRegionFilter.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Base/WholeFacts.h"
#include "VTK/Regions/HapticRegionSettings.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>
#include <string>

vtkStandardNewMacro(vtkHapticRegionFilter);

namespace
{
vtkIdType TupleOf(const int extent[6], int i, int j, int k)
{
  const vtkIdType nx = vtkIdType{ extent[1] } - extent[0] + 1;
  const vtkIdType ny = vtkIdType{ extent[3] } - extent[2] + 1;
  return (i - extent[0]) + nx * ((j - extent[2]) + ny * (vtkIdType{ k } - extent[4]));
}
} // namespace

//------------------------------------------------------------------------------
vtkHapticRegionFilter::vtkHapticRegionFilter()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//------------------------------------------------------------------------------
vtkHapticRegionFilter::~vtkHapticRegionFilter() = default;

//------------------------------------------------------------------------------
bool vtkHapticRegionFilter::ClipRegion(const int whole[6], int region[6]) const
{
  const bool isAll = this->Region[0] > this->Region[1] || this->Region[2] > this->Region[3] ||
    this->Region[4] > this->Region[5];
  bool isThere = true;
  for (int a = 0; a < 3; ++a)
  {
    const int i = 2 * a;
    region[i] = isAll ? whole[i] : std::max(whole[i], this->Region[i]);
    region[i + 1] = isAll ? whole[i + 1] : std::min(whole[i + 1], this->Region[i + 1]);
    isThere = isThere && region[i] <= region[i + 1];
  }
  return isThere;
}

//------------------------------------------------------------------------------
int vtkHapticRegionFilter::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  int whole[6];
  int region[6];
  inputs[0]->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  if (!this->ClipRegion(whole, region))
  {
    vtkErrorMacro(<< "The Region (" << this->Region[0] << ", " << this->Region[1] << ", "
                  << this->Region[2] << ", " << this->Region[3] << ", " << this->Region[4] << ", "
                  << this->Region[5] << ") has no part of the image in it, whose extent is ("
                  << whole[0] << ", " << whole[1] << ", " << whole[2] << ", " << whole[3] << ", "
                  << whole[4] << ", " << whole[5] << "). SetRegion() to indices within that.");
    return 0;
  }
  outputs->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), region, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticRegionFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* const info = inputs[0]->GetInformationObject(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHapticRegionFilter::IsCurrent(vtkMTimeType time)
{
  return time == this->GatheredTime;
}

//------------------------------------------------------------------------------
void vtkHapticRegionFilter::GatherSamples(SamplesOfComponents&) {}

//------------------------------------------------------------------------------
vtkHapticRegionFilter::SamplesOfComponents vtkHapticRegionFilter::CollectSamples(
  vtkDataArray* array, const int extent[6], const int whole[6])
{
  SamplesOfComponents samples(array ? array->GetNumberOfComponents() : 0);
  for (std::size_t c = 0; c < samples.size(); ++c)
  {
    VolumeHaptics::CollectNoiseSamples(array, static_cast<int>(c), extent, whole, samples[c]);
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkHapticRegionFilter::CopySamples(
  vtkDataArray* from, const int fromExtent[6], vtkDataArray* to, const int toExtent[6])
{
  int both[6];
  for (int a = 0; a < 6; a += 2)
  {
    both[a] = std::max(fromExtent[a], toExtent[a]);
    both[a + 1] = std::min(fromExtent[a + 1], toExtent[a + 1]);
  }
  if (both[0] > both[1])
  {
    return;
  }
  const vtkIdType count = vtkIdType{ both[1] } - both[0] + 1;
  for (int k = both[4]; k <= both[5]; ++k)
  {
    for (int j = both[2]; j <= both[3]; ++j)
    {
      to->InsertTuples(
        TupleOf(toExtent, both[0], j, k), count, TupleOf(fromExtent, both[0], j, k), from);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkHapticRegionFilter::GatherRegion(vtkImageData* piece, vtkDataArray* array,
  const int region[6], vtkImageData* output, std::string& error)
{
  const int* const extent = piece->GetExtent();
  for (int a = 0; a < 6; a += 2)
  {
    if (!array || extent[a] > region[a] || extent[a + 1] < region[a + 1])
    {
      error = "The input image does not hold all of the Region: its source gave only a part of "
              "what was asked "
              "for. Use a source that gives its whole extent, or lower Region to what it gives.";
      return false;
    }
  }
  const auto copy = VolumeHaptics::NewArray(
    array->GetDataType(), array->GetNumberOfComponents(), output->GetNumberOfPoints());
  copy->SetName(array->GetName());
  CopySamples(array, extent, copy, region);
  output->GetPointData()->SetScalars(copy);
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticRegionFilter::WriteFacts(const int whole[6], vtkImageData* output)
{
  VolumeHaptics::WholeFields facts;
  std::copy(whole, whole + 6, facts.Extent);
  facts.Noise = this->Noise;
  facts.BorderValues = this->BorderValues;
  facts.Solids = this->Solids;
  facts.Shifts = this->Shifts;
  facts.Outside = this->Outside;
  facts.Time = static_cast<double>(this->GatheredTime);
  VolumeHaptics::WriteWholeFacts(facts, output);
}

//------------------------------------------------------------------------------
int vtkHapticRegionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* const piece = vtkImageData::GetData(inputs[0]);
  vtkImageData* const output = vtkImageData::GetData(outputs);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const array = this->GetInputArrayToProcess(0, piece, association);
  const bool isEmpty = piece->GetNumberOfPoints() == 0;
  if (!isEmpty &&
    (!array || association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
      array->GetNumberOfTuples() != piece->GetNumberOfPoints()))
  {
    vtkErrorMacro("The input image has no point scalars to touch. Give its point data active "
                  "scalars, or name a "
                  "numeric point array with SetInputArrayToProcess(0, 0, 0, "
                  "vtkDataObject::FIELD_ASSOCIATION_POINTS, name).");
    return 0;
  }
  int whole[6];
  int region[6];
  inputs[0]->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  if (!this->ClipRegion(whole, region))
  {
    return 0; // RequestInformation() has reported the error
  }
  vtkMTimeType time = std::max(piece->GetMTime(), this->GetInputArrayInformation(0)->GetMTime());
  time = array ? std::max(time, array->GetMTime()) : time;
  if (!this->IsCurrent(time))
  {
    SamplesOfComponents samples = CollectSamples(array, piece->GetExtent(), whole);
    this->GatherSamples(samples);
    this->Noise.clear();
    this->BorderValues.clear();
    this->Solids.clear();
    this->Shifts.clear();
    this->Outside.clear();
    for (VolumeHaptics::NoiseSamples& component : samples)
    {
      // Detect outside samples from all pieces, because this process may have no piece and hence no
      // array.
      const auto outside = VolumeHaptics::AreScalars(static_cast<int>(samples.size()))
        ? VolumeHaptics::DetectOutside(component)
        : VolumeHaptics::OutsideSamples{};
      VolumeHaptics::FillOutside(outside, component);
      this->Outside.push_back(outside);
      this->Noise.push_back(VolumeHaptics::EstimateNoise(component));
      this->BorderValues.push_back(VolumeHaptics::FindBorderValue(component));
      this->Solids.push_back(VolumeHaptics::BackgroundLevel::Estimate(component));
      this->Shifts.push_back(VolumeHaptics::StoredShift::Estimate(component));
    }
    this->GatheredTime = time;
  }
  output->SetExtent(region);
  output->SetOrigin(piece->GetOrigin());
  output->SetSpacing(piece->GetSpacing());
  output->SetDirectionMatrix(piece->GetDirectionMatrix());
  std::string error;
  try
  {
    if (this->GatherRegion(piece, array, region, output, error))
    {
      this->WriteFacts(whole, output);
      return 1;
    }
  }
  catch (const std::bad_alloc&)
  {
    error = "There is not enough memory for the Region: its " +
      std::to_string(output->GetNumberOfPoints()) + " points take " +
      std::to_string(
        output->GetNumberOfPoints() * array->GetNumberOfComponents() * array->GetDataTypeSize()) +
      " bytes. SetRegion() to a smaller one.";
    output->Initialize();
  }
  vtkErrorMacro(<< VolumeHaptics::Printable(error));
  return 0;
}

//------------------------------------------------------------------------------
void vtkHapticRegionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::RegionFilterVectors);
  os << indent << "Noise:";
  for (const double noise : this->Noise)
  {
    os << " " << noise;
  }
  os << "\n";
}
