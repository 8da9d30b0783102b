// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The range of an array is the one that VTK finds, for all types and memory layouts.
 */

#include "VTK/Base/SampleRange.h"

#include <gtest/gtest.h>

#include <vtkAOSDataArrayTemplate.h>
#include <vtkBitArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkShortArray.h>

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

using namespace VolumeHaptics;

namespace
{
void ExpectVTKsRanges(vtkDataArray* array, const char* what)
{
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    double ours[2];
    double expected[2];
    FindRange(array, component, ours);
    array->GetRange(expected, component);
    EXPECT_EQ(ours[0], expected[0]) << what << ", component " << component;
    EXPECT_EQ(ours[1], expected[1]) << what << ", component " << component;
    FindFiniteRange(array, component, ours);
    array->GetFiniteRange(expected, component);
    EXPECT_EQ(ours[0], expected[0]) << what << ", component " << component << ", finite";
    EXPECT_EQ(ours[1], expected[1]) << what << ", component " << component << ", finite";
  }
}

template <typename T>
void Fill(vtkDataArray* array, vtkIdType tuples, std::mt19937_64& random)
{
  array->SetNumberOfTuples(tuples);
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    for (vtkIdType i = 0; i < tuples; ++i)
    {
      // Any bits that the type can hold, or numbers of any size.
      const auto bits = random();
      const double number = std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits)), -60);
      array->SetComponent(i, c,
        std::is_floating_point_v<T> ? number : static_cast<double>(static_cast<T>(bits >> 11)));
    }
  }
}

template <typename T>
void CheckType(const char* type)
{
  std::mt19937_64 random(3);
  for (const vtkIdType tuples : { 1, 2, 31, 32, 33, 64, 1000 })
  {
    for (const int components : { 1, 3 })
    {
      vtkNew<vtkAOSDataArrayTemplate<T>> together;
      together->SetNumberOfComponents(components);
      Fill<T>(together, tuples, random);
      ExpectVTKsRanges(together, type);
      vtkNew<vtkSOADataArrayTemplate<T>> separate;
      separate->SetNumberOfComponents(components);
      Fill<T>(separate, tuples, random);
      ExpectVTKsRanges(separate, type);
    }
  }
}
} // namespace

TEST(SampleRange, IsThatOfVTK)
{
  CheckType<char>("char");
  CheckType<signed char>("signed char");
  CheckType<unsigned char>("unsigned char");
  CheckType<short>("short");
  CheckType<unsigned short>("unsigned short");
  CheckType<int>("int");
  CheckType<unsigned int>("unsigned int");
  CheckType<long>("long");
  CheckType<unsigned long>("unsigned long");
  CheckType<long long>("long long");
  CheckType<unsigned long long>("unsigned long long");
  CheckType<float>("float");
  CheckType<double>("double");
  vtkNew<vtkBitArray> bits;
  bits->SetNumberOfValues(40);
  bits->Fill(0.0);
  bits->SetValue(17, 1);
  ExpectVTKsRanges(bits, "bit");
}

TEST(SampleRange, OfManySamplesIsFoundInPieces)
{
  // Ends in the first piece of 2^20 samples, in the last one, which is not whole, and between.
  constexpr vtkIdType count = (5 << 19) + 7;
  vtkNew<vtkShortArray> array;
  array->SetNumberOfValues(count);
  array->FillValue(3);
  const vtkIdType places[] = { 0, (1 << 20) - 1, 1 << 20, (1 << 21) + 5, count - 1 };
  for (const vtkIdType low : places)
  {
    for (const vtkIdType high : places)
    {
      if (low != high)
      {
        array->SetValue(low, -70);
        array->SetValue(high, 900);
        double range[2];
        FindRange(array, 0, range);
        EXPECT_EQ(range[0], -70.0) << low;
        EXPECT_EQ(range[1], 900.0) << high;
        array->SetValue(low, 3);
        array->SetValue(high, 3);
      }
    }
  }
}

TEST(SampleRange, LeavesOutWhatIsNoNumber)
{
  constexpr float infinite = std::numeric_limits<float>::infinity();
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  for (const float odd : { none, infinite, -infinite })
  {
    for (const int at : { 0, 5, 31, 32, 99 })
    {
      vtkNew<vtkFloatArray> array;
      array->SetNumberOfValues(100);
      for (int i = 0; i < 100; ++i)
      {
        array->SetValue(i, static_cast<float>(i) - 40.5F);
      }
      array->SetValue(at, odd);
      ExpectVTKsRanges(array, "one odd value");
    }
  }
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfValues(70);
  array->FillValue(none);
  double range[2];
  FindRange(array, 0, range);
  EXPECT_GT(range[0], range[1]);
  array->FillValue(infinite);
  FindFiniteRange(array, 0, range);
  EXPECT_GT(range[0], range[1]);
  FindRange(array, 0, range);
  EXPECT_EQ(range[0], infinite);
  array->SetNumberOfValues(0);
  FindRange(array, 0, range);
  EXPECT_GT(range[0], range[1]);
}
