// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares masks with their definition.
 */

#include "Core/Math/PolylineMask.h"
#include "PolylineChecks.h"

using namespace coretest;

namespace
{
/// Returns a function with the values 0, 1 and 2, and with steps and ramps between them.
Polyline Levels(std::mt19937_64& engine)
{
  Polyline line = RandomLine(engine, -3.0, 6.0, 1 + int(engine() % 12));
  for (Vertex& v : line)
  {
    v.Y = double(engine() % 3);
  }
  return line;
}
} // namespace

TEST(PolylineMask, IsOneWhereTheFunctionIsAboveTheFloor)
{
  std::mt19937_64 engine(1);
  for (int trial = 0; trial < 300; ++trial)
  {
    SCOPED_TRACE(trial);
    const Polyline line = Levels(engine);
    const Polyline mask = MaskAbove(line, 0.001, 2.0);
    std::array<Polyline, 5> lines;
    lines.fill(line);
    for (const double x : Arguments(lines, engine))
    {
      const double value = Evaluate(line, x);
      // Skip values just above the floor: on a ramp that starts below the floor, the mask may be 1
      // from the ramp's first point on. Near an argument of 0, such a value is rounded to 0.
      if (value > 0.001 || (value == 0.0 && (x == 0.0 || std::isnormal(x))))
      {
        EXPECT_EQ(Evaluate(mask, 2.0 * x), value > 0.001 ? 1.0 : 0.0) << x;
      }
    }
  }
}

TEST(PolylineMask, ACutFunctionRisesToWhatItWas)
{
  std::mt19937_64 engine(2);
  for (int trial = 0; trial < 300; ++trial)
  {
    SCOPED_TRACE(trial);
    const Polyline line = Levels(engine);
    std::uniform_real_distribution<double> place(-4.0, 7.0);
    const double from = place(engine);
    const double to = from + 0.5;
    const Polyline cut = CutBelow(line, from, to);
    const double value = Evaluate(line, to);
    std::array<Polyline, 5> lines;
    lines.fill(line);
    for (const double x : Arguments(lines, engine))
    {
      const double expected = x <= from ? 0.0
        : x < to                        ? value * (x - from) / (to - from)
                                        : Evaluate(line, x);
      EXPECT_NEAR(Evaluate(cut, x), expected, 1e-9) << x;
    }
  }
}
