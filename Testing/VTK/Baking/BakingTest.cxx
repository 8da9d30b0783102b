// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the error bound of baking that vtkHapticProperty documents: for every vtkPiecewiseFunction,
 * linear pieces and steps are exact, and curved pieces are exact within 0.01 % of the piece's
 * height.
 */

#include "Rigs/RandomFunctions.h"
#include "VTK/Material/HapticFunctions.h"

#include <gtest/gtest.h>

#include <vtkNew.h>

using namespace apitest;

namespace
{
void ExpectWithinBound(vtkPiecewiseFunction* function, std::mt19937_64& engine)
{
  const VolumeHaptics::PiecewiseTable<2> table(
    { VolumeHaptics::ToPolyline(function, 7.0), VolumeHaptics::ConstantPolyline(1.0) });
  for (const double x : ArgumentsOf(function, engine))
  {
    const auto [low, high] = ValuesAround(function, x);
    const double allowed = AllowedError(function, x);
    ASSERT_TRUE(low - allowed <= table(x)[0] && table(x)[0] <= high + allowed)
      << table(x)[0] << " instead of " << function->GetValue(x) << " at " << x << ", allowed "
      << allowed;
  }
}

class Baking : public testing::TestWithParam<Shape>
{
};

std::vector<Shape> Shapes()
{
  std::vector<Shape> shapes;
  for (const double sharpness :
    { 0.0, 0.009, 0.011, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.989, 0.991, 1.0, -1.0 })
  {
    for (const bool clamping : { true, false })
    {
      for (const bool duplicates : { true, false })
      {
        shapes.push_back({ sharpness, duplicates, clamping, false });
        shapes.push_back({ sharpness, duplicates, clamping, true });
      }
    }
  }
  return shapes;
}
} // namespace

TEST_P(Baking, StaysWithinTheDocumentedBound)
{
  for (int seed = 0; seed < 40; ++seed)
  {
    std::mt19937_64 engine(seed);
    const bool log = this->GetParam().LogScale;
    const double width = std::pow(10.0, seed % 5 - 1);
    const double low = log ? 1e-3 + width * (seed % 3) : width * (seed % 3 - 1.5);
    const double height = seed % 4 == 0 ? 1e6 : 1000.0;
    const auto function = RandomFunction(engine, this->GetParam(), low, width, height);
    SCOPED_TRACE(testing::Message()
      << "seed " << seed << " sharpness " << this->GetParam().Sharpness << " log " << log
      << " clamping " << this->GetParam().Clamping << " duplicates "
      << this->GetParam().Duplicates);
    ASSERT_NO_FATAL_FAILURE(ExpectWithinBound(function, engine));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Baking, testing::ValuesIn(Shapes()));

TEST(BakingOf, DuplicateScalarsIsAStepAtTheNode)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AllowDuplicateScalarsOn();
  function->AddPoint(0.0, 1.0);
  function->AddPoint(5.0, 2.0);
  function->AddPoint(5.0, 8.0);
  function->AddPoint(9.0, 8.0);
  const VolumeHaptics::PiecewiseTable<2> table(
    { VolumeHaptics::ToPolyline(function, 0.0), VolumeHaptics::ConstantPolyline(1.0) });
  EXPECT_NEAR(table(std::nextafter(5.0, 0.0))[0], 2.0, 1e-15);
  // VTK 9.1 returns 2 at a duplicate node, and VTK 9.3 returns 8. The table must return the value
  // of the installed VTK.
  EXPECT_EQ(table(5.0)[0], function->GetValue(5.0));
  EXPECT_EQ(table(std::nextafter(5.0, 9.0))[0], 8.0);
  EXPECT_NEAR(table(2.5)[0], 1.5, 1e-15);
}

TEST(BakingOf, NoPointsMeansTheDefault)
{
  const VolumeHaptics::Polyline missing = VolumeHaptics::ToPolyline(nullptr, 7.0);
  vtkNew<vtkPiecewiseFunction> empty;
  for (const VolumeHaptics::Polyline& line : { missing, VolumeHaptics::ToPolyline(empty, 7.0) })
  {
    ASSERT_EQ(line.size(), 1U);
    EXPECT_EQ(line[0].Y, 7.0);
  }
}

TEST(BakingOf, SmoothMaterialsStaySmall)
{
  // Each of the four material functions has three smooth bumps, and no two functions share a break
  // point. The table must take less than 900 kB, so that the model stays below 1 MiB with the
  // kernel's table (by default a tenth as large).
  std::array<VolumeHaptics::Polyline, 5> lines;
  lines.fill(VolumeHaptics::ConstantPolyline(1.0));
  for (int f = 0; f < 4; ++f)
  {
    vtkNew<vtkPiecewiseFunction> function;
    for (int i = 0; i < 7; ++i)
    {
      function->AddPoint(100.0 * i + f, i % 2 ? 1000.0 : 0.0, 0.5, 0.5);
    }
    lines[f] = VolumeHaptics::ToPolyline(function, 0.0);
  }
  EXPECT_LT(VolumeHaptics::MaterialTable(lines).GetMemorySize(), 900000U);
}
