// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that labels are read as they were stored, for all types and layouts. The expected values
 * are the numbers that the test stores, and textbook trilinear weights.
 */

#include "Core/Field/LabelView.h"
#include "Rigs/TestVolume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace coretest;

namespace
{
/// Returns a label that varies differently along each axis: 0 to 120 for unsigned types, -60 to 60
/// for the others.
std::int64_t LabelAt(ScalarType type, std::int64_t i, std::int64_t j, std::int64_t k)
{
  const bool isUnsigned = type == ScalarType::UInt8 || type == ScalarType::UInt16 ||
    type == ScalarType::UInt32 || type == ScalarType::UInt64;
  const std::int64_t label = (7 * i + 11 * j + 23 * k) % 121;
  return isUnsigned ? label : label - 60;
}

TestVolume MakeLabels(ScalarType type, std::int64_t step)
{
  TestVolume volume(type, { 5, 6, 7 }, step);
  WithSampleType(type,
    [&](auto t)
    {
      volume.Fill<decltype(t)>(
        [&](std::int64_t i, std::int64_t j, std::int64_t k) { return LabelAt(type, i, j, k); });
    });
  return volume;
}

/// Returns the sum of a label's weights in a cell.
double FractionOf(const LabelCell& cell, std::int64_t label)
{
  if (cell.IsUniform)
  {
    return cell.Label[0] == label ? 1.0 : 0.0;
  }
  double sum = 0.0;
  for (int c = 0; c < LabelCell::Corners; ++c)
  {
    sum += cell.Label[c] == label ? cell.Fraction[c] : 0.0;
  }
  return sum;
}
} // namespace

TEST(LabelView, HasEveryTypeAndStride)
{
  for (const ScalarType type : AllScalarTypes)
  {
    for (const std::int64_t step : { 1, 3 })
    {
      const TestVolume volume = MakeLabels(type, step);
      const LabelView view(volume.View);
      for (std::int64_t at = 0; at < 5 * 6 * 7; ++at)
      {
        const std::int64_t i = at % 5;
        const std::int64_t j = at / 5 % 6;
        const std::int64_t k = at / 30;
        const Vector3 index{ i + 0.3, j - 0.4, k + 0.2 };
        EXPECT_EQ(view.Nearest(index), LabelAt(type, i, j, k))
          << "type " << static_cast<int>(type) << ", step " << step;
      }
    }
  }
}

TEST(LabelView, FractionsAreTrilinear)
{
  const TestVolume volume = MakeLabels(ScalarType::Int16, 1);
  const LabelView view(volume.View);
  const LabelCell cell = view.Cell({ 2.25, 3.5, 4.125 });
  ASSERT_FALSE(cell.IsUniform);
  for (int c = 0; c < 8; ++c)
  {
    const int i = c & 1;
    const int j = (c >> 1) & 1;
    const int k = c >> 2;
    const double share = (i ? 0.25 : 0.75) * 0.5 * (k ? 0.125 : 0.875);
    EXPECT_NEAR(FractionOf(cell, LabelAt(ScalarType::Int16, 2 + i, 3 + j, 4 + k)), share, 1e-15);
  }
}

TEST(LabelView, FadesToNoLabelWithinAVoxelBeyondTheImage)
{
  TestVolume volume(ScalarType::UInt8, { 4, 4, 4 });
  volume.Fill<std::uint8_t>([](std::int64_t, std::int64_t, std::int64_t) { return 9; });
  const LabelView view(volume.View);
  EXPECT_DOUBLE_EQ(FractionOf(view.Cell({ 1.5, 1.5, 1.5 }), 9), 1.0);
  EXPECT_DOUBLE_EQ(FractionOf(view.Cell({ 3.0, 3.0, 3.0 }), 9), 1.0);
  EXPECT_DOUBLE_EQ(FractionOf(view.Cell({ 3.25, 1.0, 1.0 }), 9), 0.75);
  EXPECT_DOUBLE_EQ(FractionOf(view.Cell({ -0.75, 1.0, 1.0 }), 9), 0.25);
  EXPECT_DOUBLE_EQ(FractionOf(view.Cell({ -0.5, 3.5, 1.0 }), 9), 0.25);
  const double huge = std::numeric_limits<double>::max();
  for (const double x : { -1.0, 4.0, 1e30, -huge, huge, HUGE_VAL, -HUGE_VAL, std::nan("") })
  {
    const LabelCell cell = view.Cell({ 1.0, x, 1.0 });
    EXPECT_TRUE(cell.IsUniform);
    EXPECT_EQ(cell.Label[0], NoLabel) << x;
    EXPECT_EQ(view.Nearest({ x, 1.0, 1.0 }), NoLabel) << x;
  }
}

TEST(LabelView, AnUnsignedLabelThatIsTooLargeIsNone)
{
  TestVolume volume(ScalarType::UInt64, { 2, 2, 2 });
  volume.Fill<std::uint64_t>([](std::int64_t i, std::int64_t, std::int64_t)
    { return i == 0 ? 0x8000000000000001U : 0x7FFFFFFFFFFFFFFFU; });
  const LabelView view(volume.View);
  EXPECT_EQ(view.Nearest({ 0, 0, 0 }), NoLabel);
  EXPECT_EQ(view.Nearest({ 1, 0, 0 }), std::numeric_limits<std::int64_t>::max());
}
