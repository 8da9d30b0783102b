// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests images whose arrays can't be touched.
 */

#include "Rigs/BadImage.h"

#include <vtkBitArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkStringArray.h>

#include <cstdlib>

using namespace apitest;

namespace
{
template <typename Array>
void AddArray(vtkImageData* image, const char* name)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(array);
}

const BadImage BadScalars[] = {
  { "NoScalars", [](auto* image, auto*) { image->GetPointData()->Initialize(); },
    { "input image", "scalars", "SetInputArrayToProcess" } },
  { "CellScalarsOnly",
    [](auto* image, auto*)
    {
      image->GetPointData()->Initialize();
      vtkNew<vtkFloatArray> cells;
      cells->SetNumberOfValues(image->GetNumberOfCells());
      image->GetCellData()->SetScalars(cells);
    },
    { "input image", "point scalars" } },
  { "CellArrayByName",
    [](auto* image, auto* filter)
    {
      vtkNew<vtkFloatArray> cells;
      cells->SetName("PerCell");
      cells->SetNumberOfValues(image->GetNumberOfCells());
      image->GetCellData()->AddArray(cells);
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "PerCell");
    },
    { "input image", "\"PerCell\"", "point" } },
  { "NoSuchArray", [](auto*, auto* filter) { NameArray(filter, "Hounsfield"); },
    { "input image", "\"Hounsfield\"", "SetInputArrayToProcess" } },
  { "StringArray",
    [](auto* image, auto* filter)
    {
      AddArray<vtkStringArray>(image, "Tissue");
      NameArray(filter, "Tissue");
    },
    { "input image", "\"Tissue\"", "numeric" } },
  { "BitArray",
    [](auto* image, auto*)
    {
      AddArray<vtkBitArray>(image, "Mask");
      image->GetPointData()->SetActiveScalars("Mask");
    },
    { "input image", "\"Mask\"", "unsupported scalar type", "DeepCopy" } },
  { "TooFewTuples",
    [](auto* image, auto*) { image->GetPointData()->GetScalars()->SetNumberOfTuples(7); },
    { "input image", "\"Density\"", "7 tuples" } },
  { "ComponentWithoutMemory",
    [](auto* image, auto* filter)
    {
      // Only the first of the two components has memory, which the application provided.
      vtkNew<vtkSOADataArrayTemplate<float>> separate;
      separate->SetName("Density");
      separate->SetNumberOfComponents(2);
      auto* const memory = static_cast<float*>(std::calloc(image->GetNumberOfPoints(), 4));
      separate->SetArray(0, memory, image->GetNumberOfPoints(), true);
      image->GetPointData()->SetScalars(separate);
      filter->GetProperty()->SetComponent(1);
    },
    { "input image", "\"Density\"", "no memory", "component 1", "SetArray" } },
  { "NoSuchComponent", [](auto*, auto* filter) { filter->GetProperty()->SetComponent(1); },
    { "input image", "\"Density\"", "component 1", "SetComponent" } },
};
} // namespace

class BadScalarsTest : public BadImageTest
{
};

TEST_P(BadScalarsTest, GivesOneErrorAndRecovers)
{
  this->ExpectErrorAndRecovery();
}

using ComponentMemory = ApiTest;

/// Touches component 1 of two: first the component has no memory, then it gets the values of the
/// ramp.
TEST_F(ComponentMemory, IsGivenAsTheErrorSays)
{
  const vtkSmartPointer<vtkDataArray> density = this->Image->GetPointData()->GetScalars();
  const vtkIdType n = density->GetNumberOfTuples();
  const double force = Get(this->Run(51), "Force", 50, 2);
  EXPECT_GT(std::abs(force), 0.1);
  vtkNew<vtkSOADataArrayTemplate<double>> separate;
  separate->SetName("Density");
  separate->SetNumberOfComponents(2);
  separate->SetArray(0, static_cast<double*>(std::calloc(n, sizeof(double))), n, true);
  this->Image->GetPointData()->SetScalars(separate);
  this->Property->SetComponent(1);
  this->ExpectError({ "Give it values for all components, for example with SetArray" });
  auto* const values = static_cast<double*>(std::calloc(n, sizeof(double)));
  for (vtkIdType i = 0; i < n; ++i)
  {
    values[i] = density->GetTuple1(i);
  }
  separate->SetArray(1, values, n, true);
  this->Image->Modified();
  EXPECT_DOUBLE_EQ(Get(this->Run(51), "Force", 50, 2), force);
}

INSTANTIATE_TEST_SUITE_P(Images, BadScalarsTest, testing::ValuesIn(BadScalars), NameOf);
