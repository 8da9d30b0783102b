// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/PiecewiseTable.h"

#include <cmath>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

/** Value and slope of a polyline between x and the next vertex. */
struct Line
{
  double Value;
  double Slope;
};

Line LineRightOf(const Polyline& line, double x)
{
  const auto after = std::upper_bound(
    line.begin(), line.end(), x, [](double value, const Vertex& v) { return value < v.X; });
  if (after == line.begin())
  {
    return { line.front().Y, 0.0 };
  }
  const Vertex& before = *(after - 1);
  if (after == line.end())
  {
    return { before.Y, 0.0 };
  }
  double slope = (after->Y - before.Y) / (after->X - before.X);
  if (!std::isfinite(slope))
  {
    slope = 0.0; // a step: doubles can't distinguish the vertices
  }
  return { before.Y + slope * (x - before.X), slope };
}

} // namespace

template <int Channels>
PiecewiseTable<Channels>::PiecewiseTable()
  : PiecewiseTable(
      []
      {
        std::array<Polyline, Channels> zero;
        zero.fill(ConstantPolyline(0.0));
        return zero;
      }())
{
}

template <int Channels>
PiecewiseTable<Channels>::PiecewiseTable(const std::array<Polyline, Channels>& functions)
{
  std::vector<double> breaks;
  for (int c = 0; c < Channels; ++c)
  {
    const Polyline& line = functions[c];
    const auto [low, high] = std::minmax_element(
      line.begin(), line.end(), [](const Vertex& a, const Vertex& b) { return a.Y < b.Y; });
    this->Range[c] = { low->Y, high->Y };
    std::transform(
      line.begin(), line.end(), std::back_inserter(breaks), [](const Vertex& v) { return v.X; });
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());

  this->Segments.reserve(breaks.size() + 2);
  // The leftmost segment is constant, so that it does not matter where it begins.
  Segment leftmost{ std::numeric_limits<double>::lowest(), {}, {} };
  for (int c = 0; c < Channels; ++c)
  {
    leftmost.Value[c] = functions[c].front().Y;
  }
  this->Segments.push_back(leftmost);
  for (const double x : breaks)
  {
    Segment segment{ x, {}, {} };
    for (int c = 0; c < Channels; ++c)
    {
      const Line line = LineRightOf(functions[c], x);
      segment.Value[c] = line.Value;
      segment.Slope[c] = line.Slope;
    }
    this->Segments.push_back(segment);
  }
  this->Segments.push_back({ std::numeric_limits<double>::infinity(), {}, {} });

  this->Low = breaks.front();
  const double width = breaks.back() - this->Low;
  this->BinsPerUnit = width > 0.0 ? Bins / width : 0.0;
  std::uint32_t segment = 0;
  for (int bin = 0; bin < Bins; ++bin)
  {
    // Begin half a bin earlier, because rounding may assign a value to the next bin.
    const double edge = this->Low + width * (bin - 0.5) / Bins;
    const std::uint32_t first = segment;
    while (edge > this->Segments[segment + 1].Begin)
    {
      ++segment;
    }
    this->FirstSegment[bin] = segment;
    this->IsCrowded = this->IsCrowded || segment - first > MostInBin;
  }
  const std::size_t rest = this->Segments.size() - 2 - segment;
  this->IsCrowded = this->IsCrowded || rest > MostInBin;
}

template <int Channels>
auto PiecewiseTable<Channels>::Bisect(double x, int bin) const noexcept -> const Segment*
{
  const Segment* const all = this->Segments.data();
  const Segment* const first = all + this->FirstSegment[bin];
  const Segment* const last =
    bin + 2 < Bins ? all + this->FirstSegment[bin + 2] : all + this->Segments.size() - 2;
  // The first segment begins before x, so the search may begin after it.
  const Segment* const after = std::lower_bound(first + 1, last + 1, x,
    [](const Segment& segment, double value) { return segment.Begin < value; });
  return after - 1;
}

template class PiecewiseTable<2>;
template class PiecewiseTable<5>;

} // namespace VolumeHaptics
