// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the choice of the touched array and component.
 */

#include "Rigs/ApiRig.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkUnsignedShortArray.h>

using namespace apitest;

TEST_F(ApiTest, ArrayByName)
{
  vtkNew<vtkFloatArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(this->Image->GetNumberOfPoints());
  other->Fill(-5.0);
  this->Image->GetPointData()->AddArray(other);
  EXPECT_EQ(Get(this->Run(51), "Value", 0), 500.0);
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  EXPECT_EQ(Get(this->Run(51), "Value", 0), -5.0);
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  EXPECT_EQ(Get(this->Run(51), "Value", 0), 500.0);
}

TEST_F(ApiTest, ComponentOfTheProperty)
{
  vtkDataArray* const scalars = this->Image->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(this->Image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    vectors->SetTuple3(i, 1.0, scalars->GetComponent(i, 0), -2.0);
  }
  this->Image->GetPointData()->SetScalars(vectors);
  const double expected[] = { 1.0, 500.0, -2.0 };
  for (int c = 0; c < 3; ++c)
  {
    this->Property->SetComponent(c);
    EXPECT_EQ(Get(this->Run(51), "Value", 0), expected[c]);
  }
}

TEST_F(ApiTest, HashIsOfTheValuesInWhateverLayout)
{
  constexpr vtkIdType n = 5 * 9 * 100;
  vtkNew<vtkUnsignedShortArray> together;
  vtkNew<vtkSOADataArrayTemplate<unsigned short>> apart;
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(together), static_cast<vtkDataArray*>(apart) })
  {
    array->SetNumberOfComponents(2);
    array->SetNumberOfTuples(n);
    for (vtkIdType i = 0; i < n; ++i)
    {
      array->SetTuple2(i, 2.0 * static_cast<double>(i), 2.0 * static_cast<double>(i) + 1.0);
    }
    this->Image->SetDimensions(5, 9, 100);
    this->Image->GetPointData()->SetScalars(array);
    // Python computes the hash as md5(pack("<5i", 5, 9, 100, 2, 5) + pack("<9000H", *range(9000))):
    // 5 x 9 x 100 points with 2 components of VTK_UNSIGNED_SHORT (5).
    EXPECT_EQ(this->Filter->HashScalars(), "27ecaeac981c0cb949f77ecbec42617c")
      << array->GetClassName();
  }
}
