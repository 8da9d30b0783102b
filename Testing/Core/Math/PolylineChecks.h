// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Evaluates piecewise-linear functions in the simplest way, and compares the results with the baked
 * table.
 */
#ifndef PolylineChecks_h
#define PolylineChecks_h

#include "Core/Math/PiecewiseTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coretest
{
using namespace VolumeHaptics;

/// Evaluates the function as documented: at a step it has the left value, and outside the vertices
/// it has the end values.
inline double Evaluate(const Polyline& line, double x)
{
  if (x <= line.front().X)
  {
    return line.front().Y;
  }
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    if (x <= line[i].X)
    {
      const long double fraction = (static_cast<long double>(x) - line[i - 1].X) /
        (static_cast<long double>(line[i].X) - line[i - 1].X);
      return static_cast<double>(line[i - 1].Y + fraction * (line[i].Y - line[i - 1].Y));
    }
  }
  return line.back().Y;
}

/// Returns the arguments to test: break points, their neighbours, the middles between them, and
/// random numbers.
inline std::vector<double> Arguments(const std::array<Polyline, 5>& lines, std::mt19937_64& engine)
{
  std::vector<double> breaks;
  for (const Polyline& line : lines)
  {
    for (const Vertex& v : line)
    {
      breaks.push_back(v.X);
    }
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> arguments = breaks;
  const double width = breaks.back() - breaks.front();
  std::uniform_real_distribution<double> fraction(-0.1, 1.1);
  for (std::size_t i = 0; i < breaks.size(); ++i)
  {
    arguments.push_back(std::nextafter(breaks[i], -HUGE_VAL));
    arguments.push_back(std::nextafter(breaks[i], HUGE_VAL));
    arguments.push_back(breaks[i] / 2.0 + breaks[(i + 1) % breaks.size()] / 2.0);
    arguments.push_back(breaks.front() + fraction(engine) * width);
  }
  arguments.insert(arguments.end(), { -1e308, 1e308, 0.0 });
  return arguments;
}

inline void ExpectExact(const std::array<Polyline, 5>& lines, std::mt19937_64& engine)
{
  const MaterialTable table(lines);
  for (const double x : Arguments(lines, engine))
  {
    const MaterialTable::Values values = table(x);
    for (int c = 0; c < 5; ++c)
    {
      const ValueRange& range = table.GetRange(c);
      const double size = std::max(std::abs(range.Low), std::abs(range.High));
      EXPECT_NEAR(values[c], Evaluate(lines[c], x), 1e-12 * size) << "channel " << c << " at " << x;
    }
  }
}

inline Polyline RandomLine(std::mt19937_64& engine, double low, double width, int vertices)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Polyline line(vertices);
  for (Vertex& v : line)
  {
    // Half of the break points are on a grid of 1/64, so that functions have common break points
    // and steps.
    const double fraction =
      uniform(engine) < 0.5 ? std::floor(64.0 * uniform(engine)) / 64.0 : uniform(engine);
    v = { low + fraction * width, 2000.0 * uniform(engine) };
  }
  std::sort(line.begin(), line.end(), [](const Vertex& a, const Vertex& b) { return a.X < b.X; });
  return line;
}
} // namespace coretest

#endif
