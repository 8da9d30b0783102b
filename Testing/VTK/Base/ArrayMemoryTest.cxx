// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests arrays whose size depends on data. They equal VTK's own arrays, but throw an exception if
 * memory is short, whereas VTK's own arrays end the process in a build without NDEBUG.
 */

#include "VTK/Base/ArrayMemory.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkShortArray.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <new>

// Makes the sanitizers' allocators return null when memory is short, instead of ending the process.
extern "C" const char* __asan_default_options()
{
  return "allocator_may_return_null=1";
}
extern "C" const char* __tsan_default_options()
{
  return "allocator_may_return_null=1";
}

using namespace VolumeHaptics;

namespace
{
// number of samples that would take a million GiB
constexpr vtkIdType OfNoMachine = vtkIdType{ 1 } << 50;
} // namespace

TEST(ArrayMemory, HoldsTuplesOfEachType)
{
  for (const int type : { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    const vtkSmartPointer<vtkDataArray> array = NewArray(type, 3, 7);
    ASSERT_EQ(array->GetDataType(), type);
    ASSERT_EQ(array->GetNumberOfTuples(), 7);
    ASSERT_EQ(array->GetNumberOfComponents(), 3);
    for (vtkIdType i = 0; i < 7; ++i)
    {
      array->SetTuple3(i, static_cast<double>(i % 2), 1.0, 0.0);
    }
    array->InsertNextTuple3(1.0, 0.0, 1.0); // the array must grow like other arrays
    EXPECT_EQ(array->GetComponent(5, 0), 1.0);
    EXPECT_EQ(array->GetComponent(6, 0), 0.0);
    EXPECT_EQ(array->GetComponent(7, 2), 1.0);
  }
}

TEST(ArrayMemory, MayBeEmpty)
{
  EXPECT_EQ(NewArray(VTK_SHORT, 2, 0)->GetNumberOfTuples(), 0);
  vtkNew<vtkFloatArray> array;
  array->InsertNextValue(1.0F);
  AllocateTuples(array, 0);
  EXPECT_EQ(array->GetNumberOfTuples(), 0);
}

TEST(ArrayMemory, ThrowsIfThereIsNone)
{
  for (const int type : { VTK_BIT, VTK_SHORT, VTK_DOUBLE })
  {
    EXPECT_THROW(NewArray(type, 8, OfNoMachine), std::bad_alloc);
    EXPECT_THROW(NewArray(type, 3, std::numeric_limits<vtkIdType>::max()), std::bad_alloc);
    EXPECT_THROW(NewArray(type, 9, std::numeric_limits<vtkIdType>::max() / 9), std::bad_alloc);
  }
  // A failed allocation must preserve the existing values.
  vtkNew<vtkFloatArray> array;
  array->InsertNextValue(3.0F);
  EXPECT_THROW(AllocateTuples(array, OfNoMachine), std::bad_alloc);
  ASSERT_EQ(array->GetNumberOfTuples(), 1);
  EXPECT_EQ(array->GetValue(0), 3.0F);
  vtkNew<vtkImageData> image;
  image->SetDimensions(1 << 20, 1 << 20, 1 << 10);
  EXPECT_THROW(AllocateScalars(image, VTK_SHORT, 1), std::bad_alloc);
  EXPECT_EQ(image->GetPointData()->GetScalars(), nullptr);
}

TEST(ArrayMemory, CopiesAsVtkDoes)
{
  const auto from = vtkSmartPointer<vtkSOADataArrayTemplate<short>>::New();
  from->SetName("Apart");
  from->SetNumberOfComponents(2);
  from->SetComponentName(1, "second");
  from->SetNumberOfTuples(5);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    from->SetTuple2(i, static_cast<double>(i), static_cast<double>(-100 * i));
  }
  const vtkSmartPointer<vtkDataArray> same = CopyArray(from);
  const vtkSmartPointer<vtkDataArray> wide = CopyArray(from, VTK_DOUBLE);
  EXPECT_TRUE(same->HasStandardMemoryLayout());
  EXPECT_EQ(same->GetDataType(), VTK_SHORT);
  EXPECT_EQ(wide->GetDataType(), VTK_DOUBLE);
  for (vtkDataArray* const copy : { same.Get(), wide.Get() })
  {
    EXPECT_STREQ(copy->GetName(), "Apart");
    EXPECT_STREQ(copy->GetComponentName(1), "second");
    ASSERT_EQ(copy->GetNumberOfTuples(), 5);
    EXPECT_EQ(copy->GetComponent(4, 0), 4.0);
    EXPECT_EQ(copy->GetComponent(4, 1), -400.0);
  }
}

TEST(ArrayMemory, CopiesDataIfThereIsRoom)
{
  vtkNew<vtkImageData> from;
  from->SetDimensions(2, 3, 4);
  from->AllocateScalars(VTK_SHORT, 1);
  from->GetPointData()->GetScalars()->Fill(7.0);
  vtkNew<vtkImageData> to;
  CopyData(from, to);
  ASSERT_EQ(to->GetNumberOfPoints(), 24);
  EXPECT_NE(to->GetPointData()->GetScalars(), from->GetPointData()->GetScalars());
  EXPECT_EQ(to->GetPointData()->GetScalars()->GetComponent(23, 0), 7.0);
  vtkNew<vtkImageData> none;
  EXPECT_THROW(CopyData(from, none, std::size_t{ 1 } << 40), std::bad_alloc);
  EXPECT_EQ(none->GetNumberOfPoints(), 0);
}

TEST(ArrayMemory, NamesScalarsAsVtkDoes)
{
  vtkNew<vtkImageData> image, vtks;
  for (vtkImageData* const one : { image.Get(), vtks.Get() })
  {
    one->SetDimensions(2, 3, 4);
  }
  AllocateScalars(image, VTK_SHORT, 2);
  vtks->AllocateScalars(VTK_SHORT, 2);
  EXPECT_STREQ(
    image->GetPointData()->GetScalars()->GetName(), vtks->GetPointData()->GetScalars()->GetName());
  EXPECT_EQ(image->GetPointData()->GetScalars()->GetNumberOfValues(), 48);
}
