// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/PolylineMask.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace VolumeHaptics
{
Polyline MaskAbove(const Polyline& line, double floor, double scale)
{
  const auto isAbove = [floor](const Vertex& v) { return v.Y > floor; };
  const auto flag = [](bool above) { return above ? 1.0 : 0.0; };
  Polyline mask{ { line.front().X, flag(isAbove(line.front())) } };
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    const Vertex& a = line[i - 1];
    const Vertex& b = line[i];
    if (!(a.X < b.X))
    {
      continue;
    }
    const bool above = isAbove(a) || isAbove(b);
    mask.push_back({ a.X, flag(above) });
    if (above && !isAbove(b))
    {
      // The polyline falls to the floor at the vertex itself.
      const double before = std::nextafter(b.X, a.X);
      mask.push_back({ before, 1.0 });
      mask.push_back({ before, 0.0 });
    }
    mask.push_back({ b.X, flag(above && isAbove(b)) });
  }
  mask.push_back({ line.back().X, flag(isAbove(line.back())) });
  for (Vertex& vertex : mask)
  {
    vertex.X *= scale;
  }
  return mask;
}

Polyline CutBelow(const Polyline& line, double from, double to)
{
  const auto above = std::upper_bound(
    line.begin(), line.end(), to, [](double x, const Vertex& vertex) { return x < vertex.X; });
  double value = above == line.begin() ? line.front().Y : std::prev(above)->Y;
  if (above != line.begin() && above != line.end())
  {
    const Vertex& a = *std::prev(above);
    value += (to - a.X) / (above->X - a.X) * (above->Y - a.Y);
  }
  Polyline cut{ { from, 0.0 }, { to, value } };
  cut.insert(cut.end(), above, line.end());
  return cut;
}

} // namespace VolumeHaptics
