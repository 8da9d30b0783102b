// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/VolumeFields.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeOrientation.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace
{
bool IsField(vtkDataArray* array)
{
  const int components = array ? array->GetNumberOfComponents() : 0;
  return components == 3 || components == 6 || components == 9;
}

vtkSmartPointer<vtkDataArray> MakeMagnitude(vtkDataArray* field)
{
  auto magnitude = vtkSmartPointer<vtkFloatArray>::New();
  magnitude->SetName((std::string(field->GetName()) + " magnitude").c_str());
  VolumeHaptics::AllocateTuples(magnitude, field->GetNumberOfTuples());
  for (vtkIdType i = 0; i < field->GetNumberOfTuples(); ++i)
  {
    double sum = 0.0;
    for (int c = 0; c < field->GetNumberOfComponents(); ++c)
    {
      sum += field->GetComponent(i, c) * field->GetComponent(i, c);
    }
    magnitude->SetValue(i, static_cast<float>(std::sqrt(sum)));
  }
  return magnitude;
}

constexpr std::size_t MOST_LABELS = 512;
constexpr double HIGHEST_LABEL = 65535.0; // high enough for FreeSurfer, which has labels above
                                          // 10000
// Smallest fraction of equal neighbours along rows.
constexpr double LEAST_ALIKE = 0.75;
// Largest fraction of the voxels beside a step whose values may lie between its two sides.
constexpr double MOST_BETWEEN = 0.05;
constexpr vtkIdType MOST_ROWS = 20000;
} // namespace

namespace Explore
{
void VolumeFields::Collect(vtkImageData* image)
{
  this->Source = vtkSmartPointer<vtkImageData>::New();
  this->Source->CopyStructure(image);
  vtkPointData* const points = image->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = points->GetArray(i);
    if (IsField(array) && array->GetName() && array->GetDataType() != VTK_UNSIGNED_CHAR)
    {
      this->Arrays.emplace_back(array);
    }
  }
}

bool VolumeFields::Use(vtkImageData* image)
{
  this->Collect(image);
  vtkPointData* const points = image->GetPointData();
  const bool isScalar = points->GetScalars() || points->GetNumberOfArrays() == 0 ||
    !IsField(points->GetArray(0)) || this->Arrays.empty();
  if (!isScalar)
  {
    points->SetScalars(MakeMagnitude(this->Arrays.front()));
  }
  return !isScalar;
}

bool VolumeFields::UseWith(const std::string& name, const std::string& path, vtkImageData* image)
{
  this->Collect(image);
  vtkPointData* const points = image->GetPointData();
  vtkDataArray* const array = points->GetArray(name.c_str());
  if (!array)
  {
    std::string known;
    for (int i = 0; i < points->GetNumberOfArrays(); ++i)
    {
      const char* const other = points->GetArray(i) ? points->GetArray(i)->GetName() : nullptr;
      known += other ? (known.empty() ? "'" : ", '") + std::string(other) + "'" : "";
    }
    throw InputError("ArrayName = '" + name + "'", "is not an array of the points of " + path,
      known.empty() ? "leave it out: there is none with a name" : "use one of " + known);
  }
  const vtkSmartPointer<vtkDataArray> shown =
    IsField(array) ? MakeMagnitude(array) : vtkSmartPointer<vtkDataArray>(array);
  points->SetScalars(shown);
  return IsField(array);
}

std::string VolumeFields::FindFlow(vtkImageData* image, const std::string& name)
{
  vtkPointData* const points = image->GetPointData();
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = points->GetArray(i);
    const bool isFlow = array && array->GetName() && array->GetNumberOfComponents() == 3;
    if (isFlow && (name.empty() || name == array->GetName()))
    {
      return array->GetName();
    }
  }
  return {};
}

void VolumeFields::GiveTo(vtkImageData* aligned) const
{
  for (const auto& array : this->Arrays)
  {
    vtkNew<vtkImageData> image;
    image->CopyStructure(this->Source);
    image->GetPointData()->SetScalars(array);
    aligned->GetPointData()->AddArray(AlignToAxes(image)->GetPointData()->GetScalars());
  }
}

//------------------------------------------------------------------------------
bool LooksLikeLabels(vtkImageData* image)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  const int* const size = image->GetDimensions();
  double range[2];
  if (!values || values->GetNumberOfComponents() != 1 || size[0] < 3)
  {
    return false;
  }
  values->GetFiniteRange(range, 0);
  if (range[0] < 0.0 || range[1] > HIGHEST_LABEL || range[1] <= range[0])
  {
    return false;
  }
  const vtkIdType rows = static_cast<vtkIdType>(size[1]) * size[2];
  const vtkIdType every = rows / MOST_ROWS + 1;
  std::set<double> labels;
  std::int64_t pairs = 0, alike = 0, steps = 0, between = 0;
  for (vtkIdType row = 0; row < rows; row += every)
  {
    double before[2] = { 0.0, 0.0 };
    for (int i = 0; i < size[0]; ++i)
    {
      const double value = values->GetComponent(row * size[0] + i, 0);
      if (value != std::floor(value))
      {
        return false;
      }
      if (i == 0 || value != before[1])
      {
        labels.insert(value);
        if (labels.size() > MOST_LABELS)
        {
          return false;
        }
      }
      if (i > 0)
      {
        ++pairs;
        alike += value == before[1];
      }
      if (i > 1 && value != before[0])
      {
        ++steps;
        const auto [low, high] = std::minmax(value, before[0]);
        between += before[1] > low && before[1] < high;
      }
      before[0] = before[1];
      before[1] = value;
    }
  }
  return alike >= LEAST_ALIKE * static_cast<double>(pairs) &&
    between <= MOST_BETWEEN * static_cast<double>(std::max<std::int64_t>(steps, 1));
}

} // namespace Explore
