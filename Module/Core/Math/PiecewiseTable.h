// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Several piecewise-linear functions of one variable, baked for lookup in constant time.
 *
 * A table merges the break points of its channels, so that one search serves all of them: a lookup
 * by the scalar value returns the whole material (stiffness, friction, surface strength,
 * viscosity). Between break points a channel is exactly linear, and a step remains a step, because
 * nothing is resampled to a grid. A piecewise-linear function is therefore reproduced to rounding,
 * however steep it is.
 */
#ifndef PiecewiseTable_h
#define PiecewiseTable_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace VolumeHaptics
{

/**
 * A vertex of a piecewise-linear function. Two vertices with the same X make a step; at this X, the
 * function has the first vertex's value. Outside the vertices, it has the value of the nearest one.
 */
struct Vertex
{
  double X;
  double Y;
};

/** A piecewise-linear function: vertices in ascending order of X, at least one. */
using Polyline = std::vector<Vertex>;

struct ValueRange
{
  double Low;
  double High;
};

/** Returns whether two functions have the same vertices. */
inline bool IsSameLine(const Polyline& a, const Polyline& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const Vertex& v, const Vertex& w) { return v.X == w.X && v.Y == w.Y; });
}

/** Makes a constant function. */
inline Polyline ConstantPolyline(double value)
{
  return { { 0.0, value } };
}

template <int Channels>
class PiecewiseTable
{
public:
  using Values = std::array<double, Channels>;

  PiecewiseTable();
  explicit PiecewiseTable(const std::array<Polyline, Channels>& functions);

  /**
   * A segment of all channels. For x above Begin and up to the Begin of the next segment in memory,
   * a channel is Value + Slope (x - Begin).
   */
  struct Segment
  {
    double Begin;
    double Value[Channels];
    double Slope[Channels];
  };

  /** Returns all channels at x, which must not be NaN. */
  Values operator()(double x) const noexcept
  {
    return Evaluate(*this->FindSegment(x), x, std::make_index_sequence<Channels>());
  }
  /** Returns the segment that contains x, which must not be NaN. */
  const Segment* FindSegment(double x) const noexcept
  {
    const double position = (x - this->Low) * this->BinsPerUnit;
    const int bin =
      position > 0.0 ? static_cast<int>(std::min(position, static_cast<double>(Bins - 1))) : 0;
    const Segment* found = this->Segments.data() + this->FirstSegment[bin];
    if (this->IsCrowded)
    {
      found = this->Bisect(x, bin);
    }
    // The last segment begins at infinity, so the loop ends there.
    while (x > found[1].Begin)
    {
      ++found;
    }
    return found;
  }

  /** Returns the smallest and the largest value of a channel. */
  const ValueRange& GetRange(int channel) const noexcept { return this->Range[channel]; }

  /** Return the address and the size (bytes) of the memory that a lookup reads. */
  const void* GetMemory() const noexcept { return this->Segments.data(); }
  std::size_t GetMemorySize() const noexcept
  {
    return sizeof(*this) + this->Segments.capacity() * sizeof(Segment);
  }

private:
  /** Evaluates all channels, without a loop, so that the values stay in registers. */
  template <std::size_t... Channel>
  static Values Evaluate(const Segment& segment, double x, std::index_sequence<Channel...>) noexcept
  {
    return { { segment.Value[Channel] + segment.Slope[Channel] * (x - segment.Begin)... } };
  }
  /** Finds the segment that contains x in a bin with many break points. */
  const Segment* Bisect(double x, int bin) const noexcept;

  static constexpr int Bins = 1024;
  /** Largest number of break points in a bin for a linear search. */
  static constexpr int MostInBin = 4;

  std::vector<Segment> Segments;
  /** For each bin, the first segment in it or an earlier one. */
  std::array<std::uint32_t, Bins> FirstSegment{};
  bool IsCrowded = false;
  double Low = 0.0;
  double BinsPerUnit = 0.0;
  std::array<ValueRange, Channels> Range{};
};

/** Table of stiffness, friction, surface strength, viscosity and visibility by the scalar value. */
using MaterialTable = PiecewiseTable<5>;
/** Table of distinctness and visibility (0 or 1) by the gradient magnitude. */
using DistinctnessTable = PiecewiseTable<2>;

extern template class PiecewiseTable<2>;
extern template class PiecewiseTable<5>;

} // namespace VolumeHaptics

#endif
