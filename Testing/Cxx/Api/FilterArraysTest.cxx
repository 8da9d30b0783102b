// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Which array and which component is touched.
 */

#include "ApiRig.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

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
