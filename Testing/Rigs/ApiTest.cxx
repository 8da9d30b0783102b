// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ApiRig.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>

#include <cstring>

namespace apitest
{
namespace
{
bool IsSame(vtkDataArray* a, vtkDataArray* b, vtkIdType tuples)
{
  const std::size_t bytes = static_cast<std::size_t>(tuples) * a->GetNumberOfComponents() *
    static_cast<std::size_t>(a->GetDataTypeSize());
  return b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfComponents() == b->GetNumberOfComponents() && a->GetNumberOfTuples() >= tuples &&
    b->GetNumberOfTuples() >= tuples &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0;
}
} // namespace

bool IsSame(vtkPolyData* a, vtkPolyData* b, vtkIdType ticks)
{
  if (ticks < 0)
  {
    ticks = a->GetNumberOfPoints();
    if (b->GetNumberOfPoints() != ticks || a->GetNumberOfLines() != b->GetNumberOfLines())
    {
      return false;
    }
  }
  vtkPointData* const data = a->GetPointData();
  bool same = data->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays() &&
    IsSame(a->GetPoints()->GetData(), b->GetPoints()->GetData(), ticks);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    same = same && IsSame(array, b->GetPointData()->GetArray(array->GetName()), ticks);
  }
  return same;
}

ApiTest::ApiTest()
  : ExecutiveLog(this->Filter->GetExecutive())
{
  this->Filter->SetInputDataObject(0, this->Image);
  this->Filter->SetPathData(this->Path);
}

vtkPolyData* ApiTest::Run(vtkIdType ticks)
{
  this->Log.Errors.clear();
  this->Filter->Update();
  vtkPolyData* const output = this->Filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), ticks);
  for (const std::string& error : this->Log.Errors)
  {
    ADD_FAILURE() << error;
  }
  EXPECT_TRUE(this->Log.Warnings.empty()) << this->Log.Warnings.front();
  for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(output->GetPointData()->GetArray(i)->GetNumberOfTuples(), ticks);
  }
  return output;
}

void ApiTest::ExpectError(const std::vector<std::string>& words)
{
  this->Log.Errors.clear();
  this->Filter->Update();
  EXPECT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_TRUE(this->Log.Warnings.empty());
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
  for (const std::string& error : this->Log.Errors)
  {
    for (const std::string& word : words)
    {
      EXPECT_NE(error.find(word), std::string::npos) << "no \"" << word << "\" in: " << error;
    }
  }
}
} // namespace apitest
