// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the function editor counts the values of a large array in pieces, either all values or
 * distributed samples. The counts are compared with a std::map or std::set of the same values.
 */

#include "VTK/Scene/Base/HapticHistogram.h"
#include "VTK/Scene/Editor/HapticValueScale.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkShortArray.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace VolumeHaptics;

namespace
{
constexpr vtkIdType Many = 2500000; // number of values, more than two pieces

bool GoOn(double fraction)
{
  EXPECT_GE(fraction, 0.0);
  EXPECT_LT(fraction, 1.0);
  return true;
}

/// Draws from a narrow distribution around 300. About one value in a million is an outlier at 2000.
double Draw(std::mt19937& random)
{
  std::normal_distribution<double> normal(300.0, 40.0);
  return random() % 1000000 == 0 ? 2000.0 : std::round(normal(random));
}

vtkIdType Sum(const ValueCounts& counts)
{
  return std::accumulate(counts.Counts.begin(), counts.Counts.end(), vtkIdType{ 0 });
}

/// Expects that every bin counts the values within half a bin width of its centre.
void ExpectCounts(const ValueCounts& counts, const std::map<double, vtkIdType>& values)
{
  ASSERT_FALSE(counts.Counts.empty());
  EXPECT_LE(counts.Counts.size(), 128U);
  EXPECT_EQ(counts.Range[0], values.begin()->first);
  EXPECT_EQ(counts.Range[1], values.rbegin()->first);
  vtkIdType all = 0;
  for (std::size_t bin = 0; bin < counts.Counts.size(); ++bin)
  {
    const double middle = counts.Origin + static_cast<double>(bin) * counts.Width;
    vtkIdType expected = 0;
    for (auto value = values.lower_bound(middle - 0.5 * counts.Width);
         value != values.end() && value->first < middle + 0.5 * counts.Width; ++value)
    {
      expected += value->second;
    }
    EXPECT_EQ(counts.Counts[bin], expected) << "bin " << bin;
    all += counts.Counts[bin];
  }
  EXPECT_EQ(all,
    std::accumulate(values.begin(), values.end(), vtkIdType{ 0 },
      [](vtkIdType sum, const auto& value) { return sum + value.second; }));
}

template <typename ArrayType>
void CheckArray(ArrayType* array)
{
  std::mt19937 random(3);
  std::map<double, vtkIdType> values;
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(Many);
  for (vtkIdType i = 0; i < Many; ++i)
  {
    const double value = Draw(random);
    ++values[value];
    array->SetComponent(i, 0, -5.0);
    array->SetComponent(i, 1, value);
  }
  const auto all = CountAllValues(array, 1, GoOn);
  ASSERT_TRUE(all.has_value());
  ExpectCounts(*all, values);
}
} // namespace

TEST(Counts, OfAllValuesAreThoseOfAMap)
{
  CheckArray(vtkNew<vtkShortArray>().Get());
  CheckArray(vtkNew<vtkSOADataArrayTemplate<int>>().Get());
}

TEST(Counts, LeaveOutWhatIsNotFinite)
{
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfValues(1000);
  for (int i = 0; i < 1000; ++i)
  {
    array->SetValue(i, i % 2 ? static_cast<float>(i) : std::numeric_limits<float>::quiet_NaN());
  }
  array->SetValue(7, std::numeric_limits<float>::infinity());
  const auto all = CountAllValues(array, 0, GoOn);
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ(all->Range[0], 1.0);
  EXPECT_EQ(all->Range[1], 999.0);
  EXPECT_EQ(Sum(*all), 499);
  const ValueCounts spread = CountSpreadValues(array, 0);
  EXPECT_EQ(spread.Counts, all->Counts) << "an array of less values is counted wholly";
  array->Fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(CountAllValues(array, 0, GoOn)->Counts.empty());
  EXPECT_TRUE(CountSpreadValues(array, 0).Counts.empty());
  vtkNew<vtkTable> table;
  FillHistogram(CountSpreadValues(array, 0), table);
  EXPECT_EQ(table->GetNumberOfColumns(), 0);
}

TEST(Counts, OfSpreadSamplesHaveTheSameFractions)
{
  // Each row of 512 values has 256 zeros, followed by 256 values of 100. Samples at regular
  // intervals would find only one of the two values.
  vtkNew<vtkShortArray> array;
  array->SetNumberOfValues(1 << 23);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, i % 512 < 256 ? 0 : 100);
  }
  const ValueCounts spread = CountSpreadValues(array, 0);
  ASSERT_EQ(spread.Counts.size(), 101U);
  EXPECT_EQ(Sum(spread), 1 << 11);
  EXPECT_NEAR(static_cast<double>(spread.Counts[0]) / (1 << 11), 0.5, 0.04);
  EXPECT_NEAR(static_cast<double>(spread.Counts[100]) / (1 << 11), 0.5, 0.04);
}

TEST(Counts, OfSpreadSamplesSeeAllColumnsInFewPages)
{
  // Each value is its own index. Of the 512 columns, 2048 random samples would miss 512 exp(-4), or
  // about 9. A page of 4 KiB has 1024 values.
  constexpr vtkIdType columns = 512;
  vtkNew<vtkIntArray> numbers;
  numbers->SetNumberOfValues(1 << 23);
  for (vtkIdType i = 0; i < numbers->GetNumberOfValues(); ++i)
  {
    numbers->SetValue(i, static_cast<int>(i));
  }
  std::set<vtkIdType> seen;
  std::set<vtkIdType> pages;
  VisitSpreadValues(numbers, 0,
    [&](double value)
    {
      seen.insert(static_cast<vtkIdType>(value) % columns);
      pages.insert(static_cast<vtkIdType>(value) / 1024);
    });
  EXPECT_GT(seen.size(), 450U);
  EXPECT_EQ(pages.size(), 128U);
  EXPECT_LT(*pages.begin(), 64);
  EXPECT_GE(*pages.rbegin(), 8192 - 64);
}

TEST(Counts, EndWhenTheyAreTold)
{
  vtkNew<vtkShortArray> array;
  array->SetNumberOfValues(Many);
  array->Fill(4.0);
  int pieces = 0;
  const auto end = [&pieces](double) { return ++pieces < 2; };
  EXPECT_FALSE(CountAllValues(array, 0, end).has_value());
  EXPECT_EQ(pieces, 2);
  pieces = 0;
  EXPECT_TRUE(CollectPresentLabels(array, end).empty());
  EXPECT_EQ(pieces, 2);
}

TEST(Counts, OfLabelsAreThoseOfASet)
{
  std::mt19937 random(4);
  std::set<int> expected;
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfValues(Many);
  for (vtkIdType i = 0; i < Many; ++i)
  {
    const int label = static_cast<int>(random() % 2000) - 1000;
    expected.insert(label);
    array->SetValue(i, label);
  }
  array->SetValue(5, 0.5);
  array->SetValue(6, 3e9);
  array->SetValue(7, std::numeric_limits<double>::quiet_NaN());
  array->SetValue(Many - 1, 5000.0);
  expected.insert(5000);
  const std::vector<int> found = CollectPresentLabels(array, GoOn);
  EXPECT_EQ(found, std::vector<int>(expected.begin(), expected.end()));
  const std::vector<int> spread = CollectSpreadLabels(array);
  EXPECT_TRUE(std::is_sorted(spread.begin(), spread.end()));
  EXPECT_TRUE(std::includes(expected.begin(), expected.end(), spread.begin(), spread.end()));
  EXPECT_GT(spread.size(), 1000U);
}

TEST(ValueName, IsWhatValuesMeanAndNotWhoHasReadThem)
{
  EXPECT_EQ(NameValues(nullptr), "Value");
  vtkNew<vtkIntArray> values;
  EXPECT_EQ(NameValues(values), "Value");
  values->SetName("density");
  EXPECT_EQ(NameValues(values), "density");
  values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "HU");
  EXPECT_EQ(NameValues(values), "density (HU)");
  values->SetName("HU");
  EXPECT_EQ(NameValues(values), "HU");
  values->SetName("MetaImage"); // the name that vtkMetaImageReader sets
  EXPECT_EQ(NameValues(values), "HU");
  values->GetInformation()->Remove(vtkDataArray::UNITS_LABEL());
  EXPECT_EQ(NameValues(values), "Value");
}
