// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/VolumeFields.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeOrientation.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>

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
      known.empty() ? "leave it out: there is none with a name" : "take one of " + known);
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
} // namespace Explore
