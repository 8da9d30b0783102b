// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/VolumeFields.h"

#include "Applications/Explorer/Volume/VolumeOrientation.h"

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
  magnitude->SetNumberOfTuples(field->GetNumberOfTuples());
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
bool VolumeFields::Take(vtkImageData* image)
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
  const bool isScalar = points->GetScalars() || points->GetNumberOfArrays() == 0 ||
    !IsField(points->GetArray(0)) || this->Arrays.empty();
  if (!isScalar)
  {
    points->SetScalars(MakeMagnitude(this->Arrays.front()));
  }
  return !isScalar;
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
