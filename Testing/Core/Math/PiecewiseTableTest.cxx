// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that the baked table equals the piecewise-linear function, whatever the positions of its
 * break points are.
 */

#include "PolylineChecks.h"

using namespace coretest;

TEST(PiecewiseTable, LinearPiecesAndStepsAreExact)
{
  for (int seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937_64 engine(seed);
    const double width = std::pow(10.0, seed % 13 - 6);
    std::array<Polyline, 5> lines;
    for (Polyline& line : lines)
    {
      line = RandomLine(engine, (seed % 3 - 1) * 3.0 * width, width, 1 + int(engine() % 30));
    }
    ExpectExact(lines, engine);
  }
}

TEST(PiecewiseTable, AtAStepTheLeftValueHolds)
{
  const Polyline step = { { 0.0, 1.0 }, { 5.0, 1.0 }, { 5.0, 7.0 }, { 5.0, 3.0 }, { 9.0, 3.0 } };
  const PiecewiseTable<2> table({ step, ConstantPolyline(4.0) });
  EXPECT_EQ(table(5.0), (PiecewiseTable<2>::Values{ 1.0, 4.0 }));
  EXPECT_EQ(table(std::nextafter(5.0, 9.0))[0], 3.0);
  EXPECT_EQ(table.GetRange(0).High, 7.0);
  EXPECT_EQ(table.GetRange(0).Low, 1.0);
}

TEST(PiecewiseTable, CrowdedBreakPointsAreFoundAllTheSame)
{
  // Put thousands of break points into one bin of the lookup table: at the beginning, in the middle
  // and at the end of a line with distant break points.
  std::mt19937_64 engine(4);
  for (const double at : { 0.0, 1e-3, 0.5, 1.0 })
  {
    std::array<Polyline, 5> lines;
    lines.fill({ { 0.0, 3.0 }, { 1e6, 5.0 } });
    lines[1] = RandomLine(engine, at * (1e6 - 1e-4), 1e-4, 3000);
    lines[3] = RandomLine(engine, at * (1e6 - 1.0), 1.0, 100);
    ExpectExact(lines, engine);
  }
}

TEST(PiecewiseTable, HugeAndTinyRanges)
{
  std::mt19937_64 engine(6);
  std::array<Polyline, 5> lines;
  lines.fill(ConstantPolyline(2.5));
  ExpectExact(lines, engine);
  lines[0] = { { -1e300, 10.0 }, { 1e300, 30.0 } };
  lines[1] = { { -1e-300, 0.0 }, { 1e-300, 1.0 } };
  lines[2] = { { 1000.0, 0.0 }, { std::nextafter(1000.0, 2000.0), 1e9 } };
  ExpectExact(lines, engine);
  lines[3] = { { 17.0, 1.0 }, { 17.0, 2.0 } };
  ExpectExact(lines, engine);
}

TEST(PiecewiseTable, EmptyTableIsZero)
{
  EXPECT_EQ(PiecewiseTable<2>()(12.0), (PiecewiseTable<2>::Values{ 0.0, 0.0 }));
}
