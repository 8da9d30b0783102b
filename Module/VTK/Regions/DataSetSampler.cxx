// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/DataSetSampler.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCompositeDataProbeFilter.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>

namespace VolumeHaptics
{
namespace
{

/**
 * Number of copies in memory at once: the copy itself, and the result of averaging its cell arrays.
 */
constexpr std::size_t CopiesAtOnce = 2;

bool CanBeSampled(vtkDataArray* array)
{
  const int components = array && array->GetName() ? array->GetNumberOfComponents() : 0;
  return components == 1 || components == 3 || components == 6 || components == 9;
}

std::string ListArrays(vtkDataSet* part)
{
  std::string list;
  for (vtkDataSetAttributes* const arrays :
    std::initializer_list<vtkDataSetAttributes*>{ part->GetPointData(), part->GetCellData() })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      if (CanBeSampled(arrays->GetArray(i)))
      {
        list += (list.empty() ? "" : ", ") + std::string(arrays->GetArray(i)->GetName());
      }
    }
  }
  return list;
}

/** Adds an array if all parts have it. Returns false otherwise. */
bool AddSampled(
  const std::vector<vtkDataSet*>& parts, const std::string& name, std::vector<SampledArray>& arrays)
{
  vtkDataArray* const first = parts.front()->GetPointData()->GetArray(name.c_str());
  const bool isThere = CanBeSampled(first) &&
    std::all_of(parts.begin(), parts.end(),
      [&](vtkDataSet* part)
      {
        vtkDataArray* const array = part->GetPointData()->GetArray(name.c_str());
        return array && array->GetNumberOfComponents() == first->GetNumberOfComponents();
      });
  const bool isNew = std::none_of(
    arrays.begin(), arrays.end(), [&](const SampledArray& array) { return array.Name == name; });
  if (isThere && isNew)
  {
    arrays.push_back({ name, first->GetNumberOfComponents() });
  }
  return isThere;
}

} // namespace

DataSetSampler::DataSetSampler() = default;
DataSetSampler::~DataSetSampler() = default;

std::shared_ptr<DataSetSampler> DataSetSampler::Make(
  vtkDataObject* data, const std::vector<std::string>& wanted, double spacing, std::string& error)
{
  std::vector<vtkDataSet*> parts = CollectParts(data);
  if (parts.empty())
  {
    error = std::string("The ") + data->GetClassName() +
      " on input port 0 has no cells, between whose points there could be something to touch. Make "
      "cells of points, for example with vtkDelaunay3D, or an image with vtkPointInterpolator.";
    return nullptr;
  }
  const std::string fault = DetectFalseCells(parts);
  if (!fault.empty())
  {
    error = std::string("The ") + data->GetClassName() + " on input port 0 " + fault +
      ", with which VTK's filters would end the program. Correct its cells, or make tetrahedra "
      "where they come from.";
    return nullptr;
  }
  std::shared_ptr<DataSetSampler> sampler(new DataSetSampler);
  const vtkBoundingBox box = ComputeBox(parts);
  if (!PlaceGrid(
        box, spacing > 0.0 ? spacing : ComputeSampleSpacing(box, CountCells(parts)), sampler->Grid))
  {
    std::ostringstream message;
    message
      << "The " << data->GetClassName()
      << " on input port 0 has no volume that could be resampled with a spacing of "
      << sampler->Grid.Spacing
      << ": it is flat, its bounds are not finite, or it has more than a million samples along "
         "an edge. Give it cells in three dimensions, or set another SampleSpacing.";
    error = message.str();
    return nullptr;
  }
  vtkNew<vtkCellDataToPointData> average;
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  try
  {
    CopyData(data, copy, CopiesAtOnce);
  }
  catch (const std::bad_alloc&)
  {
    error = std::string("There is not enough memory to touch the ") + data->GetClassName() +
      " on input port 0, which takes " + std::to_string(data->GetActualMemorySize() / 1024) +
      " MiB and has to be copied. Touch a smaller part of it, or an image of it, which "
      "vtkResampleToImage makes.";
    return nullptr;
  }
  average->SetInputData(copy);
  average->PassCellDataOff();
  average->Update();
  const bool isComposite = vtkCompositeDataSet::SafeDownCast(data) != nullptr;
  const std::string known = ListArrays(parts.front());
  vtkDataObject* const averaged = average->GetOutputDataObject(0);
  if (!averaged || CollectParts(averaged).size() != parts.size())
  {
    error = "The cell arrays of the data on input port 0 can't be averaged to its points.";
    return nullptr;
  }
  sampler->Data = averaged;
  parts = CollectParts(averaged);
  vtkPointData* const arrays = parts.front()->GetPointData();
  // A composite data set has no active arrays, so use those of its parts.
  std::vector<SampledArray> fields;
  vtkDataArray* const active[] = { arrays->GetScalars(), arrays->GetVectors(),
    arrays->GetTensors() };
  for (vtkDataArray* const array : active)
  {
    if (CanBeSampled(array))
    {
      AddSampled(parts, array->GetName(), fields);
    }
  }
  for (const std::string& name : wanted)
  {
    if (!AddSampled(parts, name, fields))
    {
      error = std::string("The ") + data->GetClassName() + " on input port 0 has no array \"" +
        name + "\" of 1, 3, 6 or 9 numbers" + (isComposite ? " in all of its parts" : "") +
        ". Name one of these: " + known + ".";
      return nullptr;
    }
  }
  for (int i = 0; fields.empty() && i < arrays->GetNumberOfArrays(); ++i)
  {
    if (CanBeSampled(arrays->GetArray(i)))
    {
      AddSampled(parts, arrays->GetArray(i)->GetName(), fields);
    }
  }
  if (fields.empty())
  {
    error = std::string("The ") + data->GetClassName() +
      " on input port 0 has no numeric point or cell array of 1, 3, 6 or 9 components" +
      (isComposite ? " that all of its parts have" : "") +
      ": there is nothing to touch. Give it one.";
    return nullptr;
  }
  const auto scalar = std::find_if(
    fields.begin(), fields.end(), [](const SampledArray& array) { return array.Components == 1; });
  sampler->HasOwnScalars = scalar != fields.end();
  if (sampler->HasOwnScalars)
  {
    std::rotate(fields.begin(), scalar, scalar + 1);
    sampler->LeastScalar = VTK_DOUBLE_MAX;
    for (vtkDataSet* const part : parts)
    {
      double range[2];
      part->GetPointData()->GetArray(fields.front().Name.c_str())->GetFiniteRange(range, 0);
      sampler->LeastScalar = std::min(sampler->LeastScalar, range[0]);
    }
  }
  else
  {
    fields.insert(fields.begin(), { fields.front().Name + " magnitude", 1 });
  }
  sampler->Arrays = std::move(fields);
  return sampler;
}

int DataSetSampler::CountValues() const
{
  int count = 0;
  for (const SampledArray& array : this->Arrays)
  {
    count += array.Components;
  }
  return count;
}

void DataSetSampler::Read(const int box[6], float* samples)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  vtkNew<vtkImageData> grid;
  grid->SetExtent(box[0], box[1], box[2], box[3], box[4], box[5]);
  grid->SetOrigin(this->Grid.Origin);
  grid->SetSpacing(this->Grid.Spacing, this->Grid.Spacing, this->Grid.Spacing);
  vtkNew<vtkCompositeDataProbeFilter> probe;
  probe->SetInputData(grid);
  probe->SetSourceData(this->Data);
  probe->Update();
  vtkPointData* const found = probe->GetOutput()->GetPointData();
  vtkDataArray* const mask = found->GetArray(probe->GetValidPointMaskArrayName());
  const vtkIdType count = grid->GetNumberOfPoints();
  float* to = samples;
  for (std::size_t i = this->HasOwnScalars ? 0 : 1; i < this->Arrays.size(); ++i)
  {
    const SampledArray& array = this->Arrays[i];
    vtkDataArray* const values = found->GetArray(array.Name.c_str());
    if (!mask || !values || values->GetNumberOfTuples() != count ||
      values->GetNumberOfComponents() != array.Components)
    {
      throw std::runtime_error("VTK's probe gives no array \"" + array.Name + "\".");
    }
    float* const plane = this->HasOwnScalars ? to : to + count;
    const float outside = array.Components == 1 ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
    for (vtkIdType p = 0; p < count; ++p)
    {
      const bool isInside = mask->GetComponent(p, 0) != 0.0;
      for (int c = 0; c < array.Components; ++c)
      {
        plane[p * array.Components + c] =
          isInside ? static_cast<float>(values->GetComponent(p, c)) : outside;
      }
    }
    to += count * array.Components;
  }
  if (!this->HasOwnScalars)
  {
    const int components = this->Arrays[1].Components;
    const float* const field = samples + count;
    for (vtkIdType p = 0; p < count; ++p)
    {
      double sum = 0.0;
      for (int c = 0; c < components; ++c)
      {
        const double value = field[p * components + c];
        sum += value * value;
      }
      samples[p] = static_cast<float>(std::sqrt(sum));
    }
  }
}

} // namespace VolumeHaptics
